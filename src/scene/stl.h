// Triangle meshes in STL files, binary or text.
//
// 3D Systems. Stereolithography Interface Specification. 1988.
#pragma once

#include <string>

#include <sheer/sheer.h>

#include "support/read_file.h"

namespace sheer {

// Whether the size is the one that a binary file's count of triangles asks for. Text begins with
// "solid", but so do some binary files.
bool is_binary_stl(const Bytes& content);

// Corners in the same place become one vertex; the normals in the file are not looked at, surfaces
// are flat; nor are the colours that some programs put into a binary file's spare bytes. A text
// file has one mesh for each of its solids. Throws Error with Fault::input, "<path>: line <n>:
// <what>" or "<path>: byte <n>: <what>".
Scene read_stl(const std::string& path, const Bytes& content, const LoadOptions& options);
Scene read_stl(const std::string& path, const Bytes& content);

}  // namespace sheer
