// In the end the average in a frame is a geometric series over those before, n of which repeat.
#include "reference/exponential_average.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sheer::reference {

double peak_to_peak(const std::vector<bool>& passes, double weight)
{
    const std::size_t n = passes.size();
    const double keeps = 1 - weight, all = 1 - std::pow(keeps, static_cast<double>(n));
    double least = 1, most = 0;
    for (std::size_t last = 0; last < n; ++last) {
        double average = 0, part = weight;
        for (std::size_t before = 0; before < n; ++before, part *= keeps) {
            if (passes[(last + n - before) % n]) average += part / all;
        }
        least = std::min(least, average);
        most = std::max(most, average);
    }
    return most - least;
}

double flicker(double opacity, int n, double weight, StrataOrder order, int thresholds)
{
    const int all = n * thresholds;
    double sum = 0;
    for (int i = 0; i < all; ++i) {
        std::vector<bool> passes;
        for (int frame = 0; frame < n; ++frame) {
            const int j = stratum(frame, n, order);
            passes.push_back(opacity >= stratified_threshold((i + .5) / all, j, n));
        }
        sum += peak_to_peak(passes, weight);
    }
    return sum / all;
}

}  // namespace sheer::reference
