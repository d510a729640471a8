// Multi-layer coverage blending: the layers of slab_tile-inl.h, of which the two farthest of one
// too many become one by shaders/sheer/mlcb.glsl. 28 bytes a layer and sample.
#include "methods/mlcb_settings.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/mlcb.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/slab_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct MlcbText : SlabText<L> {
    using Slab = SlabText<L>;
    using Slab::max;
    using Slab::slab_count;
    using Slab::slab_union;
    using Slab::slab_without;
    using Slab::to_real;
    using typename Slab::real;
    using typename Slab::SlabLayer;
#include "sheer/mlcb.glsl"
};

// Of SlabTile.
struct JoiningLayers {
    static constexpr bool kForgets = false;
    static SlabSettings settings(const ChosenMethod& method) { return mlcb_settings(method); }

    template <class Layers>
    static HWY_INLINE void fall(Layers& layers, std::size_t pixel, std::size_t s,
                                const typename Layers::Layer& fallen)
    {
        const std::size_t last = layers.most() - 1;
        const auto joined =
            MlcbText<typename Layers::L>::mlcb_join(layers.load(pixel, last, s), fallen);
        layers.save(joined, pixel, last, s);
    }
};

// Two words: up to 64 bits.
template <int S>
using MlcbTile = SlabTile<S, 2, JoiningLayers>;

StoreVerbs mlcb_store(int samples)
{
    return verbs_for_samples<MlcbTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(mlcb_store);

namespace {

StoreVerbs verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(mlcb_store, targets)(samples);
}

MethodTraits traits_of(const ChosenMethod& method)
{
    const SlabSettings settings = mlcb_settings(method);
    // No more layers than bits can be seen: none are joined.
    const bool is_stochastic =
        settings.keep == SlabKeep::purged && settings.layers >= settings.bits;
    MethodTraits traits;
    traits.random = true;
    traits.bytes_per_sample = 28 * settings.layers + (settings.corrects ? 4 : 0);
    traits.bytes_besides = 8;
    // Of a single bit the nearest that has it is all that shows.
    if (is_stochastic || settings.bits == 1) {
        traits.any_order = traits.merge = settings.corrects ? Agreement::rounding : Agreement::bits;
    }
    if (is_stochastic && !settings.corrects) traits.bias = Bias::unbiased;
    traits.divides = settings.corrects;
    return traits;
}

}  // namespace

MethodRow mlcb_row()
{
    return with_standard_traits(
        {.id = "mlcb",
         .title = "Multi-layer coverage blending, experimental: a reconstruction",
         .citation = "after Wyman. Exploring and Expanding the Continuum of OIT Algorithms. HPG "
                     "2016, which does not say how",
         .continuum = {"if its random bits are seen", "K layers with B bits",
                       "the two farthest become one",
                       "scaled to total alpha; none with correction=off"},
         .parameters = {{"layers", "1..32", "8", "kept at each sample, near to far"},
                        {"bits", "1..64", "32", "of a layer's random mask"},
                        {"keep", "purged|visible|nearest", "purged",
                         "layers that are seen; that were seen when they arrived; or any that "
                         "have a bit"},
                        {"correction", "off|on", "on",
                         "alpha correction: colours scaled to the exact total alpha"}},
         .traits = {},
         .verbs = verbs,
         .traits_of = traits_of});
}

}  // namespace sheer
#endif
