// The opaque surfaces of a tile, sample by sample.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "raster/depth_plane.h"
#include "support/aligned.h"

namespace sheer {

struct OpaqueSurface {
    DepthPlane depth;
    std::uint32_t primitive;  // breaks ties in depth: the smaller is in front
};

// Sample s of pixel p (row * kTileSize + column) is element p * samples + s.
struct OpaqueTile {
    int samples = 0;
    bool any = false;                     // false: nothing opaque here, and the arrays hold nothing
    AlignedArray<float> depth;            // infinity where nothing opaque is
    AlignedArray<float> slack;            // of the depth: DepthPlane::slack
    AlignedArray<std::uint32_t> surface;  // index into surfaces
    AlignedArray<float> red, green, blue;
    std::vector<OpaqueSurface> surfaces;  // of the triangles drawn

    OpaqueTile() = default;
    // The arrays are made only for scenes that have opaque surfaces.
    OpaqueTile(int samples_per_pixel, bool scene_has_opaque) : samples(samples_per_pixel)
    {
        if (!scene_has_opaque) return;
        const int size = kTilePixels * samples;
        depth = AlignedArray<float>(size);
        slack = AlignedArray<float>(size);
        surface = AlignedArray<std::uint32_t>(size);
        red = AlignedArray<float>(size);
        green = AlignedArray<float>(size);
        blue = AlignedArray<float>(size);
    }

    void clear()
    {
        any = true;
        surfaces.clear();
        std::fill_n(depth.data(), depth.size(), std::numeric_limits<float>::infinity());
    }
};

}  // namespace sheer
