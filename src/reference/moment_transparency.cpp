#include "reference/moment_transparency.h"

#include <cmath>
#include <vector>

namespace sheer::reference {
namespace {

Transmittance from_moments(std::span<const Fragment> fragments, const MomentTransparency& how)
{
    const MomentSums sums = power_moments(fragments, how.moments, how.most_absorbance);
    return [sums, how](double z) { return power_transmittance(sums, z, how.bias, how.beta); };
}

}  // namespace

double log_warp(double distance, double near, double far)
{
    return std::log(distance / near) / std::log(far / near);
}

Rgba weigh_by_transmittance(std::span<const Fragment> fragments, const Transmittance& transmittance,
                            Rgba backdrop)
{
    Rgba sum;
    double through = 1;
    for (const Fragment& f : fragments) {
        const double weight = f.opacity * transmittance(f.depth);
        sum.r += weight * f.color[0];
        sum.g += weight * f.color[1];
        sum.b += weight * f.color[2];
        sum.a += weight;
        through *= 1 - f.opacity;
    }
    const double scale = sum.a > 0 ? (1 - through) / sum.a : 0;
    return {scale * sum.r + through * backdrop.r, scale * sum.g + through * backdrop.g,
            scale * sum.b + through * backdrop.b, 1 - through * (1 - backdrop.a)};
}

Rgba moment_transparency(std::span<const Fragment> fragments, const MomentTransparency& how,
                         Rgba backdrop)
{
    Transmittance transmittance = from_moments(fragments, how);
    if (how.passes == 2) {
        std::vector<Fragment> occluded(fragments.begin(), fragments.end());
        for (Fragment& f : occluded) f.opacity *= transmittance(f.depth);
        transmittance = [first = transmittance, second = from_moments(occluded, how)](double z) {
            return first(z) * second(z);
        };
    }
    return weigh_by_transmittance(fragments, transmittance, backdrop);
}

}  // namespace sheer::reference
