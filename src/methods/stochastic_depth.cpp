// Depth-based stochastic transparency with masks that depend on their fragments alone.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/stochastic_depth.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/stochastic_depth_tile-inl.h"
#include "methods/stochastic_masks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S>
using DepthTile = StochasticDepthTile<S, StochasticMasks>;

StoreVerbs stochastic_depth_store(int samples)
{
    return verbs_for_samples<DepthTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(stochastic_depth_store);

StoreVerbs stochastic_depth_verbs(TargetSet targets, int samples)
{
    return SHEER_DISPATCH(stochastic_depth_store, targets)(samples);
}

}  // namespace sheer
#endif
