// What temporal antialiasing, an exponential average of frames, makes of thresholds that go round:
// C. Wyman, M. McGuire, "Improved alpha testing using hashed sampling", 2019, section 7.2.
#pragma once

#include <vector>

#include "reference/hashed_threshold.h"

namespace sheer::reference {

// The average of frames in which `passes` goes round for ever, each new one with that weight: how
// far apart its greatest and its least value are in the end.
double peak_to_peak(const std::vector<bool>& passes, double weight);

// The mean of that over all thresholds of a fragment, n strata in that order (equation 6). Exact
// where n times the opacity is whole; of other opacities, by so many thresholds a stratum.
double flicker(double opacity, int n, double weight, StrataOrder order, int thresholds = 64);

}  // namespace sheer::reference
