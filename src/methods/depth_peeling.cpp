// Depth peeling: shaders/sheer/depth_peeling.glsl at every sample. 56 bytes a sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/depth_peeling.cpp"
#include "lanes/targets.h"

#include <limits>

#include <hwy/foreach_target.h>

#include "methods/peeling-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct DepthPeelingText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/layers.glsl"
#include "sheer/depth_peeling.glsl"
};

template <int S>
struct DepthPeelingMethod {
    using L = Lanes<S>;
    using Text = DepthPeelingText<PreciseLanes<S>>;
    using Store = typename Text::DepthPeel;
    using Layer = typename Text::Layer;
    using real3 = typename Text::real3;
    using real = typename L::real;
    using mask = typename L::mask;
    static constexpr int kChannels = 2 * kLayerChannels<Text>;

    static HWY_INLINE real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    static HWY_INLINE Store clear() { return Text::depth_peeling_clear(beyond_any()); }
    static HWY_INLINE Store begin(Store peel)
    {
        return Text::depth_peeling_begin(peel, beyond_any());
    }
    // In the same pass, behind the same layers.
    static HWY_INLINE Store merge(Store a, Store b)
    {
        return Text::depth_peeling_insert(a, b.nearest);
    }
    static HWY_INLINE bool wants(const RoughLayer<L>& f, const float* at, std::size_t samples)
    {
        const real front = real::load(at), nearest = real::load(at + kNearest * samples);
        const mask known = f.is(front, load_layer_id<Text>(at, samples));
        return (f.covered & !known & f.may_be_behind(front) & f.may_be_before(nearest)).any();
    }
    static HWY_INLINE bool insert(const Layer& f, float* at, std::size_t samples)
    {
        const Store peel = load(at, samples);
        if (!Text::depth_peeling_takes(peel, f).any()) return false;
        save_layer<Text>(Text::depth_peeling_insert(peel, f).nearest, at + kNearest * samples,
                         samples);
        return true;
    }
    static HWY_INLINE real3 resolve(Store peel, real3 backdrop, real& transmittance)
    {
        const Layer all = begin(peel).front;
        transmittance = real(1.0f) - all.opacity;
        return Text::layer_resolve(all, backdrop);
    }
    static HWY_INLINE Store load(const float* at, std::size_t samples)
    {
        return {load_layer<Text>(at, samples), load_layer<Text>(at + kNearest * samples, samples)};
    }
    static HWY_INLINE void save(const Store& peel, float* at, std::size_t samples)
    {
        save_layer<Text>(peel.front, at, samples);
        save_layer<Text>(peel.nearest, at + kNearest * samples, samples);
    }

private:
    static constexpr std::size_t kNearest = kLayerChannels<Text>;
};

template <int S>
using DepthPeelingTile = PeelingTile<S, DepthPeelingMethod<S>>;

StoreVerbs depth_peeling_store(int samples)
{
    return verbs_for_samples<DepthPeelingTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(depth_peeling_store);

StoreVerbs depth_peeling_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(depth_peeling_store, targets)(samples);
}

}  // namespace sheer
#endif
