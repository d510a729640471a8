// Stochastic layered alpha blending with masks of up to 32 bits.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/slab_words_1.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/slab_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S>
using SlabTile1 = SlabTile<S, 1>;

StoreVerbs slab_words_1_store(int samples)
{
    return verbs_for_samples<SlabTile1>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(slab_words_1_store);

StoreVerbs slab_words_1_verbs(TargetSet targets, int samples)
{
    return SHEER_DISPATCH(slab_words_1_store, targets)(samples);
}

}  // namespace sheer
#endif
