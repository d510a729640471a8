// A point at a time, by the same texts as the method `moment`.
#include "shade/moment_part.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lanes/lone.h"

namespace sheer {

namespace {

template <class L>
struct WideText {
#include "lanes/text_words.h"
#include "sheer/power_moments.glsl"
};

template <class L>
struct Text {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/exponential.glsl"
#include "sheer/transmittance.glsl"
#include "sheer/moment.glsl"
};

using Doubles = WideText<Lone<double>>;
using Floats = Text<Lone<float>>;
using Sums = std::array<double, kFourMoments>;

float place_of_depth(const MomentTexels& moments, float depth)
{
    return Floats::warped_depth(moments.is_distance, depth, moments.from, moments.scale);
}

// Of the same masses, each `shift` farther: binomials.
Sums shifted(const double* m, double shift)
{
    const double s = shift, s2 = s * s;
    return {m[0], m[1] + s * m[0], m[2] + 2 * s * m[1] + s2 * m[0],
            m[3] + 3 * s * m[2] + 3 * s2 * m[1] + s2 * s * m[0],
            m[4] + 4 * s * m[3] + 6 * s2 * m[2] + 4 * s2 * s * m[1] + s2 * s2 * m[0]};
}

// Of `filter` + 1 texels in a row, the first of which is outside to that part: how much of texel i
// is in the footprint.
double part_inside(int i, int filter, double outside)
{
    return i == 0 ? 1 - outside : i == filter ? outside : 1;
}

float transmittance(const Sums& sums, float place, float overestimation)
{
    Doubles::PowerMoments m = {};
    for (std::size_t k = 0; k < kFourMoments; ++k) m.m[k] = sums[k] / sums[0];
    const Doubles::MomentBias bias{kMomentBias, {1, kMomentBiasEven, kMomentBiasEven}};
    const auto r =
        Doubles::recurrence_of(Doubles::biased_moments(m, bias, 2), 2, 0.1 * kMomentBias);
    const auto curve =
        Floats::moment_curve(static_cast<float>(r.a[0]), static_cast<float>(r.a[1]),
                             static_cast<float>(r.b[1]), static_cast<float>(r.b[2]),
                             static_cast<float>(std::sqrt(r.b[1])), static_cast<float>(sums[0]));
    return Floats::moment_transmittance(curve, place, overestimation);
}

}  // namespace

// Texels beside the point see the plane of its own surface at other depths than it has. Their
// masses are moved by as much, so that what is before the plane there is before the point.
float moment_part(const ShadowMap& map, const MapPoint& p)
{
    const auto size = static_cast<float>(map.size);
    if (!(p.x >= 0 && p.x <= size && p.y >= 0 && p.y <= size)) return 1;
    const MomentTexels& moments = *map.moments;
    const float reach = 0.5f * static_cast<float>(map.filter);
    const auto side = [&](float middle, double& outside) {
        const float from = middle - reach;
        const int first = std::clamp(static_cast<int>(from), 0, map.size - map.filter - 1);
        outside = std::clamp(static_cast<double>(from) - first, 0.0, 1.0);
        return first;
    };
    double outside_x = 0, outside_y = 0;
    const int column = side(p.x, outside_x), row = side(p.y, outside_y);
    const auto place = static_cast<double>(place_of_depth(moments, p.depth));
    if (place < static_cast<double>(-kFarthestPlace)) return 1;
    Sums sums = {};
    for (int j = 0; j <= map.filter; ++j) {
        for (int i = 0; i <= map.filter; ++i) {
            const double weight =
                part_inside(i, map.filter, outside_x) * part_inside(j, map.filter, outside_y);
            const auto texel =
                static_cast<std::size_t>(row + j) * static_cast<std::size_t>(map.size) +
                static_cast<std::size_t>(column + i);
            const double* at = moments.sums.data() + kFourMoments * texel;
            if (weight == 0 || at[0] == 0) continue;
            const float there = p.depth +
                                (static_cast<float>(column + i) + 0.5f - p.x) * p.depth_x +
                                (static_cast<float>(row + j) + 0.5f - p.y) * p.depth_y;
            const Sums moved =
                shifted(at, place - static_cast<double>(place_of_depth(moments, there)));
            for (std::size_t k = 0; k < kFourMoments; ++k) sums[k] += weight * moved[k];
        }
    }
    const double all = static_cast<double>(map.filter) * map.filter;
    for (double& sum : sums) sum /= all;
    // Less than what sums are exact to is nothing.
    if (!(sums[0] > 0x1p-38)) return 1;
    // Behind all fragments what they let through is known.
    if (place > static_cast<double>(kFarthestPlace)) {
        return Floats::exp_of(static_cast<float>(-sums[0]));
    }
    return transmittance(sums, static_cast<float>(place), moments.overestimation);
}

}  // namespace sheer
