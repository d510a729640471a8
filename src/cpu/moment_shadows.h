// A tile of a map of moments of optical depth.
#pragma once

#include <memory>

#include "cpu/shadow_store.h"
#include "lanes/targets.h"

namespace sheer {

// Five sums a texel, of 8 bytes; the map's layer gets what is opaque alone. Streams of `capacity`
// fragments at most.
std::unique_ptr<ShadowTileStore> make_moment_shadows(TargetSet targets, const ShadowMap& map,
                                                     const SampleSet& set, int capacity);

}  // namespace sheer
