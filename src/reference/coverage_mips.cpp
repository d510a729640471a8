#include "reference/coverage_mips.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace sheer::reference {

double passing_part(std::span<const double> alphas, double threshold)
{
    const auto passing = std::count_if(alphas.begin(), alphas.end(),
                                       [&](double alpha) { return alpha > threshold; });
    return static_cast<double>(passing) / static_cast<double>(alphas.size());
}

double threshold_for_part(std::span<const double> alphas, double part)
{
    std::vector<double> values(alphas.begin(), alphas.end());
    values.push_back(0);
    values.push_back(1);
    std::sort(values.begin(), values.end(), std::greater<>());
    double best = 0.5, off = 2;
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        const double between = (values[i] + values[i + 1]) / 2;
        if (values[i] == values[i + 1]) continue;
        const double its_off = std::abs(passing_part(alphas, between) - part);
        if (its_off > off) continue;
        best = between;
        off = its_off;
    }
    return best;
}

std::vector<double> scaled_for_part(std::span<const double> alphas, double part, double threshold)
{
    const double scale = threshold / threshold_for_part(alphas, part);
    std::vector<double> scaled;
    for (const double alpha : alphas) scaled.push_back(std::min(1.0, alpha * scale));
    return scaled;
}

std::vector<double> halved(std::span<const double> alphas, int width, int height)
{
    const auto at = [&](int x, int y) { return alphas[static_cast<std::size_t>(y * width + x)]; };
    std::vector<double> result;
    for (int y = 0; y < height; y += 2) {
        for (int x = 0; x < width; x += 2) {
            result.push_back((at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) / 4);
        }
    }
    return result;
}

}  // namespace sheer::reference
