// Colours from an approximate transmittance: B. Sharpe, "Moment transparency", 2018, and
// C. Münstermann et al., "Moment-based order-independent transparency", 2018.
#pragma once

#include <functional>
#include <span>

#include "reference/power_moments.h"

namespace sheer::reference {

// Equation 6 of the former: distances from `near` to `far` go to [0, 1]. The latter has twice that,
// less 1.
double log_warp(double distance, double near, double far);

// Of the light from z, in front of z.
using Transmittance = std::function<double(double z)>;

// sum c alpha T(z) / sum alpha T(z), as much as the fragments cover in truth, over the backdrop.
// Where every T(z) is 0 there is no colour. The first equation of the former leaves the backdrop
// out.
Rgba weigh_by_transmittance(std::span<const Fragment> fragments, const Transmittance& transmittance,
                            Rgba backdrop);

struct MomentTransparency {
    int moments = 4;
    MomentBias bias = power_bias(4, MomentFormat::fp32);
    double beta = 0;  // of overestimation
    // 2: the transmittance T of the first pass's moments makes a second pass's, of fragments with
    // opacity alpha T(z), and the product of both is what weighs colours. (The paper says no more
    // than that each fragment is occluded by twice the amount, and that this darkens behind one or
    // two in front; this is a reading of it that does.)
    int passes = 1;
    double most_absorbance = 10;  // of a fragment
};

// Fragments' depth is z in [0, 1] or [-1, 1], as the bias is meant for.
Rgba moment_transparency(std::span<const Fragment> fragments, const MomentTransparency& how,
                         Rgba backdrop);

}  // namespace sheer::reference
