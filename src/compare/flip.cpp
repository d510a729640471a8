// The paper's two pipelines, colour (section 4.1) and features (4.2), and how they meet (4.3), a
// band of rows at a time: what an eye makes of each picture, then the difference of that.
#include "compare/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "compare/flip_color.h"
#include "compare/flip_filters.h"
#include "compare/metrics.h"
#include "compare/separable.h"
#include "support/math.h"
#include "support/parallel.h"

namespace sheer {

namespace {

constexpr double kQc = 0.7, kPc = 0.4, kPt = 0.95;  // of colours
constexpr double kQf = 0.5;                         // of features
constexpr std::size_t kBandRows = 64;

struct Seen {
    Triple lab;          // filtered, after Hunt
    double edge, point;  // how much of one is there
};

// Y, Cx and Cz of a band, with the picture's border repeated as far as filters reach.
std::array<Rows, 3> padded_band(const Image& image, std::size_t first, std::size_t count,
                                std::size_t radius)
{
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    const Rows empty(width + 2 * radius, count + 2 * radius);
    std::array<Rows, 3> band = {empty, empty, empty};
    for (std::size_t row = 0; row < empty.count(); ++row) {
        const std::size_t y = std::clamp(first + row, radius, height - 1 + radius) - radius;
        for (std::size_t column = 0; column < empty.width(); ++column) {
            const std::size_t x = std::clamp(column, radius, width - 1 + radius) - radius;
            const std::array<float, 4>& pixel = image.pixels[y * width + x];
            Triple rgb{};
            for (std::size_t c = 0; c < 3; ++c) {
                rgb[c] = pixel[c] > 0 ? std::min(double{pixel[c]}, 1.0) : 0;  // NaN is 0
            }
            const Triple color = ycxcz_from_linear(rgb);
            for (std::size_t c = 0; c < 3; ++c) band[c][row][column] = color[c];
        }
    }
    return band;
}

Rows filter(const Rows& rows, const std::vector<double>& for_x, const std::vector<double>& for_y)
{
    return filter_along_y(filter_along_x(rows, for_x), for_y);
}

Rows filter(const Rows& rows, const SpatialFilter& spatial)
{
    Rows result = filter(rows, spatial.gaussians[0], spatial.gaussians[0]);
    for (std::size_t i = 1; i < spatial.gaussians.size(); ++i) {
        const Rows more = filter(rows, spatial.gaussians[i], spatial.gaussians[i]);
        for (std::size_t y = 0; y < result.count(); ++y) {
            for (std::size_t x = 0; x < result.width(); ++x) result[y][x] += more[y][x];
        }
    }
    return result;
}

double length(double x, double y)
{
    return std::sqrt(x * x + y * y);
}

std::vector<Seen> see(const Image& image, std::size_t first, std::size_t count,
                      const FlipFilters& filters)
{
    std::array<Rows, 3> band = padded_band(image, first, count, filters.radius);
    const Rows y = filter(band[0], filters.achromatic);
    const Rows cx = filter(band[1], filters.red_green);
    const Rows cz = filter(band[2], filters.blue_yellow);
    Rows& light = band[0];
    for (std::size_t row = 0; row < light.count(); ++row) {
        for (double& value : light[row]) value = (value + 16) / 116;
    }
    const Rows edge_x = filter(light, filters.edge, filters.smooth);
    const Rows edge_y = filter(light, filters.smooth, filters.edge);
    const Rows point_x = filter(light, filters.point, filters.smooth);
    const Rows point_y = filter(light, filters.smooth, filters.point);
    std::vector<Seen> seen;
    for (std::size_t row = 0; row < count; ++row) {
        for (std::size_t x = 0; x < y.width(); ++x) {
            Triple rgb = linear_from_ycxcz({y[row][x], cx[row][x], cz[row][x]});
            for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
            seen.push_back({hunt_lab_from_linear(rgb), length(edge_x[row][x], edge_y[row][x]),
                            length(point_x[row][x], point_y[row][x])});
        }
    }
    return seen;
}

// The largest distance of two colours, which is that of green and blue.
double largest_distance()
{
    return own_pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), kQc);
}

// Differences of colour below kPc of the largest take up kPt of the range.
double color_error(const Triple& a, const Triple& b, double largest)
{
    const double error = own_pow(hyab(a, b), kQc);
    const double knee = kPc * largest;
    if (error < knee) return kPt / knee * error;
    return kPt + (error - knee) / (largest - knee) * (1 - kPt);
}

double error_of(const Seen& a, const Seen& b, double largest)
{
    const double color = color_error(a.lab, b.lab, largest);
    if (color == 0) return 0;
    const double feature = std::max(std::abs(a.edge - b.edge), std::abs(a.point - b.point));
    return own_pow(color, 1 - own_pow(feature / std::sqrt(2.0), kQf));
}

}  // namespace

FlipErrors flip_errors(const Image& test, const Image& reference, int threads)
{
    check_sizes(test, reference);
    const FlipFilters filters = make_flip_filters();
    const double largest = largest_distance();
    const auto width = static_cast<std::size_t>(test.width);
    const auto height = static_cast<std::size_t>(test.height);
    FlipErrors result{test.width, test.height, std::vector<float>(width * height), 0};
    std::vector<double> sums((height + kBandRows - 1) / kBandRows);
    parallel_for(threads, sums.size(), [&](std::size_t band, int) {
        const std::size_t first = band * kBandRows;
        const std::size_t count = std::min(kBandRows, height - first);
        const std::vector<Seen> a = see(test, first, count, filters);
        const std::vector<Seen> b = see(reference, first, count, filters);
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double error = error_of(a[i], b[i], largest);
            result.errors[first * width + i] = static_cast<float>(error);
            sums[band] += error;
        }
    });
    for (const double sum : sums) result.mean += sum;
    result.mean /= static_cast<double>(width * height);
    return result;
}

}  // namespace sheer
