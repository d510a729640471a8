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

}  // namespace sheer::reference
