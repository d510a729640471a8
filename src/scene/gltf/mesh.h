// Meshes: one Mesh of the scene for each glTF primitive.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/gltf/import.h"

namespace sheer::gltf {

// Appends the mesh's primitives to the scene's meshes; which these are, in order. Primitives
// without triangles are left out.
std::vector<std::uint32_t> read_mesh(Import& import, const Value& mesh);

}  // namespace sheer::gltf
