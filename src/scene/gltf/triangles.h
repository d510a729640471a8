// Triangle lists, strips and fans made into triangle lists.
#pragma once

#include <cstdint>
#include <vector>

#include <sheer/scene.h>

namespace sheer::gltf {

// glTF 2.0, mesh.primitive.mode.
enum class Mode { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

// Vertices at the end that make no whole triangle are left out.
std::vector<std::uint32_t> triangulate(Mode mode, const std::vector<std::uint32_t>& indices);

// Leaves out the vertices that no triangle uses: exporters share one big vertex array between
// primitives.
void drop_unused_vertices(Mesh& mesh);

// Makes every normal one metre long. One that is zero or not finite becomes the sum of the normals
// of its triangles. How many were such.
std::size_t repair_normals(Mesh& mesh);

}  // namespace sheer::gltf
