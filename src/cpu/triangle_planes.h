// Weights and depth of a triangle as functions of the pixel, relative to a tile.
#pragma once

#include <cstdint>

#include "geometry/tile_grid.h"
#include "geometry/triangles.h"
#include "raster/depth_plane.h"

namespace sheer {

// The barycentric weight of one vertex. At the centre of the tile's pixel (column, row) it is
// (edge + edge_x column + edge_y row) / area in wrapping 32-bit integers where
// TrianglePlanes::exact, else base + pixel_x column + pixel_y row.
struct WeightPlane {
    std::int32_t edge, edge_x, edge_y;
    float base, pixel_x, pixel_y;
    float dx, dy;  // a subpixel to the right and down
};

struct TrianglePlanes {
    // Integers lose nothing, which slivers need: their weights are small differences of large
    // terms. Triangles so large that their edge functions leave 32 bits don't need it.
    bool exact;
    bool affine;  // the three w are equal: no perspective
    float inverse_area;
    WeightPlane weight1, weight2;
    float depth0, depth1, depth2;  // at vertex 0, and what vertices 1 and 2 add
    DepthPlane depth;
    float inverse_w[3];
};

// `rect`: the tile's pixels in the picture.
void make_triangle_planes(const Triangle& t, const PixelRect& rect, bool orthographic,
                          TrianglePlanes& planes);

}  // namespace sheer
