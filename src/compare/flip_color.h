// The colours in which FLIP thinks: linear RGB to CIE's spaces and back.
#pragma once

#include <array>

namespace sheer {

using Triple = std::array<double, 3>;

// CIELAB without its cube root: brightness, red against green, blue against yellow.
Triple ycxcz_from_linear(const Triple& rgb);
Triple linear_from_ycxcz(const Triple& color);

// CIELAB, its a and b times L / 100: at low light colours look less colourful (Hunt).
Triple hunt_lab_from_linear(const Triple& rgb);

// |difference of L| + the distance in a and b: for large differences of colour.
double hyab(const Triple& a, const Triple& b);

}  // namespace sheer
