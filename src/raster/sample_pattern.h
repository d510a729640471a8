// Where a pixel's samples are.
#pragma once

#include <cstdint>
#include <vector>

#include <sheer/render.h>

namespace sheer {

inline constexpr int kMaxSamples = 64;

struct SamplePoint {
    int x, y;  // 1/256 pixel from the pixel's top left corner, 0 to 255
};

// `samples` points. Standard positions for 1, 2, 4, 8 and 16 (Vulkan 1.3, table "Standard sample
// locations", the same as Direct3D's, whose unit is 1/16 pixel); for 32 and 64 the Hammersley
// points
// ((i + 1/2) / S, radical inverse of i in base 2 + 1 / 2S), all exact on the 1/256 grid.
// SamplePositions::center: every point is (128, 128).
std::vector<SamplePoint> sample_pattern(int samples, SamplePositions positions);

}  // namespace sheer
