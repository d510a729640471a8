// The pixels of a tile that a triangle covers, and the samples it covers in each.
#pragma once

#include <cstdint>

#include "geometry/tile_grid.h"

namespace sheer {

struct CoverageList {
    static constexpr int kCapacity = kTilePixels + 16;  // one vector of slack

    int count = 0;
    alignas(64) std::uint32_t pixel[kCapacity] = {};  // row * kTileSize + column
    alignas(64) std::uint32_t low[kCapacity] = {};    // samples 0 to 31
    alignas(64) std::uint32_t high[kCapacity] = {};   // samples 32 to 63, where there are so many

    std::uint64_t samples(int i) const
    {
        return low[i] | static_cast<std::uint64_t>(high[i]) << 32;
    }
};

}  // namespace sheer
