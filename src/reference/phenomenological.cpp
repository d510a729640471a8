#include "reference/phenomenological.h"

#include <algorithm>
#include <cmath>

namespace sheer::reference {

double phenomenological_weight(double opacity, double d)
{
    const double by_depth = std::clamp(std::pow(1 - 0.99 * d, 3) * 1e4, 1e-3, 1.0);
    return std::clamp(opacity * by_depth, 1e-3, 1.5e2);
}

Rgba phenomenological(std::span<const Fragment> fragments, BackdropPart part, Rgba backdrop)
{
    double sum[3] = {0, 0, 0}, weight = 0, seen[3] = {1, 1, 1};
    for (const Fragment& f : fragments) {
        const double w = phenomenological_weight(f.opacity, f.depth) * f.opacity;
        weight += w;
        for (int c = 0; c < 3; ++c) {
            sum[c] += w * f.color[c];
            seen[c] *= f.transmittance[c];
        }
    }
    const double mean = (seen[0] + seen[1] + seen[2]) / 3;
    const double behind[3] = {backdrop.r, backdrop.g, backdrop.b};
    double color[3];
    for (int c = 0; c < 3; ++c) {
        const double unseen = 1 - (part == BackdropPart::mean ? mean : seen[c]);
        color[c] = (weight > 0 ? unseen * sum[c] / weight : 0) + seen[c] * behind[c];
    }
    return {color[0], color[1], color[2], 1 - mean * (1 - backdrop.a)};
}

double phenomenological_diffusion(double opacity, double collimation, double z, double behind)
{
    constexpr double k0 = 8, k1 = 0.1;
    const double spread = k0 * opacity * (1 - collimation) * (1 - k1 / (k1 + behind)) / z;
    return spread * spread;
}

Displacement phenomenological_refraction(const double (&ray)[3], const double (&normal)[3],
                                         double eta)
{
    const double length = std::hypot(ray[0], ray[1], ray[2]);
    double across[3];  // the ray's part along the surface
    const double inwards = -(ray[0] * normal[0] + ray[1] * normal[1] + ray[2] * normal[2]) / length;
    for (int c = 0; c < 3; ++c) across[c] = ray[c] / length + inwards * normal[c];
    const double sine = std::hypot(across[0], across[1], across[2]);
    if (sine == 0) return {0, 0};
    const double angle = std::asin(sine / eta);
    double turned[3];
    for (int c = 0; c < 3; ++c) {
        turned[c] = std::sin(angle) / sine * across[c] - std::cos(angle) * normal[c];
    }
    return {turned[0] / turned[2] - ray[0] / ray[2], turned[1] / turned[2] - ray[1] / ray[2]};
}

}  // namespace sheer::reference
