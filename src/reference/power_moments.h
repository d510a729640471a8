// Transmittance from power moments of absorbance, in long double: B. Sharpe, "Moment transparency",
// 2018; C. Münstermann, S. Krumpen, R. Klein, C. Peters, "Moment-based order-independent
// transparency", 2018.
//
// A fragment with opacity alpha at z absorbs delta = -ln(1 - alpha). Moments are sums of
// delta z^j for j = 0 to M; the first is d', what all absorb. z is in [0, 1] or [-1, 1] as the
// caller has it, M is 4, 6 or 8.
#pragma once

#include <span>
#include <vector>

#include "reference/reference.h"

namespace sheer::reference {

// -ln(1 - opacity), at most `most`; infinite for opacity 1 otherwise.
double absorbance(double opacity);
double absorbance(double opacity, double most);

using MomentSums = std::vector<long double>;  // M + 1 of them

// Fragments' depth is z; none may have opacity 1 unless `most` is finite.
MomentSums power_moments(std::span<const Fragment> fragments, int moments, double most);

// b becomes (1 - epsilon) b + epsilon target, both b_1 to b_M over b_0.
struct MomentBias {
    double epsilon = 0;
    std::vector<double> target;
};

// The bias of moments of z in [-1, 1] that are kept in 32-bit floats, or rounded to 16 bits as
// reference/rounded_moments.h has it.
enum class MomentFormat { fp32, unorm16 };
MomentBias power_bias(int moments, MomentFormat format);

// Bounds of the part of the mass that is in front of z, 0 to 1, of all measures with these moments:
// the largest that is never more (0 <= ... <= 1), and the smallest that is never less; they differ
// by the most that can be at z itself. Without any mass: 0 and 0.
struct MassInFront {
    long double least = 0, most = 0;
};
MassInFront mass_in_front(const MomentSums& sums, double z, const MomentBias& bias);

// exp(-d' H), H = least + beta (most - least), in [0, 1]. beta 0: as bright as can be; "25 %
// overestimation" is beta = 0.25.
double power_transmittance(const MomentSums& sums, double z, const MomentBias& bias, double beta);

}  // namespace sheer::reference
