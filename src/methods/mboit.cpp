// Moment-based order-independent transparency with power moments: shaders/sheer/secular.glsl at
// every sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/mboit.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/gauss_form-inl.h"
#include "methods/transmittance_stores-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Of 2 Half moments.
template <int Half>
class PowerFunction {
public:
    static constexpr std::size_t kSums = 2 * Half + 1, kKept = 3 * Half + 1;

    explicit PowerFunction(const ChosenMethod& method) : settings_(mboit_settings(method)) {}

    template <class W>
    static HWY_INLINE void addends(typename W::real place, typename W::real depth,
                                   typename W::real (&addends)[kSums])
    {
        addends[0] = depth;
        for (std::size_t k = 1; k < kSums; ++k) addends[k] = addends[k - 1] * place;
    }

    template <class W>
    HWY_INLINE void prepare(const typename W::real (&sums)[kSums], float* to,
                            std::size_t stride) const
    {
        using Real = typename W::real;
        using Text = GaussText<W>;
        typename Text::PowerMoments m;
        const Real divisor = depth_divisor<W>(sums[0]);
        for (std::size_t k = 0; k < kSums; ++k) m.m[k] = sums[k] / divisor;
        if (settings_.rounded) round<W>(m.m);
        typename Text::MomentBias bias;
        bias.amount = Real(settings_.bias);
        for (std::size_t k = 0; k < 5; ++k) bias.even[k] = Real(settings_.even[k]);
        const auto r = Text::recurrence_of(Text::biased_moments(m, bias, Half), Half,
                                           Real(kLeast * settings_.bias));
        save_rule<Half, W>(Text::gauss_rule(r, Half), to, stride);
        sums[0].store(to + 3 * Half * stride);
    }

    template <class L>
    HWY_INLINE typename L::real transmittance(const KeptLanes<L>& kept,
                                              typename L::real place) const
    {
        using Text = SecularText<L>;
        using Real = typename L::real;
        const Real part = Text::secular_fraction(load_form<Half, L>(kept), Half, place,
                                                 Real(settings_.overestimation));
        return Text::exp_of(Real(0.0f) - kept[3 * Half] * part);
    }

private:
    // Of b_k, which the bias keeps above it in exact arithmetic.
    static constexpr double kLeast = 1e-4;

    template <class W>
    static HWY_INLINE void round(typename W::real (&m)[9])
    {
        using Text = SecularText<Lanes<W::kCount>>;
        if constexpr (Half == 2) {
            const auto b = Text::moments_as_unorm16(
                {narrowed<W>(m[1]), narrowed<W>(m[2]), narrowed<W>(m[3]), narrowed<W>(m[4])});
            m[1] = widened<W>(b.b1);
            m[2] = widened<W>(b.b2);
            m[3] = widened<W>(b.b3);
            m[4] = widened<W>(b.b4);
        } else {
            typename Text::RoundedNumbers odd = {}, even = {};
            for (std::size_t k = 0; k < Half; ++k) {
                odd.n[k] = narrowed<W>(m[2 * k + 1]);
                even.n[k] = narrowed<W>(m[2 * k + 2]);
            }
            odd = Text::odd_as_unorm16(odd, Half);
            even = Text::even_as_unorm16(even, Half);
            for (std::size_t k = 0; k < Half; ++k) {
                m[2 * k + 1] = widened<W>(odd.n[k]);
                m[2 * k + 2] = widened<W>(even.n[k]);
            }
        }
    }

    MboitSettings settings_;
};

StoreVerbs mboit_power_store(int half)
{
    switch (half) {
        case 2: return verbs_of<StoreOf<PowerFunction<2>>>();
        case 3: return verbs_of<StoreOf<PowerFunction<3>>>();
        default: return verbs_of<StoreOf<PowerFunction<4>>>();
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(mboit_power_store);

StoreVerbs mboit_trigonometric_verbs(TargetSet targets, int half);

StoreVerbs mboit_verbs(TargetSet targets, const ChosenMethod& method, int)
{
    const MboitSettings settings = mboit_settings(method);
    if (settings.trigonometric) return mboit_trigonometric_verbs(targets, settings.half);
    return SHEER_DISPATCH(mboit_power_store, targets)(settings.half);
}

}  // namespace sheer
#endif
