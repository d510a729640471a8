// Stochastic transparency with masks that depend on their fragments alone.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/stochastic.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/stochastic_masks-inl.h"
#include "methods/stochastic_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S>
using BasicTile = StochasticTile<S, StochasticMasks>;

StoreVerbs stochastic_store(int samples)
{
    return verbs_for_samples<BasicTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(stochastic_store);

StoreVerbs stochastic_verbs(TargetSet targets, int samples)
{
    return SHEER_DISPATCH(stochastic_store, targets)(samples);
}

}  // namespace sheer
#endif
