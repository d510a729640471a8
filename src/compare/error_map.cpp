// Error maps in the colours of "magma", one of the perceptually uniform maps of S. van der Walt and
// N. Smith for matplotlib (data dedicated to the public under CC0): every 17th of its 256 colours,
// to 8 bits. Straight lines between them stay within 2.2/255 of the others.
#include "compare/error_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "compare/metrics.h"
#include "image/color.h"

namespace sheer {
namespace {

// sRGB, 0 to 255.
constexpr std::array<std::array<double, 3>, 16> kMagma = {{{0, 0, 4},
                                                           {11, 9, 36},
                                                           {32, 17, 75},
                                                           {59, 15, 112},
                                                           {87, 21, 126},
                                                           {114, 31, 129},
                                                           {140, 41, 129},
                                                           {168, 50, 125},
                                                           {196, 60, 117},
                                                           {222, 73, 104},
                                                           {241, 96, 93},
                                                           {250, 127, 94},
                                                           {254, 159, 109},
                                                           {254, 191, 132},
                                                           {253, 222, 160},
                                                           {252, 253, 191}}};

constexpr std::array<float, 4> kNoNumber = {0, 1, 0, 1};  // nothing in the map is green

double error_of(const std::array<float, 4>& a, const std::array<float, 4>& b)
{
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double difference = channel_difference(a[c], b[c]);
        sum += difference * difference;
    }
    return std::sqrt(sum / 3) * kUnitsOfWhite;
}

// part in [0, 1].
std::array<float, 4> color_of(double part)
{
    const double place = part * static_cast<double>(kMagma.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kMagma.size() - 2);
    const double t = place - static_cast<double>(below);
    std::array<float, 4> color = {0, 0, 0, 1};
    for (std::size_t c = 0; c < 3; ++c) {
        const double encoded = (1 - t) * kMagma[below][c] + t * kMagma[below + 1][c];
        color[c] = static_cast<float>(linear_from_srgb(encoded / 255));
    }
    return color;
}

// Powers of ten are exact up to 10^22, so that the quotient is the double that is printed as 0.002.
double decimal(double digit, int exponent)
{
    double power = 1;
    for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
    return exponent < 0 ? digit / power : digit * power;
}

// error > 0 and finite.
double round_up_to_1_2_5(double error)
{
    int exponent = 0;
    while (decimal(1, exponent) > error) --exponent;
    while (decimal(1, exponent + 1) <= error) ++exponent;
    for (const double digit : {1, 2, 5}) {
        if (decimal(digit, exponent) >= error) return decimal(digit, exponent);
    }
    return decimal(1, exponent + 1);
}

}  // namespace

Image error_map(const Image& a, const Image& b, double scale)
{
    check_sizes(a, b);
    Image map(a.width, a.height);
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        const double error = error_of(a.pixels[i], b.pixels[i]);
        if (!std::isfinite(error)) {
            map.pixels[i] = kNoNumber;
        } else {
            map.pixels[i] = color_of(error < scale ? error / scale : error > 0 ? 1 : 0);
        }
    }
    return map;
}

std::span<const std::array<double, 3>> error_colors()
{
    return kMagma;
}

Image error_map(const FlipErrors& flip)
{
    Image map(flip.width, flip.height);
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        map.pixels[i] = color_of(std::min(double{flip.errors[i]}, 1.0));
    }
    return map;
}

double error_scale(const Image& a, const Image& b)
{
    check_sizes(a, b);
    std::vector<double> errors;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double error = error_of(a.pixels[i], b.pixels[i]);
        if (error > 0 && std::isfinite(error)) errors.push_back(error);
    }
    if (errors.empty()) return 0;
    const std::size_t above = errors.size() / 1000;
    const auto last = errors.end() - 1 - static_cast<std::ptrdiff_t>(above);
    std::nth_element(errors.begin(), last, errors.end());
    return round_up_to_1_2_5(*last);
}

double shared_scale(std::vector<double> scales)
{
    std::erase(scales, 0);
    if (scales.empty()) return 0;
    const auto middle = scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2);
    std::nth_element(scales.begin(), middle, scales.end());
    return *middle;
}

}  // namespace sheer
