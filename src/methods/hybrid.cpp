// Hybrid transparency: shaders/sheer/hybrid.glsl at every sample. 24 bytes a layer and sample, and
// as many for the tail.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/hybrid.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/layers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct HybridText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/weighted_average.glsl"
#include "sheer/layers.glsl"
#include "sheer/hybrid.glsl"
};

// How a tail lies in memory.
template <int S>
struct HybridTailMethod {
    using L = Lanes<S>;
    using Text = HybridText<L>;
    using Store = typename Text::HybridTail;
    using real = typename L::real;
    static constexpr int kChannels = 6;

    static HWY_INLINE Store clear() { return Text::hybrid_clear(); }
    static HWY_INLINE Store merge(Store a, Store b) { return Text::hybrid_merge(a, b); }
    static HWY_INLINE Store load(const float* at, std::size_t samples)
    {
        Store tail;
        tail.sum.color = load_color<Text>(at, samples);
        tail.sum.opacity = real::load(at + 3 * samples);
        tail.sum.count = real::load(at + 4 * samples);
        tail.transmittance = real::load(at + 5 * samples);
        return tail;
    }
    static HWY_INLINE void save(const Store& tail, float* at, std::size_t samples)
    {
        save_color<Text>(tail.sum.color, at, samples);
        tail.sum.opacity.store(at + 3 * samples);
        tail.sum.count.store(at + 4 * samples);
        tail.transmittance.store(at + 5 * samples);
    }
};

template <int S>
class HybridTile {
    using Layers = LayerStore<S, HybridText>;
    using Text = typename Layers::Text;
    using real = typename Layers::real;
    using Tails = SampleStore<S, HybridTailMethod<S>>;

public:
    explicit HybridTile(const StoreShape& shape)
        : kind_(kind_of(shape.method->value("tail"))),
          layers_(shape, shape.method->number("layers")),
          tails_(shape)
    {
    }

    void clear(const TilePlace&)
    {
        layers_.clear();
        tails_.clear();
    }

    void insert(const FragmentStream& f, int) { layers_.insert(f, Falls{tails_}); }

    void merge(const HybridTile& other)
    {
        tails_.merge(other.tails_);
        layers_.merge(other.layers_, Falls{tails_});
    }

    void resolve(SampleColors& backdrop) const
    {
        resolve_layers(layers_, backdrop,
                       [&](std::size_t pixel, std::size_t s, auto behind, real& transmittance)
                           HWY_ATTR {
                               const auto core = layers_.all(pixel, s);
                               const auto tail = tails_.load(pixel, s);
                               transmittance = Text::hybrid_transmittance(kind_, core, tail);
                               return Text::hybrid_resolve(kind_, core, tail, behind);
                           });
    }

private:
    struct Falls {
        Tails& tails;
        HWY_INLINE void operator()(std::size_t pixel, std::size_t s,
                                   const typename Layers::Layer& fallen) const
        {
            tails.save(Text::hybrid_add(tails.load(pixel, s), fallen, Layers::beyond_any()), pixel,
                       s);
        }
    };

    static int kind_of(const std::string& tail)
    {
        return tail == "maule" ? 0 : tail == "total" ? 1 : tail == "none" ? 2 : 3;
    }

    int kind_;
    Layers layers_;
    Tails tails_;
};

StoreVerbs hybrid_store(int samples)
{
    return verbs_for_samples<HybridTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(hybrid_store);

StoreVerbs hybrid_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(hybrid_store, targets)(samples);
}

}  // namespace sheer
#endif
