// Multi-layer alpha blending: shaders/sheer/mlab.glsl at every sample. 24 bytes a layer and sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/mlab.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/layers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct MlabText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/layers.glsl"
#include "sheer/mlab.glsl"
};

template <int S>
class MlabTile {
    using Layers = LayerStore<S, MlabText>;
    using Text = typename Layers::Text;
    using real = typename Layers::real;

public:
    explicit MlabTile(const StoreShape& shape) : layers_(shape, shape.method->number("layers")) {}

    void clear(const TilePlace&) { layers_.clear(); }

    void insert(const FragmentStream& f, int) { layers_.insert(f, Falls{layers_}); }

    // No better than the order of the layers allows.
    void merge(const MlabTile& other) { layers_.merge(other.layers_, Falls{layers_}); }

    void resolve(SampleColors& backdrop) const
    {
        resolve_layers(layers_, backdrop,
                       [&](std::size_t pixel, std::size_t s, auto behind, real& transmittance)
                           HWY_ATTR {
                               const auto all = layers_.all(pixel, s);
                               transmittance = real(1.0f) - all.opacity;
                               return Text::layer_resolve(all, behind);
                           });
    }

private:
    struct Falls {
        Layers& layers;
        HWY_INLINE void operator()(std::size_t pixel, std::size_t s,
                                   const typename Layers::Layer& fallen) const
        {
            const std::size_t last = layers.most() - 1;
            layers.save(Text::mlab_merge(layers.load(pixel, last, s), fallen), pixel, last, s);
        }
    };

    Layers layers_;
};

StoreVerbs mlab_store(int samples)
{
    return verbs_for_samples<MlabTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(mlab_store);

StoreVerbs mlab_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(mlab_store, targets)(samples);
}

}  // namespace sheer
#endif
