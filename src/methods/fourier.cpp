// Fourier opacity maps: shaders/sheer/fourier.glsl at every sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/fourier.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/transmittance_stores-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct FourierText {
#include "lanes/text_words.h"
#include "sheer/exponential.glsl"
#include "sheer/fourier.glsl"
};

template <int Terms>
class FourierFunction {
public:
    static constexpr std::size_t kSums = 2 * Terms + 1, kKept = kSums;

    explicit FourierFunction(const ChosenMethod& method)
        : damped_(method.value("window") == "lanczos")
    {
    }

    template <class W>
    static HWY_INLINE void addends(typename W::real place, typename W::real depth,
                                   typename W::real (&addends)[kSums])
    {
        using Text = FourierText<Lanes<W::kCount>>;
        const auto angles = Text::fourier_angles(narrowed<W>(place), Terms);
        addends[0] = depth;
        for (std::size_t k = 1; k <= Terms; ++k) {
            addends[2 * k - 1] = depth * widened<W>(angles.cosine[k]);
            addends[2 * k] = depth * widened<W>(angles.sine[k]);
        }
    }

    template <class W>
    HWY_INLINE void prepare(const typename W::real (&sums)[kSums], float* to,
                            std::size_t stride) const
    {
        using Text = FourierText<Lanes<W::kCount>>;
        typename Text::FourierSeries series = {};
        series.depth = narrowed<W>(sums[0]);
        for (std::size_t k = 1; k <= Terms; ++k) {
            series.cosine[k] = narrowed<W>(sums[2 * k - 1]);
            series.sine[k] = narrowed<W>(sums[2 * k]);
        }
        series = Text::fourier_series(series, Terms, damped_);
        series.depth.store(to);
        for (std::size_t k = 1; k <= Terms; ++k) {
            series.cosine[k].store(to + (2 * k - 1) * stride);
            series.sine[k].store(to + 2 * k * stride);
        }
    }

    template <class L>
    HWY_INLINE typename L::real transmittance(const KeptLanes<L>& kept,
                                              typename L::real place) const
    {
        using Text = FourierText<L>;
        typename Text::FourierSeries series;
        series.depth = kept[0];
        for (std::size_t k = 1; k <= Terms; ++k) {
            series.cosine[k] = kept[2 * k - 1];
            series.sine[k] = kept[2 * k];
        }
        return Text::fourier_transmittance(series, place, Terms);
    }

private:
    bool damped_;
};

StoreVerbs fourier_store(int terms)
{
    if (terms == 3) return verbs_of<StoreOf<FourierFunction<3>>>();
    return verbs_of<StoreOf<FourierFunction<7>>>();
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(fourier_store);

StoreVerbs fourier_verbs(TargetSet targets, const ChosenMethod& method, int)
{
    return SHEER_DISPATCH(fourier_store, targets)(method.number("terms"));
}

}  // namespace sheer
#endif
