// Where coverage goes: the pixels that triangles cover, and the samples they cover in each.
#pragma once

#include <cstdint>

#include "geometry/tile_grid.h"

namespace sheer {

// Arrays with room for a tile's pixels and a vector past `count`.
struct CoverageList {
    std::uint32_t* pixel;  // row * kTileSize + column in the tile
    std::uint32_t* low;    // samples 0 to 31: bit i
    std::uint32_t* high;   // samples 32 to 63; written where there are so many
    int count;

    std::uint64_t samples(int i) const
    {
        return low[i] | static_cast<std::uint64_t>(high[i]) << 32;
    }
};

}  // namespace sheer
