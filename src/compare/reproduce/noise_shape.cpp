#include "compare/reproduce/noise_shape.h"

#include <cstddef>

namespace sheer {

namespace {

// Of pixels so many apart along one axis.
double correlation(const std::vector<double>& pixels, int side, int across, int down)
{
    double sum = 0, count = 0;
    for (int y = 0; y + down < side; ++y) {
        for (int x = 0; x + across < side; ++x) {
            const auto here = static_cast<std::size_t>(y * side + x);
            const auto there = static_cast<std::size_t>((y + down) * side + x + across);
            sum += (2 * pixels[here] - 1) * (2 * pixels[there] - 1);
            count += 1;
        }
    }
    return sum / count;
}

}  // namespace

void NoiseLengths::add(const std::vector<double>& pixels, int side, int pictures)
{
    for (int lag = 1; lag <= kMostLag; ++lag) {
        const auto at = static_cast<std::size_t>(lag - 1);
        along_x[at] += correlation(pixels, side, lag, 0) / pictures;
        along_y[at] += correlation(pixels, side, 0, lag) / pictures;
    }
}

void NoiseLengths::finish()
{
    across = down = 1;
    for (const double r : along_x) across += 2 * r;
    for (const double r : along_y) down += 2 * r;
}

}  // namespace sheer
