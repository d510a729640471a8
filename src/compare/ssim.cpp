// The paper's equation 13 from five weighted means; a window's weighted sums over x and y are
// products, so that two short filters do.
#include "compare/ssim.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "compare/metrics.h"
#include "compare/separable.h"
#include "image/color.h"
#include "support/math.h"
#include "support/parallel.h"

namespace sheer {

namespace {

constexpr std::size_t kWindow = 11;
constexpr double kDeviation = 1.5;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;  // (K L)^2
constexpr std::size_t kBandRows = 32;                   // of results

std::array<double, kWindow> window_weights()
{
    std::array<double, kWindow> weights{};
    double sum = 0;
    for (std::size_t i = 0; i < kWindow; ++i) {
        const double x = static_cast<double>(i) - (kWindow - 1) / 2;
        weights[i] = own_exp(-x * x / (2 * kDeviation * kDeviation));
        sum += weights[i];
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

double encoded(float linear)
{
    // Written so that NaN becomes 0.
    return srgb_from_linear(linear > 0 ? std::min(double{linear}, 1.0) : 0.0);
}

// One channel of a band.
struct Channel {
    Rows a, b, aa, bb, ab;

    Channel(std::size_t width, std::size_t count)
        : a(width, count), b(width, count), aa(width, count), bb(width, count), ab(width, count)
    {
    }
};

void set_row(const std::array<float, 4>* a, const std::array<float, 4>* b, std::size_t c,
             std::size_t row, Channel& channel)
{
    for (std::size_t x = 0; x < channel.a.width(); ++x) {
        const double va = encoded(a[x][c]), vb = encoded(b[x][c]);
        channel.a[row][x] = va;
        channel.b[row][x] = vb;
        channel.aa[row][x] = va * va;
        channel.bb[row][x] = vb * vb;
        channel.ab[row][x] = va * vb;
    }
}

double sum_of(const Channel& channel, const std::array<double, kWindow>& weights)
{
    const auto mean = [&](const Rows& rows) {
        return filter_along_y(filter_along_x(rows, weights), weights);
    };
    const Rows mu_x = mean(channel.a), mu_y = mean(channel.b);
    const Rows xx = mean(channel.aa), yy = mean(channel.bb), xy = mean(channel.ab);
    double sum = 0;
    for (std::size_t row = 0; row < mu_x.count(); ++row) {
        double row_sum = 0;
        for (std::size_t i = 0; i < mu_x.width(); ++i) {
            const double x = mu_x[row][i], y = mu_y[row][i];
            const double sigma_xy = xy[row][i] - x * y;
            const double sigmas = (xx[row][i] - x * x) + (yy[row][i] - y * y);
            row_sum +=
                (2 * x * y + kC1) * (2 * sigma_xy + kC2) / ((x * x + y * y + kC1) * (sigmas + kC2));
        }
        sum += row_sum;
    }
    return sum;
}

}  // namespace

std::optional<double> ssim(const Image& a, const Image& b, int threads)
{
    check_sizes(a, b);
    const auto width = static_cast<std::size_t>(a.width);
    const auto height = static_cast<std::size_t>(a.height);
    if (width < kWindow || height < kWindow) return std::nullopt;
    const std::array<double, kWindow> weights = window_weights();
    const std::size_t results = height + 1 - kWindow;
    std::vector<double> sums((results + kBandRows - 1) / kBandRows);
    parallel_for(threads, sums.size(), [&](std::size_t band, int) {
        const std::size_t first = band * kBandRows;
        const std::size_t count = std::min(kBandRows, results - first) + kWindow - 1;
        Channel channel(width, count);
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t row = 0; row < count; ++row) {
                const std::size_t at = (first + row) * width;
                set_row(&a.pixels[at], &b.pixels[at], c, row, channel);
            }
            sums[band] += sum_of(channel, weights);
        }
    });
    double sum = 0;
    for (const double band : sums) sum += band;
    return sum / (3 * static_cast<double>(results) * static_cast<double>(width + 1 - kWindow));
}

}  // namespace sheer
