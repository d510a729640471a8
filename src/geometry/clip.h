// Triangles that reach beyond the near or far plane or the guard band, cut to what is inside.
#pragma once

#include <array>

#include "geometry/pose.h"

namespace sheer {

struct ClippedVertex {
    PosedVertex posed;            // snapped
    std::array<float, 3> weight;  // of the source triangle's vertices, sum 1
};

struct ClippedPolygon {
    static constexpr int kMost = 9;  // a triangle and six planes
    std::array<ClippedVertex, kMost> vertices;
    int count = 0;  // 0: nothing is left
};

// A convex polygon that turns like the triangle. Two triangles that share an edge get the same new
// vertices on it, bit for bit.
ClippedPolygon clip_triangle(const PosedVertex& v0, const PosedVertex& v1, const PosedVertex& v2,
                             const ScreenMap& map);

}  // namespace sheer
