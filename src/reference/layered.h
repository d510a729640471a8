// What methods that keep a few layers must answer for one sample, in double precision: members of
// the continuum of C. Wyman, "Exploring and expanding the continuum of OIT algorithms", 2016.
//
// Lists of fragments, sorted by (depth, id), from which something is taken when they are too long.
// Fragments come in the order of arrival.
#pragma once

#include <span>

#include "reference/reference.h"

namespace sheer::reference {

// M. Salvi, K. Vaidyanathan, "Multi-layer alpha blending", 2014: the two farthest become one.
Rgba mlab(std::span<const Fragment> fragments, int layers, Rgba backdrop);

// What a k-buffer does with one layer too many (L. Bavoil et al., "Multi-fragment effects on the
// GPU using the k-buffer", 2007): the nearest goes under all that went before, the two nearest
// become one at the nearer's place, or the farthest is forgotten.
enum class KBufferMerge { front, nearest_two, discard };

Rgba k_buffer(std::span<const Fragment> fragments, int layers, KBufferMerge merge, Rgba backdrop);

// M. Maule et al., "Hybrid transparency", 2013: the nearest `layers` fragments are a core in front
// of an average of all others. Its opacity: as of n equal layers, the true one, or 0. Scaled: it
// has no colour, and the core's is scaled to what all fragments together cover.
enum class HybridTail { maule, total, none, scaled };

Rgba hybrid(std::span<const Fragment> fragments, int layers, HybridTail tail, Rgba backdrop);

// M. Salvi, J. Montgomery, A. Lefohn, "Adaptive transparency", 2011: visibility as a curve of
// `nodes` steps, from which the step of the least area goes; every fragment counts as far as the
// curve says that it is seen. `doubtful` is set where floats might choose another step, as two have
// areas that differ by less than transmittances that are off by 2^-17 would make of them.
Rgba adaptive(std::span<const Fragment> fragments, int nodes, Rgba backdrop,
              bool* doubtful = nullptr);

// C. Everitt, "Interactive order-independent transparency", 2001: the nearest `peels` fragments.
Rgba depth_peeling(std::span<const Fragment> fragments, int peels, Rgba backdrop);

// L. Bavoil, K. Myers, "Order independent transparency with dual depth peeling", 2008: the nearest
// `peels` fragments and the farthest.
Rgba dual_depth_peeling(std::span<const Fragment> fragments, int peels, Rgba backdrop);

}  // namespace sheer::reference
