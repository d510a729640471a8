// Meshes: one Mesh of the scene for each glTF primitive.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/gltf/import.h"
#include "scene/gltf/skin.h"

namespace sheer::gltf {

struct Shape {
    std::span<const double> weights = {};  // of the morph targets; none: the base shape
    const Skin* skin = nullptr;            // where it is, the mesh is put into the world
    bool mirrored = false;                 // the world's front of a skinned mesh is its back
};

// Appends the mesh's primitives to the scene's meshes; which these are, in order. Primitives with
// nothing to draw are left out.
std::vector<std::uint32_t> read_mesh(Import& import, const Value& mesh, const Shape& shape);

}  // namespace sheer::gltf
