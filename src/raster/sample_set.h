// A sample pattern with what coverage and centroids need of it at hand.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/triangles.h"
#include "raster/sample_pattern.h"

namespace sheer {

struct SampleSet {
    int count = 0;
    bool centered = false;  // all at the pixel's centre: a pixel is covered as a whole
    std::array<std::int32_t, kMaxSamples> x = {}, y = {};  // 1/256 pixel, from the top left corner
    SampleExtent extent;
    // Offsets from the pixel's centre, in pixels.
    alignas(64) std::array<float, kMaxSamples> offset_x = {}, offset_y = {};
    // position_sums[group][bits]: over the samples 4 group + i with bit i set, the sum of x in the
    // lower and of y in the upper half of the word.
    alignas(64) std::array<std::array<std::uint32_t, 16>, kMaxSamples / 4> position_sums = {};

    std::uint64_t all() const { return count == kMaxSamples ? ~0ull : (1ull << count) - 1; }
};

// In 1/256 pixel; what leaves the pixel on one side comes back on the other.
struct SubpixelShift {
    int x = 0, y = 0;
};

// With bounds as wide as a pixel, for triangles that count wherever they touch one.
SampleSet with_whole_pixels(SampleSet set);

// Samples at the pixel's centre are not shifted.
SampleSet make_sample_set(int samples, SamplePositions positions, SubpixelShift shift = {});

}  // namespace sheer
