// Where coverage goes: the pixels that triangles cover, and the samples they cover in each.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/tile_grid.h"

namespace sheer {

// Of triangles that are rasterised conservatively, for each pixel of a list: the part of it that
// the triangle has, which counts, and the centroid of that, from the pixel's centre in 1/256 pixel.
struct OverlapList {
    std::vector<float> part, x, y;
};

// Arrays with room for a tile's pixels and a vector past `count`.
struct CoverageList {
    std::uint32_t* pixel;  // row * kTileSize + column in the tile
    std::uint32_t* low;    // samples 0 to 31: bit i
    std::uint32_t* high;   // samples 32 to 63; written where there are so many
    int count;
    OverlapList* overlaps =
        nullptr;  // null: where samples are covered, and shaded at their centroid

    std::uint64_t samples(int i) const
    {
        return low[i] | static_cast<std::uint64_t>(high[i]) << 32;
    }
};

}  // namespace sheer
