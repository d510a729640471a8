// Weighted blended order-independent transparency: shaders/sheer/wboit.glsl at every sample.
//
// A fragment's weight is that of the distance at its pixel's centre, as on a GPU. 20 bytes a
// sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/wboit.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/depth_range.h"
#include "methods/samples-inl.h"
#include "methods/weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct WboitText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/wboit.glsl"
#include "sheer/exponential.glsl"
#include "sheer/transmittance.glsl"
};

template <int S>
struct WboitMethod {
    using L = Lanes<S>;
    using Text = WboitText<L>;
    using Store = typename Text::WboitStore;
    using real3 = typename Text::real3;
    using real = typename L::real;
    static constexpr int kChannels = 5;

    static HWY_INLINE Store clear() { return Text::wboit_clear(); }
    static HWY_INLINE Store merge(Store a, Store b) { return Text::wboit_merge(a, b); }
    static HWY_INLINE real3 resolve(Store s, real3 backdrop, real& transmittance)
    {
        transmittance = s.transmittance;
        return Text::wboit_resolve(s, backdrop);
    }
    static HWY_INLINE Store load(const float* at, std::size_t samples)
    {
        return {load_color<Text>(at, samples), real::load(at + 3 * samples),
                real::load(at + 4 * samples)};
    }
    static HWY_INLINE void save(const Store& s, float* at, std::size_t samples)
    {
        save_color<Text>(s.color, at, samples);
        s.weight.store(at + 3 * samples);
        s.transmittance.store(at + 4 * samples);
    }
};

template <int S>
struct WboitTile : SampleStore<S, WboitMethod<S>> {
    using Base = SampleStore<S, WboitMethod<S>>;
    using typename Base::real;
    using typename Base::Text;

    int equation;
    bool scaled;  // the range of depths to what is drawn
    EyeSpace eye;
    DepthRange range;
    AlignedArray<float> weights;  // of the stream's fragments

    explicit WboitTile(const StoreShape& shape)
        : Base(shape),
          equation(equation_of(shape.method->value("weight"))),
          scaled(shape.method->value("weight") == "range"),
          eye(shape.eye),
          range(depth_range(shape.eye, true)),
          weights(shape.stream_capacity + FragmentStream::kSlack)
    {
    }

    static int equation_of(const std::string& weight)
    {
        if (weight == "range") return 10;
        return weight == "uniform" ? 0 : std::stoi(weight.substr(2));
    }

    void insert(const FragmentStream& f, int)
    {
        weigh_fragments(f, eye, weights, [&](auto depth, auto z, auto a) HWY_ATTR {
            const auto d = scaled ? place_in_range(depth) : buffer_depth(eye, z);
            return WboitText<WeightBlock>::wboit_weight(equation, z, d, a);
        });
        const float* weight = weights.data();
        this->update(
            f, [weight](const StreamColumns& c, std::size_t i, auto store, auto covered) HWY_ATTR {
                return Text::wboit_insert(store, covered, color_of<Text>(c, i), real(c.opacity[i]),
                                          real(weight[i]));
            });
    }

    // From 0 to 1 over what is drawn, by the logarithm of distance.
    template <class Real>
    HWY_INLINE Real place_in_range(Real depth) const
    {
        const Real half(0.5f);
        return half * WboitText<WeightBlock>::warped_depth(range.is_distance, depth,
                                                           Real(range.from), Real(range.scale)) +
               half;
    }
};

StoreVerbs wboit_store(int samples)
{
    return verbs_for_samples<WboitTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(wboit_store);

StoreVerbs wboit_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(wboit_store, targets)(samples);
}

}  // namespace sheer
#endif
