// How much of a light reaches a vector of fragments: each fragment's footprint on the light's map,
// a vector of samples at a time. Only whole numbers are summed over lanes, so that all targets give
// the same bits.
#if defined(SHEER_SHADOW_LOOKUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SHADOW_LOOKUP_INL_H
#undef SHEER_SHADOW_LOOKUP_INL_H
#else
#define SHEER_SHADOW_LOOKUP_INL_H
#endif

#include <algorithm>
#include <bit>
#include <limits>

#include "lanes/lanes-inl.h"
#include "lanes/lone.h"
#include "lanes/text.h"
#include "shade/moment_part.h"
#include "shade/shadow_map.h"
#include "shade/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct ShadowText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/stochastic_shadow.glsl"
};

// Over a row of texels: of all of them, of the first and of the last, for each kind of sum.
struct RowSums {
    float all[4] = {}, first[4] = {}, last[4] = {};
};

// What is summed over samples. Without correction light stops at what is opaque as at all else, and
// the first alone is asked for.
enum ShadowSum {
    kSeen,     // light reaches the point
    kOpen,     // nothing opaque is before it; from here on with correction
    kEnd,      // nor anything transparent, however far behind
    kThrough,  // the part that passes through everything transparent
    kShadowSums
};

HWY_INLINE void add_bits(const TexelRow& row, std::size_t group, std::uint32_t bits, int sum,
                         RowSums& sums)
{
    sums.all[sum] += static_cast<float>(std::popcount(bits & row.all[group]));
    sums.first[sum] += static_cast<float>(std::popcount(bits & row.first[group]));
    sums.last[sum] += static_cast<float>(std::popcount(bits & row.last[group]));
}

// Of sixteen samples the depth of the surface at them, and what they hold.
struct SampleGroup {
    alignas(64) float depth[TexelRow::kGroup];

    // Bits of those at which light gets to the surface.
    HWY_INLINE std::uint32_t lit(const float* stored) const
    {
        using L = Lanes<TexelRow::kGroup>;
        std::uint32_t bits = 0;
        for (int i = 0; i < TexelRow::kGroup; i += L::kCount) {
            bits |=
                ShadowText<L>::shadow_is_lit(L::real::load(depth + i), L::real::load(stored + i))
                    .bits()
                << i;
        }
        return bits;
    }
};

HWY_INLINE void add_corrected(const ShadowMap& map, const ShadowMap::Layer& layer,
                              const TexelRow& row, std::size_t group, std::size_t at,
                              const SampleGroup& samples, std::uint32_t seen, RowSums& sums)
{
    const std::uint32_t open = samples.lit(map.opaque.data() + at);
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < TexelRow::kGroup; ++i) {
        const std::uint32_t bit = 1u << i;
        if (layer.depth[at + i] == std::numeric_limits<float>::infinity()) end |= bit;
        if ((open & bit & row.all[group]) == 0) continue;
        const float through = layer.through[at + i];
        sums.all[kThrough] += through;
        if ((bit & row.first[group]) != 0) sums.first[kThrough] += through;
        if ((bit & row.last[group]) != 0) sums.last[kThrough] += through;
    }
    add_bits(row, group, seen & open, kSeen, sums);
    add_bits(row, group, open, kOpen, sums);
    add_bits(row, group, end & open, kEnd, sums);
}

// Of the row whose first texel is (column, y).
HWY_INLINE RowSums sum_row(const ShadowMap& map, const ShadowMap::Layer& layer, const TexelRow& row,
                           int column, int y, const MapPoint& p)
{
    using L = Lanes<TexelRow::kGroup>;
    using Text = ShadowText<L>;
    using real = typename L::real;
    const real depth(ShadowText<Lone<float>>::shadow_depth_at(
        p.depth, static_cast<float>(column) - p.x, static_cast<float>(y) - p.y, p.depth_x,
        p.depth_y));
    RowSums sums;
    SampleGroup samples;
    for (int g = 0; g < row.groups; ++g) {
        const auto group = static_cast<std::size_t>(g);
        const std::size_t first = group * TexelRow::kGroup, at = map.at(column, y) + first;
        for (std::size_t i = 0; i < TexelRow::kGroup; i += L::kCount) {
            Text::shadow_depth_at(depth, real::load(row.x.data() + first + i),
                                  real::load(row.y.data() + first + i), real(p.depth_x),
                                  real(p.depth_y))
                .store(samples.depth + i);
        }
        const std::uint32_t seen = samples.lit(layer.depth.data() + at);
        if (map.is_corrected()) {
            add_corrected(map, layer, row, group, at, samples, seen, sums);
        } else {
            add_bits(row, group, seen, kSeen, sums);
        }
    }
    return sums;
}

// Of the light, from sums over `samples` samples.
HWY_INLINE float part_of(const ShadowMap& map, const float (&sums)[4], float samples)
{
    using Text = ShadowText<Lone<float>>;
    if (!map.is_corrected()) return std::min(sums[kSeen] / samples, 1.0f);
    if (!(sums[kOpen] > 0)) return 0;
    const float seen = Text::shadow_corrected(sums[kSeen] / sums[kOpen], sums[kEnd] / sums[kOpen],
                                              sums[kThrough] / sums[kOpen]);
    return std::clamp(sums[kOpen] / samples * seen, 0.0f, 1.0f);
}

// A footprint's first texel, of filter + 1, and how much of it is outside.
struct FootprintSide {
    int first;
    float outside;
};

HWY_INLINE FootprintSide footprint_side(float middle, int filter, int size)
{
    const float from = middle - 0.5f * static_cast<float>(filter);
    const int first = std::clamp(static_cast<int>(from), 0, size - filter - 1);
    return {first, std::clamp(from - static_cast<float>(first), 0.0f, 1.0f)};
}

HWY_INLINE float fixed_part(const ShadowMap& map, const ShadowMap::Layer& layer, const MapPoint& p)
{
    using Text = ShadowText<Lone<float>>;
    const FootprintSide column = footprint_side(p.x, map.filter, map.size);
    const FootprintSide row = footprint_side(p.y, map.filter, map.size);
    float first[4] = {}, between[4] = {}, last[4] = {};
    const int count = map.is_corrected() ? kShadowSums : 1;
    for (int j = 0; j <= map.filter; ++j) {
        const RowSums sums = sum_row(map, layer, map.row, column.first, row.first + j, p);
        float(&to)[4] = j == 0 ? first : j == map.filter ? last : between;
        for (int i = 0; i < count; ++i) {
            to[i] += Text::shadow_sum(sums.first[i], sums.all[i] - sums.first[i] - sums.last[i],
                                      sums.last[i], column.outside);
        }
    }
    for (int i = 0; i < count; ++i) {
        first[i] = Text::shadow_sum(first[i], between[i], last[i], row.outside);
    }
    return part_of(map, first, static_cast<float>(map.filter * map.filter * map.samples));
}

// One texel out of each of filter x filter places.
HWY_INLINE float random_part(const ShadowMap& map, const ShadowMap::Layer& layer, const MapPoint& p)
{
    using Text = ShadowText<Lone<float>>;
    // The point's own place on the map, which no other shares, is its seed.
    std::uint32_t seed =
        Text::identity_seed(std::bit_cast<std::uint32_t>(p.x),
                            Text::identity_seed(std::bit_cast<std::uint32_t>(p.y), map.key));
    const float reach = 0.5f * static_cast<float>(kShadowSpread * map.filter);
    float sums[4] = {};
    for (int j = 0; j < map.filter; ++j) {
        for (int i = 0; i < map.filter; ++i) {
            const auto place = [&](float middle, int cell) {
                const float at = Text::shadow_random_place(middle - reach, Text::real(cell),
                                                           Text::next_random_real(seed),
                                                           Text::real(kShadowSpread));
                return std::clamp(static_cast<int>(at), 0, map.size - 1);
            };
            const int x = place(p.x, i), y = place(p.y, j);
            const RowSums row = sum_row(map, layer, map.texel, x, y, p);
            for (std::size_t k = 0; k < 4; ++k) sums[k] += row.all[k];
        }
    }
    return part_of(map, sums, static_cast<float>(map.filter * map.filter * map.samples));
}

HWY_INLINE float visible_part_at(const ShadowMap& map, const ShadowMap::Layer& layer,
                                 const MapPoint& p)
{
    const auto size = static_cast<float>(map.size);
    // What the map does not show is lit; written so that no number is outside too.
    if (!(p.x >= 0 && p.x <= size && p.y >= 0 && p.y <= size)) return 1;
    return map.footprint == Footprint::fixed ? fixed_part(map, layer, p)
                                             : random_part(map, layer, p);
}

// w1, w2: perspective-correct weights of vertices 1 and 2; `lanes` hold a point.
template <class L>
HWY_NOINLINE Vector<L> visible_part(const ShadowMap& map, const ShadowReceiver& r,
                                    typename L::real w1, typename L::real w2, int lanes)
{
    using real = typename L::real;
    const auto at = [&](std::size_t i) HWY_ATTR {
        return real(r.corner[i]) + w1 * real(r.toward1[i]) + w2 * real(r.toward2[i]);
    };
    real x = at(0), y = at(1), depth = at(2);
    real slack(r.slack[0]);
    if (!map.space.orthographic) {
        const real inverse = real(1.0f) / depth;
        x = x * inverse;
        y = y * inverse;
        depth = real(0.0f) - inverse;
        slack = slack + inverse * (real(r.slack[1]) + inverse * real(r.slack[2]));
    }
    alignas(64) float xs[16], ys[16], depths[16], parts[3][16] = {};
    x.store(xs);
    y.store(ys);
    (depth - slack).store(depths);
    for (std::size_t c = 0; c < map.layers.size(); ++c) {
        for (int i = 0; i < std::min(lanes, L::kCount); ++i) {
            const MapPoint point{xs[i], ys[i], depths[i], r.depth_x, r.depth_y};
            parts[c][i] = visible_part_at(map, map.layers[c], point);
            if (map.moments && parts[c][i] > 0) parts[c][i] *= moment_part(map, point);
        }
    }
    const std::size_t green = map.layers.size() > 1 ? 1 : 0, blue = 2 * green;
    return {real::load(parts[0]), real::load(parts[green]), real::load(parts[blue])};
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SHADOW_LOOKUP_INL_H
