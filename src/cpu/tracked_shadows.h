// A tile of a shadow map whose masks know of the surfaces before them: those of
// shaders/sheer/stratified_stochastic.glsl. What is kept depends on the fragments' order, which is
// that of submission.
#pragma once

#include <memory>

#include "cpu/shadow_store.h"
#include "lanes/targets.h"

namespace sheer {

inline bool is_tracked(ShadowMasks masks)
{
    return masks == ShadowMasks::tracked || masks == ShadowMasks::systematic;
}

// Depth and primitive of each sample, which are 8 bytes, and 20 bytes a texel.
std::unique_ptr<ShadowTileStore> make_tracked_shadows(TargetSet targets, const ShadowMap& map,
                                                      const SampleSet& set, ShadowMasks masks);

}  // namespace sheer
