// Alpha blending in the order of arrival: shaders/sheer/blend.glsl at every sample.
//
// The baseline of every comparison, as the scene submits its triangles; sorted-blend is the same
// over triangles that were sorted before. 16 bytes a sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/blend.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/samples-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct BlendText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/blend.glsl"
};

template <int S>
struct BlendMethod {
    using L = Lanes<S>;
    using Text = BlendText<L>;
    using Store = typename Text::BlendStore;
    using real3 = typename Text::real3;
    using real = typename L::real;
    static constexpr int kChannels = 4;

    static HWY_INLINE Store clear() { return Text::blend_clear(); }
    static HWY_INLINE Store merge(Store s, Store later) { return Text::blend_merge(s, later); }
    static HWY_INLINE real3 resolve(Store s, real3 backdrop, real& transmittance)
    {
        transmittance = s.transmittance;
        return Text::blend_resolve(s, backdrop);
    }
    static HWY_INLINE Store load(const float* at, std::size_t samples)
    {
        return {load_color<Text>(at, samples), real::load(at + 3 * samples)};
    }
    static HWY_INLINE void save(const Store& s, float* at, std::size_t samples)
    {
        save_color<Text>(s.color, at, samples);
        s.transmittance.store(at + 3 * samples);
    }
};

template <int S>
struct BlendTile : SampleStore<S, BlendMethod<S>> {
    using Base = SampleStore<S, BlendMethod<S>>;
    using Base::Base;
    using typename Base::real;
    using typename Base::Text;

    void insert(const FragmentStream& f, int)
    {
        this->update(
            f, [](const StreamColumns& c, std::size_t i, auto store, auto covered) HWY_ATTR {
                return Text::blend_insert(store, covered, color_of<Text>(c, i), real(c.opacity[i]));
            });
    }
};

StoreVerbs blend_store(int samples)
{
    return verbs_for_samples<BlendTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(blend_store);

StoreVerbs blend_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(blend_store, targets)(samples);
}

FragmentWants sorted_blend_wants(const ChosenMethod& method)
{
    FragmentWants wants;
    wants.submission =
        method.value("by") == "object" ? Submission::objects_sorted : Submission::triangles_sorted;
    return wants;
}

}  // namespace sheer
#endif
