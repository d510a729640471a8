// Tangents for normal textures, where a mesh has none (docs/numerics.md, "Shading").
#pragma once

#include <cstddef>
#include <vector>

#include <sheer/scene.h>

namespace sheer {

// One for each position: unit length, or zero where the
// triangles around have no direction of u. `set`: of texture coordinates, which the mesh has.
std::vector<Float4> make_tangents(const Mesh& mesh, std::size_t set);

}  // namespace sheer
