// Moment-based order-independent transparency with trigonometric moments:
// shaders/sheer/circle_fraction.glsl at every sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/mboit_trigonometric.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/gauss_form-inl.h"
#include "methods/transmittance_stores-inl.h"
#include "methods/wrapping_zone.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Of M complex moments.
template <int M>
class TrigonometricFunction {
public:
    static constexpr std::size_t kSums = 2 * M + 1, kKept = 4 * M + 2;

    explicit TrigonometricFunction(const ChosenMethod& method) : settings_(mboit_settings(method))
    {
    }

    template <class W>
    HWY_INLINE void addends(typename W::real place, typename W::real depth,
                            typename W::real (&addends)[kSums]) const
    {
        using Text = GaussText<W>;
        const auto b = Text::trigonometric_moments(
            Text::half_angle(place * typename W::real(zone_.half_depth)), M);
        addends[0] = depth;
        for (std::size_t j = 1; j <= M; ++j) {
            addends[2 * j - 1] = depth * b.cosine[j];
            addends[2 * j] = depth * b.sine[j];
        }
    }

    template <class W>
    HWY_INLINE void prepare(const typename W::real (&sums)[kSums], float* to,
                            std::size_t stride) const
    {
        using Real = typename W::real;
        using Text = GaussText<W>;
        const Real divisor = depth_divisor<W>(sums[0]);
        typename Text::TrigonometricMoments b;
        b.cosine[0] = Real(1);
        b.sine[0] = Real(0);
        for (std::size_t j = 1; j <= M; ++j) {
            b.cosine[j] = in_format<W>(sums[2 * j - 1] / divisor);
            b.sine[j] = in_format<W>(sums[2 * j] / divisor);
        }
        const auto line =
            Text::line_moments(Text::biased_trigonometric(b, M, Real(settings_.bias)), M);
        const auto r = Text::recurrence_of(line.power, M, Real(kLeast * settings_.bias));
        const auto rule = Text::gauss_rule(r, M);
        for (std::size_t k = 0; k < M; ++k) {
            rule.point[k].store(to + k * stride);
            rule.strength[k].store(to + (M + k) * stride);
            r.a[k].store(to + (2 * M + k) * stride);
            W::sqrt(r.b[k + 1]).store(to + (3 * M + k) * stride);
        }
        line.mass.store(to + 4 * M * stride);
        sums[0].store(to + (4 * M + 1) * stride);
    }

    template <class L>
    HWY_INLINE typename L::real transmittance(const KeptLanes<L>& kept,
                                              typename L::real place) const
    {
        using Text = SecularText<L>;
        using Real = typename L::real;
        typename Text::CircleForm form;
        for (std::size_t k = 0; k < M; ++k) {
            form.line.point[k] = kept[k];
            form.line.strength[k] = kept[M + k];
            form.line.share[k] = Real(0.0f);
            form.a[k] = kept[2 * M + k];
            form.root[k + 1] = kept[3 * M + k];
        }
        form.mass = kept[4 * M];
        const auto real = [](double x) HWY_ATTR { return Real(static_cast<float>(x)); };
        const typename Text::WrappingZone zone{real(zone_.half_depth), real(zone_.rest),
                                               real(zone_.edge),       real(zone_.cosine),
                                               real(zone_.sine),       real(zone_.begins)};
        const Real part =
            Text::circle_fraction(form, M, zone, place, Real(settings_.overestimation));
        return Text::exp_of(Real(0.0f) - kept[4 * M + 1] * part);
    }

private:
    // Of b_k in units in which those of one depth are the bias, or less where that lies far out.
    static constexpr double kLeast = 1e-6;

    // As the paper's 16 bits have numbers from -1 to 1.
    template <class W>
    HWY_INLINE typename W::real in_format(typename W::real x) const
    {
        if (!settings_.rounded) return x;
        using Text = SecularText<Lanes<W::kCount>>;
        using Real = typename Text::real;
        const Real half(0.5f), number = Text::unorm16(half * narrowed<W>(x) + half);
        return widened<W>((number - half) * Real(2.0f));
    }

    MboitSettings settings_;
    WrappingZone zone_ = wrapping_zone();
};

StoreVerbs mboit_trigonometric_store(int half)
{
    switch (half) {
        case 2: return verbs_of<StoreOf<TrigonometricFunction<2>>>();
        case 3: return verbs_of<StoreOf<TrigonometricFunction<3>>>();
        default: return verbs_of<StoreOf<TrigonometricFunction<4>>>();
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(mboit_trigonometric_store);

StoreVerbs mboit_trigonometric_verbs(TargetSet targets, int half)
{
    return SHEER_DISPATCH(mboit_trigonometric_store, targets)(half);
}

}  // namespace sheer
#endif
