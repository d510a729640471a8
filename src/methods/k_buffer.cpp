// The k-buffer: shaders/sheer/k_buffer.glsl at every sample. 24 bytes a layer and sample, 16 more
// where what is emitted is kept in front.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/k_buffer.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/layers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct KBufferText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/layers.glsl"
#include "sheer/k_buffer.glsl"
};

template <int S>
class KBufferTile {
    using Layers = LayerStore<S, KBufferText>;
    using Layer = typename Layers::Layer;
    using Text = typename Layers::Text;
    using real = typename Layers::real;

public:
    explicit KBufferTile(const StoreShape& shape)
        : merge_(shape.method->value("merge")), layers_(shape, shape.method->number("layers"))
    {
        if (emits()) emitted_ = SampleValues<4>(shape.samples->count);
    }

    void clear(const TilePlace&)
    {
        layers_.clear();
        std::fill_n(emitted_.values.data(), emitted_.values.size(), 0.0f);
    }

    void insert(const FragmentStream& f, int)
    {
        layers_.insert(f, [&](std::size_t pixel, std::size_t s, const Layer& fallen)
                              HWY_ATTR { overflow(pixel, s, fallen); });
    }

    // No better than the order of the layers allows; what was emitted goes under what was here.
    void merge(const KBufferTile& other)
    {
        if (emits()) {
            for_each_vector<S>(emitted_.samples, [&](std::size_t pixel, std::size_t s) HWY_ATTR {
                save_emitted(Text::layer_over(emitted(pixel, s), other.emitted(pixel, s)), pixel,
                             s);
            });
        }
        layers_.merge(other.layers_, [&](std::size_t pixel, std::size_t s, const Layer& fallen)
                                         HWY_ATTR { overflow(pixel, s, fallen); });
    }

    void resolve(SampleColors& backdrop) const
    {
        resolve_layers(layers_, backdrop,
                       [&](std::size_t pixel, std::size_t s, auto behind, real& transmittance)
                           HWY_ATTR {
                               Layer all = layers_.all(pixel, s);
                               if (emits()) all = Text::layer_over(emitted(pixel, s), all);
                               transmittance = real(1.0f) - all.opacity;
                               return Text::layer_resolve(all, behind);
                           });
    }

private:
    bool emits() const { return merge_ == "front"; }

    HWY_INLINE void overflow(std::size_t pixel, std::size_t s, const Layer& fallen)
    {
        if (merge_ == "discard") return;
        const auto overflows = Text::k_buffer_overflows(fallen, Layers::beyond_any());
        if (!overflows.any()) return;
        const Layer nearest = layers_.load(pixel, 0, s);
        const std::size_t last = layers_.most() - 1;
        Layer here = nearest;
        for (std::size_t i = 0; i <= last; ++i) {
            const Layer next = i < last ? layers_.load(pixel, i + 1, s) : fallen;
            layers_.save(Text::layer_select(overflows, next, here), pixel, i, s);
            here = next;
        }
        if (emits()) {
            save_emitted(Text::k_buffer_join(overflows, emitted(pixel, s), nearest), pixel, s);
        } else {
            const Layer joined = Text::k_buffer_join(overflows, nearest, layers_.load(pixel, 0, s));
            layers_.save(joined, pixel, 0, s);
        }
    }

    HWY_INLINE Layer emitted(std::size_t pixel, std::size_t s) const
    {
        const std::size_t samples = layers_.count();
        Layer e = Text::layer_clear(Layers::beyond_any());
        e.color = load_color<Text>(emitted_.channel(pixel, 0) + s, samples);
        e.opacity = real::load(emitted_.channel(pixel, 3) + s);
        return e;
    }
    HWY_INLINE void save_emitted(const Layer& e, std::size_t pixel, std::size_t s)
    {
        save_color<Text>(e.color, emitted_.channel(pixel, 0) + s, layers_.count());
        e.opacity.store(emitted_.channel(pixel, 3) + s);
    }

    const std::string merge_;
    Layers layers_;
    SampleValues<4> emitted_;  // colour and opacity
};

StoreVerbs k_buffer_store(int samples)
{
    return verbs_for_samples<KBufferTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(k_buffer_store);

StoreVerbs k_buffer_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(k_buffer_store, targets)(samples);
}

}  // namespace sheer
#endif
