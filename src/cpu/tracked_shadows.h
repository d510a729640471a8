// A tile of a shadow map whose masks know of the surfaces before them: those of
// shaders/sheer/stratified_stochastic.glsl. What is kept depends on the fragments' order, which is
// that of submission.
#pragma once

#include <memory>

#include "cpu/shadow_store.h"
#include "lanes/targets.h"
#include "methods/method.h"

namespace sheer {

// What one thread has, tile after tile of one map: depth and primitive of each sample, which are 8
// bytes, and 20 bytes a texel.
class TrackedShadows {
public:
    virtual ~TrackedShadows() = default;
    // `frame`: of the picture that the map is for.
    virtual void begin(const ShadowTile& tile, const FrameOfPicture& frame) = 0;
    virtual void insert(const ShadowTile& tile, const FragmentStream& fragments) = 0;
    // What is kept goes to the map.
    virtual void end(const ShadowTile& tile) = 0;
};

inline bool is_tracked(ShadowMasks masks)
{
    return masks == ShadowMasks::tracked || masks == ShadowMasks::systematic;
}

std::unique_ptr<TrackedShadows> make_tracked_shadows(TargetSet targets, const ShadowMap& map,
                                                     const SampleSet& set, ShadowMasks masks);

}  // namespace sheer
