// What a primitive's vertices are joined to: plain lists of triangles, lines or points.
#pragma once

#include <cstdint>
#include <vector>

#include <sheer/scene.h>

#include "scene/topology.h"

namespace sheer::gltf {

// glTF 2.0, mesh.primitive.mode.
enum class Mode { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

Topology topology_of(Mode mode);

// The triangles, lines or points that the indices stand for, one after another. Vertices at the end
// that make no whole one are left out.
std::vector<std::uint32_t> plain_indices(Mode mode, const std::vector<std::uint32_t>& indices);

// Leaves out the vertices that nothing uses: exporters share one big vertex array between
// primitives.
void drop_unused_vertices(Mesh& mesh);

}  // namespace sheer::gltf
