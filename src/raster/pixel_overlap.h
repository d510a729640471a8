// Conservative rasterisation: which pixels triangles touch, and how much of each they have.
#pragma once

#include "geometry/tile_grid.h"
#include "geometry/triangles.h"
#include "raster/coverage_list.h"
#include "raster/sample_set.h"

namespace sheer {

// What a triangle has of a pixel.
struct PixelOverlap {
    double part;  // of its area, in [0, 1]
    double x, y;  // the centroid of that part, from the pixel's centre, in 1/256 pixel
};

// Parts below are none: what rounding makes of a triangle that ends at the pixel's edge is less.
inline constexpr double kLeastOverlap = 1e-6;

// Of pixel (x, y) of the picture, to rounding of doubles.
PixelOverlap overlap_of(const Triangle& triangle, int x, int y);

// All samples of each pixel that the triangle touches. `region`: pixels of the picture; `tile_x`,
// `tile_y`: the tile's first pixel. With `counts` the parts become those of `list.overlaps`, else
// these are 1.
struct ConservativeCover {
    const SampleSet& set;
    PixelRect region;
    int tile_x, tile_y;
    bool counts;
};
void cover_touched(const Triangle& triangle, const ConservativeCover& cover, CoverageList& list);

}  // namespace sheer
