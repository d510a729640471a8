// The table of masks of stochastic transparency (shaders/sheer/stochastic_masks.glsl,
// mask_of_table).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace sheer {

// Every row, of an opacity, has so many masks.
inline constexpr int kMaskColumns = 2047, kMaskRows = 1001;
// Of more than 32 samples; else the half.
inline constexpr int kMaskTableBytes = kMaskColumns * kMaskRows * 8;

// Masks by their index.
struct MaskTable {
    std::vector<std::uint32_t> low;
    std::vector<std::uint32_t> high;  // samples 32 to 63, if there are any
};

// 1 to 64 samples. Made once for all stores that use it at the same time; the latest is kept, for
// the next frame.
std::shared_ptr<const MaskTable> mask_table(int samples);

}  // namespace sheer
