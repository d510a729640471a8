// How the time of a comparison divides over its parts, roughly and beforehand: for whoever wants to
// know how much of it is left.
#pragma once

#include <vector>

#include <sheer/render.h>

#include "compare/comparison.h"

namespace sheer {

// Parts of the whole: the truth, and for each number of samples the methods' pictures.
struct WorkShares {
    double truth;
    std::vector<double> of_samples;
};

WorkShares work_shares(const View& view, const ComparisonRequest& request,
                       const std::vector<int>& samples);

}  // namespace sheer
