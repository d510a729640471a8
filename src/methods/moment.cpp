// Moment transparency: shaders/sheer/moment.glsl at every sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/moment.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/moment_settings.h"
#include "methods/reduced_pixels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Over doubles.
template <class L>
struct PowerMomentsText {
#include "lanes/text_words.h"
#include "sheer/power_moments.glsl"
};

template <class L>
struct MomentText {
#include "lanes/text_words.h"
#include "sheer/exponential.glsl"
#include "sheer/moment.glsl"
#include "sheer/moment_formats.glsl"
};

// With `Again` two curves, of which the second is of what the first lets be seen.
template <bool Again>
class MomentFunction {
public:
    static constexpr std::size_t kSums = 5, kCurve = 5, kState = Again ? 2 * kCurve : kCurve;

    explicit MomentFunction(const ChosenMethod& method) : settings_(moment_settings(method)) {}

    int passes() const { return settings_.passes; }

    template <class W>
    static HWY_INLINE void addends(typename W::real place, typename W::real depth,
                                   typename W::real (&addends)[kSums])
    {
        const typename W::real place2 = place * place, depth2 = depth * place2;
        addends[0] = depth;
        addends[1] = depth * place;
        addends[2] = depth2;
        addends[3] = depth2 * place;
        addends[4] = depth2 * place2;
    }

    // The second of two curves is one of nothing until there is more to say.
    template <class W>
    HWY_INLINE void prepare(const typename W::real (&sums)[kSums], float* state,
                            std::size_t stride) const
    {
        prepare_curve<W>(sums, state, stride);
        if constexpr (Again) {
            const typename W::real nothing[kSums] = {typename W::real(0.0), typename W::real(0.0),
                                                     typename W::real(0.0), typename W::real(0.0),
                                                     typename W::real(0.0)};
            prepare_curve<W>(nothing, state + kCurve * stride, stride);
        }
    }
    template <class W>
    HWY_INLINE void prepare_again(const typename W::real (&sums)[kSums], float* state,
                                  std::size_t stride) const requires(Again)
    {
        prepare_curve<W>(sums, state + kCurve * stride, stride);
    }

    // Of a reduced picture, where 16 bits are kept of each texel. What is mixed has its weights: a
    // texel of nothing has none.
    template <class W>
    HWY_INLINE void round_texels(typename W::real (&sums)[kSums]) const
    {
        if (settings_.format == MomentFormat::fp32) return;
        using Text = MomentText<Lanes<W::kCount>>;
        const typename W::real divisor = depth_divisor<W>(sums[0]);
        typename W::real m[9];
        for (std::size_t k = 0; k < kSums; ++k) m[k] = sums[k] / divisor;
        in_format<W>(m);
        sums[0] = widened<W>(Text::half_float(narrowed<W>(sums[0])));
        for (std::size_t k = 1; k < kSums; ++k) sums[k] = sums[0] * m[k];
    }

    template <class L, class State>
    HWY_INLINE typename L::real transmittance(const State& state, typename L::real place) const
    {
        auto through = transmittance_of<L>(state, 0, place);
        if constexpr (Again) through = through * transmittance_of<L>(state, kCurve, place);
        return through;
    }

private:
    template <class W>
    HWY_INLINE void prepare_curve(const typename W::real (&sums)[kSums], float* state,
                                  std::size_t stride) const
    {
        using Real = typename W::real;
        using Wide = PowerMomentsText<W>;
        using Text = MomentText<Lanes<W::kCount>>;
        typename Wide::PowerMoments m;
        const Real divisor = depth_divisor<W>(sums[0]);
        for (std::size_t k = 0; k < kSums; ++k) m.m[k] = sums[k] / divisor;
        const MomentFormat format =
            settings_.reduction > 1 ? MomentFormat::fp32 : settings_.format;  // of texels, then
        if (format == MomentFormat::fp16 || format == MomentFormat::unorm16) in_format<W>(m.m);
        const typename Wide::MomentBias bias{
            Real(settings_.bias), {Real(1), Real(settings_.even2), Real(settings_.even4)}};
        const auto r =
            Wide::recurrence_of(Wide::biased_moments(m, bias, 2), 2, Real(0.1 * settings_.bias));
        auto curve = Text::moment_curve(narrowed<W>(r.a[0]), narrowed<W>(r.a[1]),
                                        narrowed<W>(r.b[1]), narrowed<W>(r.b[2]),
                                        narrowed<W>(W::sqrt(r.b[1])), narrowed<W>(sums[0]));
        if (format != MomentFormat::fp32) curve.depth = Text::half_float(curve.depth);
        if (format == MomentFormat::nlqm) {
            curve = Text::curve_of_quantised(Text::quantised_moments(curve), curve.depth);
        }
        curve.mean.store(state);
        curve.inverse_deviation.store(state + stride);
        curve.skewness.store(state + 2 * stride);
        curve.sharpness.store(state + 3 * stride);
        curve.depth.store(state + 4 * stride);
    }

    template <class L, class State>
    HWY_INLINE typename L::real transmittance_of(const State& state, std::size_t curve_at,
                                                 typename L::real place) const
    {
        using Text = MomentText<L>;
        const typename Text::MomentCurve curve{state[curve_at], state[curve_at + 1],
                                               state[curve_at + 2], state[curve_at + 3],
                                               state[curve_at + 4]};
        const auto overestimation =
            settings_.adapts
                ? Text::moment_adaptive(curve, typename L::real(static_cast<float>(settings_.bias)))
                : typename L::real(settings_.overestimation);
        return Text::moment_transmittance(curve, place, overestimation);
    }

    // Moments as what is read of them.
    template <class W>
    HWY_INLINE void in_format(typename W::real (&m)[9]) const
    {
        using Text = MomentText<Lanes<W::kCount>>;
        typename Text::FourMoments b{narrowed<W>(m[1]), narrowed<W>(m[2]), narrowed<W>(m[3]),
                                     narrowed<W>(m[4])};
        b = settings_.format == MomentFormat::fp16 ? Text::moments_as_halves(b)
                                                   : Text::moments_as_unorm16(b);
        m[1] = widened<W>(b.b1);
        m[2] = widened<W>(b.b2);
        m[3] = widened<W>(b.b3);
        m[4] = widened<W>(b.b4);
    }

    MomentSettings settings_;
};

template <class Function>
struct ReducedStores {
    template <int S>
    using Pixels = ReducedPixels<S, Function>;
};

StoreVerbs moment_store(int samples, bool of_pixels, bool reduced, bool again)
{
    if (reduced) {
        return again ? verbs_for_samples<ReducedStores<MomentFunction<true>>::Pixels>(samples)
                     : verbs_for_samples<ReducedStores<MomentFunction<false>>::Pixels>(samples);
    }
    return again ? StoreOf<MomentFunction<true>>::make(samples, of_pixels)
                 : StoreOf<MomentFunction<false>>::make(samples, of_pixels);
}

ReducedVerbs reduced_moment_store(bool again)
{
    return again ? reduced_verbs_of<MomentFunction<true>>()
                 : reduced_verbs_of<MomentFunction<false>>();
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(moment_store);
HWY_EXPORT(reduced_moment_store);

StoreVerbs moment_verbs(TargetSet targets, const ChosenMethod& method, int samples)
{
    const MomentSettings settings = moment_settings(method);
    return SHEER_DISPATCH(moment_store, targets)(samples, method.value("store") == "pixel",
                                                 settings.reduction > 1, settings.passes == 2);
}

ReducedVerbs reduced_moment_verbs(TargetSet targets, const ChosenMethod& method)
{
    return SHEER_DISPATCH(reduced_moment_store, targets)(moment_settings(method).passes == 2);
}

}  // namespace sheer
#endif
