// Transmittance from trigonometric moments of absorbance, in long double: C. Münstermann,
// S. Krumpen, R. Klein, C. Peters, "Moment-based order-independent transparency", 2018.
//
// z in [-1, 1] goes to the angle phi(z) = (z + 1) (pi - omega / 2) on a circle, of which the last
// omega, the wrapping zone, belongs to no z. Moments are sums of delta e^(i j phi), j = 0 to m,
// delta = -ln(1 - alpha); the first is d', what all absorb. m is 2, 3 or 4.
#pragma once

#include <complex>
#include <numbers>
#include <span>
#include <vector>

#include "reference/power_moments.h"

namespace sheer::reference {

using TrigonometricSums = std::vector<std::complex<long double>>;  // m + 1 of them

inline constexpr double kWrappingZone = 0.1 * std::numbers::pi;  // omega, the paper's

double phase_angle(double z, double omega);
TrigonometricSums trigonometric_moments(std::span<const Fragment> fragments, int moments,
                                        double most, double omega);

// Moments but the first are scaled by 1 - epsilon.
double trigonometric_bias(int moments, MomentFormat format);

// A number that grows along the circle from -1 at the angle 0 to 7, without an arc tangent.
double circle_parameter(std::complex<double> point);

// exp(-d' H), in [0, 1]. H is the mass of the atoms in front of z, where one is at z itself, which
// counts beta; one in the wrapping zone counts as much as the part of the zone that is in front of
// it, measured by circle_parameter.
double trigonometric_transmittance(const TrigonometricSums& sums, double z, double epsilon,
                                   double beta, double omega);

}  // namespace sheer::reference
