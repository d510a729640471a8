// One fragment's mask as `stochastic` draws it with its standard parameters, for whoever counts.
#pragma once

#include <cstdint>

namespace sheer {

struct MaskedFragment {
    std::uint32_t x, y;  // the pixel
    std::uint32_t primitive;
    float opacity;
};

// Sample i in bit i. `key`: of the frame's random numbers; `samples`: 1 to 64.
std::uint64_t stochastic_mask(const MaskedFragment& fragment, std::uint32_t key, int samples);

}  // namespace sheer
