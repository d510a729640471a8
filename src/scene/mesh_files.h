// What the readers of files with bare meshes share: OBJ, PLY, STL and hair.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <sheer/scene.h>

namespace sheer {

// Throws Error with Fault::input, "<path>: <what>".
[[noreturn]] void fail_in_file(const std::string& path, const std::string& what);

// The file's name without folder and suffix: what is in a file that names nothing is called so.
std::string name_of_file(const std::string& path);

// For what has no material of its own: light grey, dark grey for lines and points, which are too
// thin to show as light ones, or white where the vertices have colours; seen from both sides, since
// such files do not care which way triangles turn.
Material plain_material(const std::string& name, bool colored_vertices, Topology topology);

// Vertex colours stand in files as in pictures, encoded as sRGB. Values outside of [0, 1] and NaN
// are clamped.
float linear_color(double encoded);

// Adds the mesh, and one object of its name that places it where it is.
void place_mesh(Scene& scene, Mesh mesh);

}  // namespace sheer
