// Raw moments of a random number, for summing over the cases in which it takes its values.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "reference/methods.h"

namespace sheer::reference {

inline constexpr std::size_t kOrders = 5;

using RawMoments = std::array<double, kOrders>;  // E[X^i], times the probability of the case

// Of X + step, by the binomial theorem.
inline RawMoments shift(const RawMoments& raw, double step)
{
    constexpr double kBinomials[kOrders][kOrders] = {
        {1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
    RawMoments result = {};
    for (std::size_t order = 0; order < kOrders; ++order) {
        double power = 1;
        for (std::size_t i = order + 1; i-- > 0; power *= step) {
            result[order] += kBinomials[order][i] * power * raw[i];
        }
    }
    return result;
}

// Of factor X.
inline RawMoments stretch(const RawMoments& raw, double factor)
{
    RawMoments result = raw;
    double power = 1;
    for (double& moment : result) {
        moment *= power;
        power *= factor;
    }
    return result;
}

inline void add_scaled(RawMoments& sum, double scale, const RawMoments& raw)
{
    for (std::size_t order = 0; order < kOrders; ++order) {
        sum[order] += scale * raw[order];
    }
}

// Of X + origin. Central moments do not cancel where the mean of X is near 0.
inline Moments central(const RawMoments& raw, double origin)
{
    const double m = raw[1];
    return {origin + m, std::max(0.0, raw[2] - m * m),
            std::max(0.0, raw[4] - 4 * m * raw[3] + 6 * m * m * raw[2] - 3 * m * m * m * m)};
}

}  // namespace sheer::reference
