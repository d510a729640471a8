// Z3: shaders/sheer/z3.glsl at every sample. 24 bytes a layer and sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/z3.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/layers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct Z3Text {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/layers.glsl"
#include "sheer/z3.glsl"
};

template <int S>
class Z3Tile {
    using Layers = LayerStore<S, Z3Text>;
    using Layer = typename Layers::Layer;
    using Text = typename Layers::Text;
    using real = typename Layers::real;
    using whole = typename Layers::whole;

public:
    explicit Z3Tile(const StoreShape& shape) : layers_(shape, shape.method->number("layers")) {}

    void clear(const TilePlace&) { layers_.clear(); }

    void insert(const FragmentStream& f, int) { layers_.insert(f, Falls{layers_}); }

    // No better than the order of the layers allows.
    void merge(const Z3Tile& other) { layers_.merge(other.layers_, Falls{layers_}); }

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

        HWY_INLINE void operator()(std::size_t pixel, std::size_t s, const Layer& fallen) const
        {
            const real beyond_any = Layers::beyond_any();
            if (!(fallen.depth < beyond_any).any()) return;
            const std::size_t most = layers.most();
            auto choice = Text::z3_no_choice();
            Layer here = layers.load(pixel, 0, s);
            for (std::size_t i = 0; i + 1 < most; ++i) {
                const Layer next = layers.load(pixel, i + 1, s);
                choice = Text::z3_choose(choice, number(i), here, next);
                here = next;
            }
            choice = Text::z3_choose_last(choice, number(most), here, fallen, beyond_any);
            here = layers.load(pixel, 0, s);
            for (std::size_t i = 0; i < most; ++i) {
                const Layer next = i + 1 < most ? layers.load(pixel, i + 1, s) : fallen;
                layers.save(Text::z3_join(choice, number(i), here, next), pixel, i, s);
                here = next;
            }
        }
        static HWY_INLINE whole number(std::size_t i)
        {
            return whole(static_cast<std::uint32_t>(i));
        }
    };

    Layers layers_;
};

StoreVerbs z3_store(int samples)
{
    return verbs_for_samples<Z3Tile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(z3_store);

StoreVerbs z3_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(z3_store, targets)(samples);
}

}  // namespace sheer
#endif
