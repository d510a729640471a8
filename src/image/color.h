// The sRGB curve (IEC 61966-2-1), between linear light and what PNG files hold.
#pragma once

#include <cstdint>

namespace sheer {

double linear_from_srgb(double encoded);  // in [0, 1]
double srgb_from_linear(double linear);   // in [0, 1]

// round(255 * srgb_from_linear(linear)), halves upwards; clamps to [0, 1], NaN counts as 0.
std::uint8_t srgb8_from_linear(double linear);

}  // namespace sheer
