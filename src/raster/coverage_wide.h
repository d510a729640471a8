#pragma once

#include "geometry/triangles.h"
#include "raster/coverage_list.h"
#include "raster/sample_set.h"
#include "geometry/tile_grid.h"

namespace sheer {

// Coverage in 64-bit integers, one pixel after the other, for triangles whose edges are too long
// for 32 bits. `region`: pixels of the picture; `tile_x`, `tile_y`: the tile's first pixel.
void cover_wide(const Triangle& triangle, const SampleSet& set, const PixelRect& region, int tile_x,
                int tile_y, CoverageList& list);

}  // namespace sheer
