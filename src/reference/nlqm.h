// Four power moments of z in [-1, 1] as two depths, a weight and an excess, which can be rounded
// much further than moments: C. Peters, "Non-linearly quantized moment shadow maps", 2017.
#pragma once

#include <array>
#include <cstdint>

#include "reference/power_moments.h"

namespace sheer::reference {

// The measure of two atoms that has the first three moments: 1 - w at d0 and w at d1, d0 <= d1; and
// by how much the fourth moment is larger than its.
struct TwoAtoms {
    double d0 = 0, d1 = 0, w = 0, excess = 0;
};

using FourMoments = std::array<double, 4>;  // b_1 to b_4 over b_0

// What the paper biases with before: 3e-7 towards (0, .375, 0, .375).
inline const MomentBias kNlqmBias = {3e-7, {0, 0.375, 0, 0.375}};
FourMoments biased(const FourMoments& b, const MomentBias& bias);

TwoAtoms two_atoms(const FourMoments& b);  // of biased moments
FourMoments moments_of(const TwoAtoms& atoms);

// The excess, of [1.2e-7, 1/4] by the logarithm of a logarithm, as [0, 1].
double warp_excess(double excess);
double unwarp_excess(double warped);

// Four numbers of 16 bits: both depths as [0, 1], w, the warped excess.
std::array<std::uint16_t, 4> to_64_bits(const TwoAtoms& atoms);
TwoAtoms from_64_bits(const std::array<std::uint16_t, 4>& bits);

// d0 in the 9 highest bits, d1 in 10, sqrt(w) in 7, the warped excess in 6. Depths are steps of
// 2 / 1022 from -1 on. Where d0 has more than 9 bits both are mirrored: 1023 less its steps and
// 1022 less d1's, by which d0's become more than d1's.
std::uint32_t to_32_bits(const TwoAtoms& atoms);
TwoAtoms from_32_bits(std::uint32_t bits);

// mass_in_front's lower bound, without the moments.
double mass_in_front_of(const TwoAtoms& atoms, double z);

}  // namespace sheer::reference
