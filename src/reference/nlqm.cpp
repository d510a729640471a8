#include "reference/nlqm.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sheer::reference {
namespace {

constexpr double kLeastExcess = 1.2e-7, kMostExcess = 0.25;

double log_of_log(double excess)
{
    return std::log(std::log(excess / 1e-7));
}

double to_unit(double depth)
{
    return depth * 0.5 + 0.5;
}

std::uint32_t steps(double unit, int most)
{
    return static_cast<std::uint32_t>(std::lround(std::clamp(unit, 0.0, 1.0) * most));
}

}  // namespace

FourMoments biased(const FourMoments& b, const MomentBias& bias)
{
    FourMoments result;
    for (std::size_t j = 0; j < 4; ++j) {
        result[j] = (1 - bias.epsilon) * b[j] + bias.epsilon * bias.target[j];
    }
    return result;
}

TwoAtoms two_atoms(const FourMoments& b)
{
    const double variance = b[1] - b[0] * b[0];
    const double p1 = b[0] * b[1] - b[2];
    const double p0 = -b[0] * p1 - b[1] * variance;
    // variance x^2 + p1 x + p0 = 0
    const double root = std::sqrt(std::max(0.0, p1 * p1 / 4 - variance * p0));
    const double d0 = (-p1 / 2 - root) / variance, d1 = (-p1 / 2 + root) / variance;
    return {d0, d1, (b[0] - d0) / (d1 - d0), b[3] - b[1] * b[1] - p1 * p1 / variance};
}

FourMoments moments_of(const TwoAtoms& atoms)
{
    FourMoments b;
    double power0 = 1, power1 = 1;
    for (double& moment : b) {
        power0 *= atoms.d0;
        power1 *= atoms.d1;
        moment = (1 - atoms.w) * power0 + atoms.w * power1;
    }
    b[3] += atoms.excess;
    return b;
}

double warp_excess(double excess)
{
    const double low = log_of_log(kLeastExcess), high = log_of_log(kMostExcess);
    const double at = log_of_log(std::max(excess, kLeastExcess));
    return std::clamp((at - low) / (high - low), 0.0, 1.0);
}

double unwarp_excess(double warped)
{
    const double low = log_of_log(kLeastExcess), high = log_of_log(kMostExcess);
    return 1e-7 * std::exp(std::exp(warped * (high - low) + low));
}

std::array<std::uint16_t, 4> to_64_bits(const TwoAtoms& atoms)
{
    std::array<std::uint16_t, 4> bits;
    const double units[4] = {to_unit(atoms.d0), to_unit(atoms.d1), atoms.w,
                             warp_excess(atoms.excess)};
    for (std::size_t i = 0; i < 4; ++i) {
        bits[i] = static_cast<std::uint16_t>(steps(units[i], 65535));
    }
    return bits;
}

TwoAtoms from_64_bits(const std::array<std::uint16_t, 4>& bits)
{
    const auto unit = [&](std::size_t i) { return bits[i] / 65535.0; };
    return {unit(0) * 2 - 1, unit(1) * 2 - 1, unit(2), unwarp_excess(unit(3))};
}

std::uint32_t to_32_bits(const TwoAtoms& atoms)
{
    std::uint32_t d0 = steps(to_unit(atoms.d0), 1022), d1 = steps(to_unit(atoms.d1), 1022);
    if (d0 >= 512) {
        d0 = 1023 - d0;
        d1 = 1022 - d1;
    }
    return d0 << 23 | d1 << 13 | steps(std::sqrt(std::max(0.0, atoms.w)), 127) << 6 |
           steps(warp_excess(atoms.excess), 63);
}

TwoAtoms from_32_bits(std::uint32_t bits)
{
    std::uint32_t d0 = bits >> 23, d1 = bits >> 13 & 1023;
    if (d1 < d0) {
        d0 = 1023 - d0;
        d1 = 1022 - d1;
    }
    const double root = (bits >> 6 & 127) / 127.0;
    return {d0 / 511.0 - 1, d1 / 511.0 - 1, root * root, unwarp_excess((bits & 63) / 63.0)};
}

double mass_in_front_of(const TwoAtoms& atoms, double z)
{
    const double w = std::clamp(atoms.w, 5e-6, 1 - 5e-6);
    const double d0 = atoms.d0, scale = 1 / (std::max(atoms.d1, d0 + 5e-6) - d0);
    if (z <= d0) return 0;
    const double t = (z - d0) * scale, excess = std::max(atoms.excess, 1e-15) * std::pow(scale, 4);
    const auto mass_at = [&](double x) {  // of an atom, d0 being at 0 and d1 at 1
        return 1 / ((1 - x) * (1 - x) / (1 - w) + x * x / w + x * x * (1 - x) * (1 - x) / excess);
    };
    if (t >= 1) return 1 - mass_at(t);
    const double q = -excess / ((1 - w) * t);
    const double half = -q / 2 * (1 - t / w) / (1 - t) - 0.5;
    return mass_at(-half - std::sqrt(half * half - q));
}

}  // namespace sheer::reference
