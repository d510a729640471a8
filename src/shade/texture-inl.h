// Texture filtering, a vector of fragments at a time (docs/numerics.md, "Textures").
#if defined(SHEER_TEXTURE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_TEXTURE_INL_H
#undef SHEER_TEXTURE_INL_H
#else
#define SHEER_TEXTURE_INL_H
#endif

#include "lanes/lanes-inl.h"
#include "lanes/log2-inl.h"
#include "shade/surface.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct Texel {
    typename L::real r, g, b, a;
};

template <class L>
HWY_INLINE Texel<L> mix(const Texel<L>& from, const Texel<L>& to, typename L::real f)
{
    return {from.r + f * (to.r - from.r), from.g + f * (to.g - from.g),
            from.b + f * (to.b - from.b), from.a + f * (to.a - from.a)};
}

// Texture coordinates and how they change from one pixel to the next.
template <class L>
struct Footprint {
    typename L::real u, v;
    typename L::real u_x, v_x;  // to the right
    typename L::real u_y, v_y;  // down
};

// In [0, 1].
template <class L>
HWY_INLINE typename L::real wrapped(typename L::real u, Wrap wrap)
{
    using real = typename L::real;
    const real one(1.0f), two(2.0f);
    if (wrap == Wrap::repeat) u = u - L::floor(u);
    if (wrap == Wrap::mirrored_repeat) {
        const real t = u - two * L::floor(real(0.5f) * u);
        u = L::select(t > one, two - t, t);
    }
    // Infinite coordinates come out as no numbers before, and as 0 here.
    return L::min(L::max(u, real(0.0f)), one);
}

// Two neighbouring texels along one axis and how far on the way from the first to the second.
template <class L>
struct Neighbours {
    typename L::whole first, second;
    typename L::real f;
};

template <class L>
HWY_INLINE typename L::whole clamped(typename L::whole i, typename L::whole most)
{
    using whole = typename L::whole;
    i = L::select(i < whole(0), whole(0), i);
    return L::select(most < i, most, i);
}

// `size`: texels along the axis. Lanes that hold no fragment come out inside the image too.
template <class L>
HWY_INLINE Neighbours<L> neighbours(typename L::real u, typename L::whole size, Wrap wrap,
                                    bool linear)
{
    using real = typename L::real;
    using whole = typename L::whole;
    const whole most = size - whole(1);
    const real at = wrapped<L>(u, wrap) * L::to_real(size);
    if (!linear) {
        const whole i = clamped<L>(L::to_whole(at), most);
        return {i, i, real(0.0f)};
    }
    const real x = at - real(0.5f), low = L::floor(x);
    whole first = L::to_whole(low), second = first + whole(1);
    if (wrap == Wrap::repeat) {
        first = L::select(first < whole(0), most, first);
        second = L::select(most < second, whole(0), second);
    }
    return {clamped<L>(first, most), clamped<L>(second, most), x - low};
}

template <class L>
HWY_INLINE Texel<L> fetch(const MipChain& mips, typename L::whole texel)
{
    using real = typename L::real;
    using whole = typename L::whole;
    if (!mips.floats.empty()) {
        const float* at = mips.floats.data();
        const whole first = texel << 2;
        return {L::gather(at, first), L::gather(at + 1, first), L::gather(at + 2, first),
                L::gather(at + 3, first)};
    }
    const whole word = texel + texel;
    const whole rg = L::gather(mips.words.data(), word);
    const whole ba = L::gather(mips.words.data() + 1, word);
    const real scale(1.0f / 65535);  // 65535 times it is 1, rounded
    const whole half(0xffff);
    return {L::to_real(rg & half) * scale, L::to_real(rg.template shift_right<16>()) * scale,
            L::to_real(ba & half) * scale, L::to_real(ba.template shift_right<16>()) * scale};
}

template <class L>
HWY_NOINLINE Texel<L> sample_level(const PreparedTexture& texture, typename L::whole level,
                                   typename L::real u, typename L::real v, bool linear)
{
    using whole = typename L::whole;
    const MipChain& mips = *texture.mips;
    const whole width = L::gather(mips.width.data(), level);
    const whole height = L::gather(mips.height.data(), level);
    const whole first = L::gather(mips.first.data(), level);
    const Neighbours<L> x = neighbours<L>(u, width, texture.sampler.wrap_u, linear);
    const Neighbours<L> y = neighbours<L>(v, height, texture.sampler.wrap_v, linear);
    const whole above = first + y.first * width;
    if (!linear) return fetch<L>(mips, above + x.first);
    const whole below = first + y.second * width;
    const Texel<L> top =
        mix<L>(fetch<L>(mips, above + x.first), fetch<L>(mips, above + x.second), x.f);
    const Texel<L> bottom =
        mix<L>(fetch<L>(mips, below + x.first), fetch<L>(mips, below + x.second), x.f);
    return mix<L>(top, bottom, y.f);
}

// Where between the levels, and the probes.
template <class L>
struct Level {
    typename L::real level;  // not clamped
    typename L::real probes;
    typename L::real u, v;  // from the first end of the probes to the other
};

inline constexpr float kMostProbes = 8;

template <class L>
HWY_INLINE Level<L> choose_level(const PreparedTexture& texture, const Footprint<L>& at)
{
    using real = typename L::real;
    const auto width = static_cast<float>(texture.mips->width[0]);
    const auto height = static_cast<float>(texture.mips->height[0]);
    const real xu = at.u_x * real(width), xv = at.v_x * real(height);
    const real yu = at.u_y * real(width), yv = at.v_y * real(height);
    const real x = L::sqrt(xu * xu + xv * xv), y = L::sqrt(yu * yu + yv * yv);
    const auto x_is_longer = x >= y;
    const real longer = L::select(x_is_longer, x, y), shorter = L::select(x_is_longer, y, x);
    const real least(1e-10f), one(1.0f);  // a texture seen from nowhere has no level
    const Sampler& s = texture.sampler;
    if (s.minify != TexelFilter::linear || s.mip != MipFilter::linear) {
        return {log2<L>(L::max(longer, least)), one, real(0.0f), real(0.0f)};
    }
    const real across = L::max(shorter, longer * real(1.0f / kMostProbes));
    const real ratio =
        L::min(longer / L::max(shorter, real(1e-30f)), real(static_cast<float>(kMostProbes)));
    const real probes = real(0.0f) - L::floor(real(1.0f / 64) - ratio);
    return {log2<L>(L::max(across, least)), L::select(longer > one, L::max(probes, one), one),
            L::select(x_is_longer, at.u_x, at.u_y), L::select(x_is_longer, at.v_x, at.v_y)};
}

// At one point, between levels.
template <class L>
HWY_NOINLINE Texel<L> sample_between(const PreparedTexture& texture, typename L::real level,
                                     typename L::real u, typename L::real v)
{
    using real = typename L::real;
    using whole = typename L::whole;
    const Sampler& s = texture.sampler;
    const whole last(static_cast<std::int32_t>(texture.mips->level_count - 1));
    const auto magnified = level <= real(0.0f);
    // Clamped as a number first: it may be infinite.
    const real clamped_level = L::min(L::max(level, real(0.0f)), L::to_real(last));
    const bool minify_linear = s.minify == TexelFilter::linear;
    const bool magnify_linear = s.magnify == TexelFilter::linear;
    Texel<L> minified;
    if (s.mip == MipFilter::none) {
        minified = sample_level<L>(texture, whole(0), u, v, minify_linear);
    } else if (s.mip == MipFilter::nearest) {
        const whole nearest = clamped<L>(L::to_whole(L::floor(clamped_level + real(0.5f))), last);
        minified = sample_level<L>(texture, nearest, u, v, minify_linear);
    } else {
        const real low = L::floor(clamped_level), f = clamped_level - low;
        const whole level0 = clamped<L>(L::to_whole(low), last);
        minified = sample_level<L>(texture, level0, u, v, minify_linear);
        if ((f > real(0.0f)).any()) {
            const whole level1 = clamped<L>(level0 + whole(1), last);
            const Texel<L> next = sample_level<L>(texture, level1, u, v, minify_linear);
            minified = mix<L>(minified, next, f);
        }
    }
    if (minify_linear == magnify_linear || !magnified.any()) return minified;
    const Texel<L> large = sample_level<L>(texture, whole(0), u, v, magnify_linear);
    return {L::select(magnified, large.r, minified.r), L::select(magnified, large.g, minified.g),
            L::select(magnified, large.b, minified.b), L::select(magnified, large.a, minified.a)};
}

// `lanes`: how many hold a fragment.
template <class L>
HWY_NOINLINE Texel<L> sample_texture(const PreparedTexture& texture, const Footprint<L>& at,
                                     int lanes)
{
    using real = typename L::real;
    const Level<L> chosen = choose_level<L>(texture, at);
    const real one(1.0f), zero(0.0f);
    const auto active = L::iota() < typename L::whole(lanes);
    // Nor by what is no number, which is not above anything.
    const real probes = L::select(active && chosen.probes > one, chosen.probes, one);
    const int most = static_cast<int>(probes.greatest());
    if (most == 1) return sample_between<L>(texture, chosen.level, at.u, at.v);
    Texel<L> sum{zero, zero, zero, zero};
    for (int i = 0; i < most; ++i) {
        const real number(static_cast<float>(i));
        const real along = (number + real(0.5f)) / probes - real(0.5f);
        const Texel<L> texel = sample_between<L>(texture, chosen.level, at.u + along * chosen.u,
                                                 at.v + along * chosen.v);
        const auto counts = number < probes;
        sum.r = sum.r + L::zero_unless(counts, texel.r);
        sum.g = sum.g + L::zero_unless(counts, texel.g);
        sum.b = sum.b + L::zero_unless(counts, texel.b);
        sum.a = sum.a + L::zero_unless(counts, texel.a);
    }
    return {sum.r / probes, sum.g / probes, sum.b / probes, sum.a / probes};
}

// What alpha is to reach where a texture is read, as a part of what it is to reach in the image: of
// a chain that has thresholds, between those of the levels.
template <class L>
HWY_INLINE typename L::real threshold_at(const PreparedTexture& texture, const Footprint<L>& at)
{
    using real = typename L::real;
    using whole = typename L::whole;
    const MipFilter filter = texture.sampler.mip;
    if (filter == MipFilter::none) return real(1.0f);
    const MipChain& mips = *texture.mips;
    const whole last(static_cast<std::int32_t>(mips.level_count - 1));
    const real level = choose_level<L>(texture, at).level;
    const real clamped_level = L::min(L::max(level, real(0.0f)), L::to_real(last));
    const bool nearest = filter == MipFilter::nearest;
    const real low = L::floor(nearest ? clamped_level + real(0.5f) : clamped_level);
    const whole first = clamped<L>(L::to_whole(low), last);
    const real threshold = L::gather(mips.threshold.data(), first);
    if (nearest) return threshold;
    const whole second = clamped<L>(first + whole(1), last);
    return threshold +
           (clamped_level - low) * (L::gather(mips.threshold.data(), second) - threshold);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_TEXTURE_INL_H
