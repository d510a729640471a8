// Dual depth peeling: shaders/sheer/dual_depth_peeling.glsl at every sample. 112 bytes a sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/dual_depth_peeling.cpp"
#include "lanes/targets.h"

#include <limits>

#include <hwy/foreach_target.h>

#include "methods/peeling-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct DualPeelingText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/layers.glsl"
#include "sheer/dual_depth_peeling.glsl"
};

template <int S>
struct DualPeelingMethod {
    using L = Lanes<S>;
    using Text = DualPeelingText<PreciseLanes<S>>;
    using Store = typename Text::DualPeel;
    using Layer = typename Text::Layer;
    using real3 = typename Text::real3;
    using real = typename L::real;
    using mask = typename L::mask;
    static constexpr int kChannels = 4 * kLayerChannels<Text>;

    static HWY_INLINE real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    static HWY_INLINE Store clear() { return Text::dual_peeling_clear(beyond_any()); }
    static HWY_INLINE Store begin(Store peel)
    {
        return Text::dual_peeling_begin(peel, beyond_any());
    }
    // In the same pass, between the same layers.
    static HWY_INLINE Store merge(Store a, Store b)
    {
        return Text::dual_peeling_insert(Text::dual_peeling_insert(a, b.nearest), b.farthest);
    }
    static HWY_INLINE bool wants(const RoughLayer<L>& f, const float* at, std::size_t samples)
    {
        const float* const at_back = at + kBack * samples;
        const real front = real::load(at), back = real::load(at_back);
        const mask known = f.is(front, load_layer_id<Text>(at, samples)) |
                           f.is(back, load_layer_id<Text>(at_back, samples));
        const mask new_end = f.may_be_before(real::load(at + kNearest * samples)) |
                             f.may_be_behind(real::load(at + kFarthest * samples));
        return (f.covered & !known & f.may_be_behind(front) & f.may_be_before(back) & new_end)
            .any();
    }
    static HWY_INLINE bool insert(const Layer& f, float* at, std::size_t samples)
    {
        const Store peel = load(at, samples);
        const auto between = Text::dual_peeling_between(peel, f);
        if (!between.any()) return false;
        const Store taken = Text::dual_peeling_insert(peel, f);
        save_layer<Text>(taken.nearest, at + kNearest * samples, samples);
        save_layer<Text>(taken.farthest, at + kFarthest * samples, samples);
        return true;
    }
    static HWY_INLINE real3 resolve(Store peel, real3 backdrop, real& transmittance)
    {
        const Store last = begin(peel);
        const Layer all = Text::layer_over(last.front, last.back);
        transmittance = real(1.0f) - all.opacity;
        return Text::layer_resolve(all, backdrop);
    }
    static HWY_INLINE Store load(const float* at, std::size_t samples)
    {
        Store peel;
        peel.front = load_layer<Text>(at, samples);
        peel.back = load_layer<Text>(at + kBack * samples, samples);
        peel.nearest = load_layer<Text>(at + kNearest * samples, samples);
        peel.farthest = load_layer<Text>(at + kFarthest * samples, samples);
        return peel;
    }
    static HWY_INLINE void save(const Store& peel, float* at, std::size_t samples)
    {
        save_layer<Text>(peel.front, at, samples);
        save_layer<Text>(peel.back, at + kBack * samples, samples);
        save_layer<Text>(peel.nearest, at + kNearest * samples, samples);
        save_layer<Text>(peel.farthest, at + kFarthest * samples, samples);
    }

private:
    static constexpr std::size_t kBack = kLayerChannels<Text>, kNearest = 2 * kBack,
                                 kFarthest = 3 * kBack;
};

template <int S>
using DualPeelingTile = PeelingTile<S, DualPeelingMethod<S>>;

StoreVerbs dual_depth_peeling_store(int samples)
{
    return verbs_for_samples<DualPeelingTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(dual_depth_peeling_store);

StoreVerbs dual_depth_peeling_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(dual_depth_peeling_store, targets)(samples);
}

}  // namespace sheer
#endif
