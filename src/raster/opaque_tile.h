// The opaque surfaces of a tile, sample by sample.
#pragma once

#include <cstdint>
#include <limits>

#include "geometry/tile_grid.h"
#include "support/aligned.h"

namespace sheer {

// Sample s of pixel p (row * kTileSize + column) is element p * samples + s.
struct OpaqueTile {
    int samples = 0;
    bool any = false;           // false: nothing opaque here, and the arrays hold nothing
    AlignedArray<float> depth;  // infinity where nothing opaque is
    AlignedArray<std::uint32_t> primitive;
    AlignedArray<float> red, green, blue;

    OpaqueTile() = default;
    // The arrays are made only for scenes that have opaque surfaces.
    OpaqueTile(int samples_per_pixel, bool scene_has_opaque) : samples(samples_per_pixel)
    {
        if (!scene_has_opaque) return;
        const int size = kTilePixels * samples;
        depth = AlignedArray<float>(size);
        primitive = AlignedArray<std::uint32_t>(size);
        red = AlignedArray<float>(size);
        green = AlignedArray<float>(size);
        blue = AlignedArray<float>(size);
    }

    void clear()
    {
        any = true;
        std::fill_n(depth.data(), depth.size(), std::numeric_limits<float>::infinity());
    }
};

}  // namespace sheer
