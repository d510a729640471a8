// The picture that every method is measured against.
#pragma once

#include <sheer/render.h>
#include <sheer/scene.h>

namespace sheer {

inline constexpr int kTruthPasses = 4;

// `exact` with 64 samples a pixel times `passes` (1 to 16), whatever view.samples says: the mean of
// passes whose samples are shifted against one another so that all are evenly spread, each shaded
// by itself, and no surface conservatively. With the usual 4 no two of a pixel's 256 samples share
// a column or a row of the 1/256 pixel grid. Samples at the pixel's centre are all alike, and one
// pass is all. Of the options, threads, simd, memory_limit (of which the caller needs
// `reserved_memory` besides) and progress count.
Image render_truth(const Scene& scene, const View& view, const Options& options,
                   int passes = kTruthPasses, std::uint64_t reserved_memory = 0);

// Of which that is the mean, a pixel.
int truth_samples(const View& view, int passes = kTruthPasses);

}  // namespace sheer
