// Moment transparency: shaders/sheer/moment.glsl at every sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/moment.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/moment_settings.h"
#include "methods/transmittance_stores-inl.h"

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

// Where there are two passes over the moments there are two curves, of which the second is of what
// the first lets be seen.
class MomentFunction {
public:
    static constexpr std::size_t kSums = 5, kKept = 5;

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
    HWY_INLINE void prepare(const typename W::real (&sums)[kSums], float* to, std::size_t stride,
                            bool is_first) const
    {
        for (int curve = is_first ? 0 : 1; curve < passes(); ++curve) {
            typename W::real some[kSums];
            const bool nothing = is_first && curve > 0;
            for (std::size_t k = 0; k < kSums; ++k) {
                some[k] = nothing ? typename W::real(0.0) : sums[k];
            }
            prepare_curve<W>(some, to + static_cast<std::size_t>(curve) * kKept * stride, stride);
        }
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

    template <class L>
    HWY_INLINE typename L::real transmittance(const KeptLanes<L>& kept,
                                              typename L::real place) const
    {
        typename L::real through(1.0f);
        for (int curve = 0; curve < passes(); ++curve) {
            const auto first = static_cast<std::size_t>(curve) * kKept;
            through = through * transmittance_of<L>(kept, first, place);
        }
        return through;
    }

private:
    template <class W>
    HWY_INLINE void prepare_curve(const typename W::real (&sums)[kSums], float* to,
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
        curve.mean.store(to);
        curve.inverse_deviation.store(to + stride);
        curve.skewness.store(to + 2 * stride);
        curve.sharpness.store(to + 3 * stride);
        curve.depth.store(to + 4 * stride);
    }

    template <class L>
    HWY_INLINE typename L::real transmittance_of(const KeptLanes<L>& kept, std::size_t first,
                                                 typename L::real place) const
    {
        using Text = MomentText<L>;
        const typename Text::MomentCurve curve{kept[first], kept[first + 1], kept[first + 2],
                                               kept[first + 3], kept[first + 4]};
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

StoreVerbs moment_store()
{
    return verbs_of<StoreOf<MomentFunction>>();
}

ReducedVerbs reduced_moment_store()
{
    return reduced_verbs_of<MomentFunction>();
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(moment_store);
HWY_EXPORT(reduced_moment_store);

StoreVerbs moment_verbs(TargetSet targets, const ChosenMethod& method, int)
{
    StoreVerbs verbs = SHEER_DISPATCH(moment_store, targets)();
    // The functions are the reduced picture's.
    if (moment_settings(method).reduction > 1) verbs.transmittance = nullptr;
    return verbs;
}

ReducedVerbs reduced_moment_verbs(TargetSet targets, const ChosenMethod&)
{
    return SHEER_DISPATCH(reduced_moment_store, targets)();
}

}  // namespace sheer
#endif
