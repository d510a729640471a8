// What Z3 must answer, in double precision: N. Jouppi, C.-F. Chang, "Z3: an economical hardware
// technique for high-quality antialiasing and transparency", 1999. A few fragments are kept; of one
// too many, the two whose depths are closest become one.
#pragma once

#include <cstdint>
#include <span>

#include "raster/sample_pattern.h"
#include "reference/reference.h"

namespace sheer::reference {

// Where two that became one are: half way between, or at the nearer's place.
enum class Z3Depth { mean, front };

// One sample, fragments in the order of arrival. Neighbours by (depth, id) are compared; of pairs
// equally close the nearer one is joined: one over the other, with the nearer's id. Given
// `doubtful`, depths are floats, those between two others too; it is set where floats might choose
// another pair, as the differences of two have the same nearest float.
Rgba z3(std::span<const Fragment> fragments, int layers, Z3Depth depth, Rgba backdrop,
        bool* doubtful = nullptr);

// A fragment of a whole pixel.
struct SlopedFragment {
    Fragment fragment;                // its depth is that at the pixel's centre
    double slope_x = 0, slope_y = 0;  // what the depth grows by on a pixel to the right, and down
    std::uint64_t mask = 0;           // the samples that it covers, not 0
};

// The mean of the samples, each of which sorts the layers by their depths there, ties by id. Depths
// at the centre decide which two are joined and which of them is in front. The joined layer has the
// mean of the slopes, the union of the masks, and in all of its samples what these have on average:
// one over the other, or the only one.
Rgba z3_pixel(std::span<const SlopedFragment> fragments, int layers, Z3Depth depth,
              std::span<const SamplePoint> samples, Rgba backdrop);

}  // namespace sheer::reference
