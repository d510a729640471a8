// Row by row; each pixel's sum in one fixed order.
#include "cpu/post_filter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/math.h"
#include "support/parallel.h"

namespace sheer {

namespace {

// By the distance along one axis; three deviations and what is beyond is nothing.
std::vector<double> weights_of_distance(double sigma)
{
    std::vector<double> weights;
    for (int d = 0; d <= std::ceil(3 * sigma); ++d) {
        weights.push_back(own_exp(-d * d / (2 * sigma * sigma)));
    }
    return weights;
}

}  // namespace

void apply_post_filter(const PostFilter& filter, const Image& transparent, int threads,
                       Image& image)
{
    const std::vector<double> near = weights_of_distance(double{filter.sigma_s});
    const int reach = static_cast<int>(near.size()) - 1;
    const double sharpness = -1 / (2 * double{filter.sigma_r} * double{filter.sigma_r});
    const auto filter_pixel = [&](int x, int y) {
        const Float4& here = transparent.at(x, y);
        double sum[3] = {}, total = 0;
        for (int ny = std::max(y - reach, 0); ny <= std::min(y + reach, image.height - 1); ++ny) {
            for (int nx = std::max(x - reach, 0); nx <= std::min(x + reach, image.width - 1);
                 ++nx) {
                const Float4& there = transparent.at(nx, ny);
                const double apart = double{there[3]} - double{here[3]};
                const double weight = near[static_cast<std::size_t>(std::abs(nx - x))] *
                                      near[static_cast<std::size_t>(std::abs(ny - y))] *
                                      own_exp(sharpness * apart * apart);
                total += weight;
                for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * double{there[c]};
            }
        }
        Float4& pixel = image.at(x, y);
        for (std::size_t c = 0; c < 3; ++c) {
            const double added = sum[c] / total - double{here[c]};
            pixel[c] = static_cast<float>(std::max(0.0, double{pixel[c]} + added));
        }
    };
    parallel_for(threads > 0 ? threads : hardware_threads(), static_cast<std::size_t>(image.height),
                 [&](std::size_t row, int) {
                     for (int x = 0; x < image.width; ++x) {
                         // Nothing is transparent here, and nothing of others' is wanted.
                         if (transparent.at(x, static_cast<int>(row))[3] == 0) continue;
                         filter_pixel(x, static_cast<int>(row));
                     }
                 });
}

}  // namespace sheer
