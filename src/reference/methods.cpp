// The methods that blend: one loop over the fragments, the papers' formulas as they stand.
#include "reference/methods.h"

#include <algorithm>
#include <cmath>

namespace sheer::reference {
namespace {

struct WeightedSum {
    double color[3] = {0, 0, 0};
    double weight = 0;

    void add(const Fragment& fragment, double by)
    {
        for (int i = 0; i < 3; ++i) {
            color[i] += by * fragment.color[i];
        }
        weight += by;
    }

    // The average colour in front of the backdrop. A sum of nothing has no average, nor needs one:
    // nothing visible arrived.
    Rgba over(Rgba backdrop, double transmittance) const
    {
        const double scale = weight > 0 ? (1 - transmittance) / weight : 0;
        return {scale * color[0] + transmittance * backdrop.r,
                scale * color[1] + transmittance * backdrop.g,
                scale * color[2] + transmittance * backdrop.b,
                1 - transmittance * (1 - backdrop.a)};
    }
};

}  // namespace

Rgba blend(std::span<const Fragment> fragments, Rgba backdrop)
{
    Rgba result = backdrop;
    for (const Fragment& fragment : fragments) {
        const double opacity = fragment.opacity;
        result = {opacity * fragment.color[0] + (1 - opacity) * result.r,
                  opacity * fragment.color[1] + (1 - opacity) * result.g,
                  opacity * fragment.color[2] + (1 - opacity) * result.b,
                  opacity + (1 - opacity) * result.a};
    }
    return result;
}

Rgba weighted_average(std::span<const Fragment> fragments, Rgba backdrop)
{
    if (fragments.empty()) {
        return backdrop;
    }
    WeightedSum sum;
    for (const Fragment& fragment : fragments) {
        sum.add(fragment, fragment.opacity);
    }
    const auto n = static_cast<double>(fragments.size());
    return sum.over(backdrop, std::pow(1 - sum.weight / n, n));
}

double wboit_weight(WboitWeight weight, double z, double znear, double zfar)
{
    switch (weight) {
        case WboitWeight::eq7:
            return std::clamp(10 / (1e-5 + std::pow(z / 5, 2) + std::pow(z / 200, 6)), 1e-2, 3e3);
        case WboitWeight::eq8:
            return std::clamp(10 / (1e-5 + std::pow(z / 10, 3) + std::pow(z / 200, 6)), 1e-2, 3e3);
        case WboitWeight::eq9: return std::clamp(0.03 / (1e-5 + std::pow(z / 200, 4)), 1e-2, 3e3);
        case WboitWeight::eq10: {
            // d is gl_FragCoord.z; without a far plane, its limit.
            const double d = zfar == 0 ? 1 - znear / z : (znear * zfar / z - zfar) / (znear - zfar);
            return std::max(1e-2, 3e3 * std::pow(1 - d, 3));
        }
        case WboitWeight::uniform: return 1;
    }
    return 1;
}

Rgba wboit(std::span<const Fragment> fragments, WboitWeight weight, double znear, double zfar,
           Rgba backdrop)
{
    WeightedSum sum;
    double reveal = 1;
    for (const Fragment& fragment : fragments) {
        // The sums are of w times the premultiplied colour, and of w times the opacity; w of
        // equations 7 to 10 has the opacity in it once more.
        const double own = weight == WboitWeight::uniform ? 1 : fragment.opacity;
        const double by = fragment.opacity * own;
        sum.add(fragment, by * wboit_weight(weight, fragment.depth, znear, zfar));
        reveal *= 1 - fragment.opacity;
    }
    // The usual guard, max(sum, 1e-5), is for halves; here it would darken faint fragments.
    return sum.over(backdrop, reveal);
}

}  // namespace sheer::reference
