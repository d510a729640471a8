// Stochastic layered alpha blending with masks of up to 128 bits.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/slab_words_4.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/slab_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S>
using SlabTile4 = SlabTile<S, 4>;

StoreVerbs slab_words_4_store(int samples)
{
    return verbs_for_samples<SlabTile4>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(slab_words_4_store);

StoreVerbs slab_words_4_verbs(TargetSet targets, int samples)
{
    return SHEER_DISPATCH(slab_words_4_store, targets)(samples);
}

}  // namespace sheer
#endif
