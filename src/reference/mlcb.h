// What multi-layer coverage blending must answer, in double precision. Its paper (C. Wyman,
// "Exploring and expanding the continuum of OIT algorithms", 2016) says of it that it decorrelates
// visibility and opacity in multi-layer alpha blending; how is a reconstruction here: the layers
// of multi-layer alpha blending carry masks, as in reference/slab.h, and a layer is seen as far as
// its mask's bits are in none in front of it.
#pragma once

#include <span>
#include <vector>

#include "reference/slab.h"

namespace sheer::reference {

struct MlcbLayer {
    double depth = 0;
    std::uint32_t id = 0;
    double color[3] = {0, 0, 0};  // straight
    SlabMask mask;
};

// Fragments in the order of arrival with masks[i] that of fragments[i], 1 <= b <= 128. Of k + 1
// layers the two farthest, A in front of B, become one at A's place, with the union of the masks
// and the mean of the colours, A's weighted by A's bits and B's by those that A has not. `keep`
// says which layers are left out or dropped before that: the hidden ones, or none.
std::vector<MlcbLayer> mlcb_layers(std::span<const Fragment> fragments,
                                   std::span<const SlabMask> masks, int k, SlabKeep keep);

// The layers' colours, each as much as the part of the b bits that is its own: X. Either scaled to
// what all fragments together cover, alpha_C, as far as T backdrop leaves room; or uncorrected,
// X + (1 - X1) backdrop. Layers come near to far.
Rgba mlcb_resolve(std::span<const MlcbLayer> layers, int b, double alpha_c, Rgba backdrop);
Rgba mlcb_resolve_uncorrected(std::span<const MlcbLayer> layers, int b, Rgba backdrop);

}  // namespace sheer::reference
