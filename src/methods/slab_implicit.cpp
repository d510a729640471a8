// Stochastic layered alpha blending without masks: implicit coverage, or bits without number.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/slab_implicit.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/slab_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S>
using ImplicitSlabTile = SlabTile<S, 0>;

StoreVerbs slab_implicit_store(int samples)
{
    return verbs_for_samples<ImplicitSlabTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(slab_implicit_store);

StoreVerbs slab_implicit_verbs(TargetSet targets, int samples)
{
    return SHEER_DISPATCH(slab_implicit_store, targets)(samples);
}

}  // namespace sheer
#endif
