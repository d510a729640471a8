// Which tiles a chunk's triangles touch.
#pragma once

#include "geometry/tile_grid.h"
#include "geometry/triangles.h"

namespace sheer {

// Fills in tile_begin and tile_triangles.
void bin_triangles(TriangleChunk& chunk, const TileGrid& grid, const SampleExtent& samples);

}  // namespace sheer
