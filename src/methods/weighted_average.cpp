// Weighted average: shaders/sheer/weighted_average.glsl at every sample. 20 bytes a sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/weighted_average.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/samples-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct WeightedAverageText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/weighted_average.glsl"
};

template <int S>
struct WeightedAverageMethod {
    using L = Lanes<S>;
    using Text = WeightedAverageText<L>;
    using Store = typename Text::WeightedAverageStore;
    using real3 = typename Text::real3;
    using real = typename L::real;
    static constexpr int kChannels = 5;

    static HWY_INLINE Store clear() { return Text::weighted_average_clear(); }
    static HWY_INLINE Store merge(Store a, Store b) { return Text::weighted_average_merge(a, b); }
    static HWY_INLINE real3 resolve(Store s, real3 backdrop, real& transmittance)
    {
        transmittance = Text::weighted_average_transmittance(s);
        return Text::weighted_average_resolve(s, backdrop);
    }
    static HWY_INLINE Store load(const float* at, std::size_t samples)
    {
        return {load_color<Text>(at, samples), real::load(at + 3 * samples),
                real::load(at + 4 * samples)};
    }
    static HWY_INLINE void save(const Store& s, float* at, std::size_t samples)
    {
        save_color<Text>(s.color, at, samples);
        s.opacity.store(at + 3 * samples);
        s.count.store(at + 4 * samples);
    }
};

template <int S>
struct WeightedAverageTile : SampleStore<S, WeightedAverageMethod<S>> {
    using Base = SampleStore<S, WeightedAverageMethod<S>>;
    using Base::Base;
    using typename Base::real;
    using typename Base::Text;

    void insert(const FragmentStream& f, int)
    {
        this->update(f,
                     [](const StreamColumns& c, std::size_t i, auto store, auto covered) HWY_ATTR {
                         return Text::weighted_average_insert(store, covered, color_of<Text>(c, i),
                                                              real(c.opacity[i]));
                     });
    }
};

StoreVerbs weighted_average_store(int samples)
{
    return verbs_for_samples<WeightedAverageTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(weighted_average_store);

StoreVerbs weighted_average_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(weighted_average_store, targets)(samples);
}

}  // namespace sheer
#endif
