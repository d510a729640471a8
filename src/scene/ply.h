// Meshes, lines and point clouds in PLY files: text, or binary of either byte order.
//
// Turk. The PLY Polygon File Format. 1994.
#pragma once

#include <string>

#include <sheer/scene.h>

#include "support/read_file.h"

namespace sheer {

// Of the element `vertex` positions, normals, colours (sRGB, of any type, with or without alpha)
// and texture coordinates (v going up, as their writers have it) are read; `face` as polygons,
// `tristrips` as strips that -1 separates, `edge` as lines; where none of these gives anything, the
// vertices are points. Other elements and properties are skipped. Where an alpha is below 1 the
// material is AlphaMode::blend. Throws Error with Fault::input, "<path>: line <n>: <what>" or
// "<path>: byte <n>: <what>"; files of Gaussian splats are refused as not supported.
Scene read_ply(const std::string& path, const Bytes& content);

}  // namespace sheer
