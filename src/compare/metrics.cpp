// Means over pictures.
#include "compare/metrics.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include <sheer/error.h>

#include "support/math.h"
#include "support/text.h"

namespace sheer {
namespace {

using Rgb = std::array<double, 3>;

std::size_t index_of(int width, int x, int y)
{
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
}

// The mean of term(pixel index, channel) for each channel. Each row has a sum of its own, so that
// the rounding errors grow with width + height and not with their product.
template <class Term>
Rgb mean_of(int width, int height, const Term& term)
{
    Rgb sum{};
    for (int y = 0; y < height; ++y) {
        Rgb row{};
        for (int x = 0; x < width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) row[c] += term(index_of(width, x, y), c);
        }
        for (std::size_t c = 0; c < 3; ++c) sum[c] += row[c];
    }
    for (double& s : sum) s /= static_cast<double>(width) * height;
    return sum;
}

template <class Term>
double mean_of_all(int width, int height, const Term& term)
{
    const Rgb mean = mean_of(width, height, term);
    return (mean[0] + mean[1] + mean[2]) / 3;
}

double square(double x)
{
    return x * x;
}

// Not std::max(0, x), which is 0 for NaN.
double root_or_zero(double x)
{
    return x < 0 ? 0 : std::sqrt(x);
}

void find_largest(const Image& a, const Image& b, Difference& difference)
{
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double here = std::abs(channel_difference(a.at(x, y)[c], b.at(x, y)[c]));
                // The first NaN is the largest of all.
                if (here <= difference.largest || std::isnan(difference.largest)) continue;
                difference.largest = here;
                difference.largest_x = x;
                difference.largest_y = y;
            }
        }
    }
    difference.largest *= kUnitsOfWhite;
}

}  // namespace

void check_sizes(const Image& a, const Image& b)
{
    if (a.width != b.width || a.height != b.height) {
        throw Error(Fault::input, "pictures of " + size_text(a.width, a.height) + " and " +
                                      size_text(b.width, b.height) + " pixels cannot be compared");
    }
    if (a.pixels.empty()) throw Error(Fault::input, "pictures without pixels have no distance");
}

double psnr_of(double rmse)
{
    if (rmse == 0) return std::numeric_limits<double>::infinity();
    return 20 * own_log(kUnitsOfWhite / rmse) / own_log(10);
}

double channel_difference(float a, float b)
{
    const bool same = std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
    return same ? 0 : double{a} - double{b};
}

Difference compare_images(const Image& a, const Image& b)
{
    check_sizes(a, b);
    const auto difference = [&](std::size_t i, std::size_t c) {
        return channel_difference(a.pixels[i][c], b.pixels[i][c]);
    };
    Difference result;
    const double mean_square = mean_of_all(
        a.width, a.height, [&](std::size_t i, std::size_t c) { return square(difference(i, c)); });
    result.rmse = std::sqrt(mean_square) * kUnitsOfWhite;
    result.psnr = psnr_of(result.rmse);
    result.bias_mean = mean_of(a.width, a.height, difference);
    for (double& channel : result.bias_mean) channel *= kUnitsOfWhite;
    find_largest(a, b, result);
    return result;
}

bool same_bits(const Image& a, const Image& b)
{
    return a.width == b.width && a.height == b.height && a.pixels.size() == b.pixels.size() &&
           (a.pixels.empty() || std::memcmp(a.pixels.data(), b.pixels.data(),
                                            a.pixels.size() * sizeof a.pixels[0]) == 0);
}

std::optional<Pixel> first_not_finite(const Image& a, const Image& b)
{
    check_sizes(a, b);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = a.at(x, y)[c];
                const bool differs = channel_difference(value, b.at(x, y)[c]) != 0;  // or NaN
                if (differs && !std::isfinite(value)) return Pixel{x, y};
            }
        }
    }
    return std::nullopt;
}

double noise(const Moments& moments)
{
    const Image& variance = moments.variance;
    const double mean_variance =
        mean_of_all(variance.width, variance.height,
                    [&](std::size_t i, std::size_t c) { return double{variance.pixels[i][c]}; });
    return std::sqrt(mean_variance) * kUnitsOfWhite;
}

double bias(const Moments& moments, const Image& truth)
{
    const auto error = [&](std::size_t i, std::size_t c) {
        return channel_difference(moments.mean.pixels[i][c], truth.pixels[i][c]);
    };
    check_sizes(moments.mean, truth);
    const double mean_square =
        mean_of_all(truth.width, truth.height, [&](std::size_t i, std::size_t c) {
            return square(error(i, c)) - double{moments.variance.pixels[i][c]} / moments.seeds;
        });
    return root_or_zero(mean_square) * kUnitsOfWhite;
}

Rgb bias_mean(const Moments& moments, const Image& truth)
{
    return compare_images(moments.mean, truth).bias_mean;
}

double rmse(const Moments& moments, const Image& truth)
{
    check_sizes(moments.mean, truth);
    const double n = moments.seeds;
    const double mean_square =
        mean_of_all(truth.width, truth.height, [&](std::size_t i, std::size_t c) {
            const double error = channel_difference(moments.mean.pixels[i][c], truth.pixels[i][c]);
            return square(error) + double{moments.variance.pixels[i][c]} * (n - 1) / n;
        });
    return std::sqrt(mean_square) * kUnitsOfWhite;
}

}  // namespace sheer
