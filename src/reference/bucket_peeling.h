// What peeling by buckets must answer for one sample, in double precision: F. Liu, M.-C. Huang,
// X.-H. Liu, E.-H. Wu, "Efficient depth peeling via bucket sort", 2009.
#pragma once

#include <span>
#include <vector>

#include "reference/reference.h"

namespace sheer::reference {

struct BucketPeeling {
    int buckets = 32;
    // What a pass takes of each bucket: the nearest fragment, or the farthest too.
    bool both_ends = true;
    int passes = 1;  // later ones look between the nearest and farthest taken so far
    // 0: buckets are equally long between the nearest fragment and the farthest. Otherwise the
    // range is cut into as many equally long bins, those that hold a fragment are numbered from
    // near to far, and with n of them the i-th goes to bucket i, or floor(i buckets / n) where n >
    // buckets.
    int bins = 0;
};

// The number of each fragment's bucket: of a range cut into n, that of depth z is
// floor((z - nearest) / (farthest - nearest) n), the last for the farthest, 0 where all are equal.
std::vector<int> buckets_of(std::span<const Fragment> fragments, const BucketPeeling& how);

// Fragments in any order, ties in depth by id. What is taken goes over the backdrop, exactly; the
// rest is forgotten.
Rgba bucket_peeling(std::span<const Fragment> fragments, const BucketPeeling& how, Rgba backdrop);

}  // namespace sheer::reference
