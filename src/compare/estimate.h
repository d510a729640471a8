// What a few independent measurements say of what they measure.
#pragma once

#include <span>

namespace sheer {

// The true mean is within `mean` +- `within` with a confidence of 99 %, if the numbers are
// independent and normal: Student. The Probable Error of a Mean. 1908.
struct Estimate {
    double mean = 0, within = 0;
};

// Of an odd number of them, 3 at least.
Estimate estimate_mean(std::span<const double> values);

// Of root mean squares, one by the other, each measured as often; the interval as above.
struct RatioEstimate {
    double ratio = 0, least = 0, most = 0;
};

// From mean squares above 0. The ratio's logarithm is taken to be normal.
RatioEstimate estimate_ratio(std::span<const double> squares, std::span<const double> by_squares);

// What Student's t, with an even number of degrees of freedom, is within in 99 of 100 cases.
double student_within(int degrees);

}  // namespace sheer
