// Probes along the footprint's longer side, each filtered between two levels, each of these between
// four texels. After J. McCormack et al., "Feline: fast elliptical lines for anisotropic texture
// mapping", 1999, simplified as docs/numerics.md says.
#include "reference/texture_filter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "reference/reference.h"

namespace sheer::reference {

namespace {

constexpr int kMostProbes = 8;

// So near to a step the renderer's floats may be on its other side.
constexpr double kTexelRounding = 1e-3;  // texels
constexpr double kLevelRounding = 1e-4;
constexpr double kRatioRounding = 1e-4;  // relative

using Point = std::array<double, 2>;

Texel mix(const Texel& a, const Texel& b, double f)
{
    Texel result;
    for (std::size_t c = 0; c < 4; ++c) {
        result[c] = a[c] + f * (b[c] - a[c]);
    }
    return result;
}

// Into [0, 1].
double wrapped(double u, Wrap wrap)
{
    switch (wrap) {
        case Wrap::repeat: return u - std::floor(u);
        case Wrap::mirrored_repeat: {
            const double t = u - 2 * std::floor(u / 2);
            return t > 1 ? 2 - t : t;
        }
        case Wrap::clamp_to_edge: break;
    }
    return std::clamp(u, 0.0, 1.0);
}

// A texel's number, of one that may be next to the first or the last of `size`.
int inside(int i, int size, Wrap wrap)
{
    if (wrap == Wrap::repeat) {
        return (i + size) % size;
    }
    return std::clamp(i, 0, size - 1);
}

int nearest(double u, int size, Wrap wrap, std::uint8_t& discontinuities)
{
    const double x = wrapped(u, wrap) * size;
    const double step = std::round(x);
    // At the ends only repeating brings another texel.
    const bool is_end = step <= 0 || step >= size;
    if (std::abs(x - step) < kTexelRounding && (!is_end || wrap == Wrap::repeat)) {
        discontinuities |= kNearestTexel;
    }
    return std::min(static_cast<int>(x), size - 1);
}

struct Neighbors {
    int first, second;
    double fraction;  // of the second
};

Neighbors between_texels(double u, int size, Wrap wrap)
{
    const double x = wrapped(u, wrap) * size - 0.5;
    const double first = std::floor(x);
    const int i = static_cast<int>(first);
    return {inside(i, size, wrap), inside(i + 1, size, wrap), x - first};
}

// What probes of one footprint have in common.
struct Lookup {
    const MipChain& chain;
    const Sampler& sampler;
    double level;  // as computed, not clamped
    std::uint8_t discontinuities = 0;

    Texel in_level(int number, TexelFilter filter, const Point& at);
    Texel probe(const Point& at);
};

Texel Lookup::in_level(int number, TexelFilter filter, const Point& at)
{
    const TextureSize size = chain.size(number);
    if (filter == TexelFilter::nearest) {
        const int x = nearest(at[0], size.width, sampler.wrap_u, discontinuities);
        const int y = nearest(at[1], size.height, sampler.wrap_v, discontinuities);
        return chain.texel(number, x, y);
    }
    const Neighbors x = between_texels(at[0], size.width, sampler.wrap_u);
    const Neighbors y = between_texels(at[1], size.height, sampler.wrap_v);
    const auto along_x = [&](int row) {
        return mix(chain.texel(number, x.first, row), chain.texel(number, x.second, row),
                   x.fraction);
    };
    return mix(along_x(y.first), along_x(y.second), y.fraction);
}

Texel Lookup::probe(const Point& at)
{
    if (sampler.magnify != sampler.minify && std::abs(level) < kLevelRounding) {
        discontinuities |= kNearestTexel;
    }
    if (!(level > 0)) {
        return in_level(0, sampler.magnify, at);
    }
    const int last = chain.last_level();
    const double clamped = std::min(level, double{1} * last);
    switch (sampler.mip) {
        case MipFilter::none: break;
        case MipFilter::nearest: {
            const double step = std::round(level + 0.5);
            if (std::abs(level + 0.5 - step) < kLevelRounding && step >= 1 && step <= last) {
                discontinuities |= kNearestTexel;
            }
            return in_level(std::min(static_cast<int>(clamped + 0.5), last), sampler.minify, at);
        }
        case MipFilter::linear: {
            const int first = static_cast<int>(clamped);
            return mix(in_level(first, sampler.minify, at),
                       in_level(std::min(first + 1, last), sampler.minify, at), clamped - first);
        }
    }
    return in_level(0, sampler.minify, at);
}

struct Probes {
    int count;
    double level;
    std::uint8_t discontinuities;
};

// How far beyond a whole ratio another probe is taken: a wall that faces the eye has a ratio of 1.
constexpr double kBeyond = 1.0 / 64;

// `longer` and `shorter`: texels of level 0 to the next pixel. Both may be 0, which is far below
// level 0 and one probe.
Probes choose_probes(const Sampler& sampler, double longer, double shorter)
{
    if (sampler.minify != TexelFilter::linear || sampler.mip != MipFilter::linear) {
        return {1, std::log2(longer), 0};
    }
    const double level = std::log2(std::max(shorter, longer / kMostProbes));
    const auto count_at = [](double ratio) {
        return static_cast<int>(std::clamp(std::ceil(ratio - kBeyond), 1.0, double{kMostProbes}));
    };
    // A footprint without width has as many probes as there may be, as the longest have.
    const double ratio = shorter > 0 ? longer / shorter : kMostProbes;
    const bool may_be_one = longer <= 1 + kRatioRounding;
    const bool must_be_one = longer < 1 - kRatioRounding;
    const bool may_change =
        count_at(ratio * (1 - kRatioRounding)) != count_at(ratio * (1 + kRatioRounding)) ||
        (may_be_one && count_at(ratio) != 1);
    const int count = longer <= 1 ? 1 : count_at(ratio);
    const bool is_open = may_change && !must_be_one;
    return {count, level, static_cast<std::uint8_t>(is_open ? kProbeCount : 0)};
}

}  // namespace

Footprint transformed(const std::array<float, 6>& transform, const Footprint& footprint)
{
    const double t[6] = {transform[0], transform[1], transform[2],
                         transform[3], transform[4], transform[5]};
    const auto turned = [&](const Point& p) {
        return Point{t[0] * p[0] + t[1] * p[1], t[3] * p[0] + t[4] * p[1]};
    };
    const Point at = turned(footprint.at);
    return {{at[0] + t[2], at[1] + t[5]}, turned(footprint.per_x), turned(footprint.per_y)};
}

Filtered filter_texture(const MipChain& chain, const Sampler& sampler, const Footprint& footprint)
{
    const TextureSize size = chain.size(0);
    const auto texels = [&](const Point& d) {
        return std::hypot(d[0] * size.width, d[1] * size.height);
    };
    const double x = texels(footprint.per_x);
    const double y = texels(footprint.per_y);
    const Point& longer = x > y ? footprint.per_x : footprint.per_y;
    const Probes probes = choose_probes(sampler, std::max(x, y), std::min(x, y));
    Lookup lookup{chain, sampler, probes.level, probes.discontinuities};
    Filtered result;
    for (int i = 0; i < probes.count; ++i) {
        const double offset = (i + 0.5) / probes.count - 0.5;
        const Texel texel = lookup.probe(
            {footprint.at[0] + offset * longer[0], footprint.at[1] + offset * longer[1]});
        for (std::size_t c = 0; c < 4; ++c) {
            result.texel[c] += texel[c] / probes.count;
        }
    }
    result.discontinuities = lookup.discontinuities;
    return result;
}

}  // namespace sheer::reference
