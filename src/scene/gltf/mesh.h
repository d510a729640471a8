// Meshes: one Mesh of the scene for each glTF primitive that is not another's with other material.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/gltf/import.h"
#include "scene/gltf/skin.h"

namespace sheer::gltf {

struct Shape {
    std::span<const double> weights = {};  // of the morph targets; none: the base shape
    const Skin* skin = nullptr;            // where it is, the mesh is put into the world
    bool mirrored = false;                 // the world's front of a skinned mesh is its back
};

// A primitive, as Object names it.
struct Part {
    std::uint32_t mesh;
    std::optional<std::uint32_t> material;
    std::optional<std::string> mesh_name;
};

// The mesh's primitives, in order, appended to the scene's meshes where these have not the same
// already. Primitives with nothing to draw are left out.
std::vector<Part> read_mesh(Import& import, const Value& mesh, const Shape& shape);

}  // namespace sheer::gltf
