// Stratified stochastic transparency: stochastic transparency with masks that know of the surfaces
// before them.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/stratified_stochastic.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/stochastic_tile-inl.h"
#include "methods/tracked_masks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S>
using TrackedBasicTile = StochasticTile<S, TrackedMasks<S>>;

StoreVerbs stratified_stochastic_store(int samples)
{
    return verbs_for_samples<TrackedBasicTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(stratified_stochastic_store);

StoreVerbs stratified_stochastic_verbs(TargetSet targets, int samples)
{
    return SHEER_DISPATCH(stratified_stochastic_store, targets)(samples);
}

}  // namespace sheer
#endif
