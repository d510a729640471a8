// Which samples a triangle covers and where on it they are, in exact integers up to the last
// division.
//
// Edge functions: J. Pineda, "A parallel algorithm for polygon rasterization", 1988. Top-left rule:
// Direct3D 11.3 functional specification, section 3.4.1.3 (docs/numerics.md, "Coverage").
#include <algorithm>
#include <cmath>

#include "reference/fragments.h"

namespace sheer::reference {

namespace {

// Surfaces that coincide are a tie, whatever the last bits of their depths.
double round_to_bits(double depth)
{
    constexpr int kBits = 32;
    int exponent = 0;
    const double mantissa = std::frexp(depth, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(mantissa, kBits)), exponent - kBits);
}

// Coordinates stay below 2^24 in magnitude, so that products below are under 2^50.
struct Point {
    std::int64_t x, y;  // 1/256 pixel from the picture's top left
};

Point position(PixelAddress pixel, SamplePoint sample)
{
    return {static_cast<std::int64_t>(pixel.x) * kSubpixels + sample.x,
            static_cast<std::int64_t>(pixel.y) * kSubpixels + sample.y};
}

std::int64_t edge(const Triangle& triangle, int i, Point p)
{
    const int j = (i + 1) % 3;
    const std::int64_t dx = std::int64_t{triangle.x[j]} - triangle.x[i];
    const std::int64_t dy = std::int64_t{triangle.y[j]} - triangle.y[i];
    return dx * (p.y - triangle.y[i]) - dy * (p.x - triangle.x[i]);
}

bool is_top_or_left(const Triangle& triangle, int i)
{
    const int j = (i + 1) % 3;
    const bool level = triangle.y[j] == triangle.y[i];
    return level ? triangle.x[j] > triangle.x[i] : triangle.y[j] < triangle.y[i];
}

bool covers(const Triangle& triangle, Point p)
{
    for (int i = 0; i < 3; ++i) {
        const std::int64_t e = edge(triangle, i, p);
        if (e < 0 || (e == 0 && !is_top_or_left(triangle, i))) {
            return false;
        }
    }
    return true;
}

// The edge opposite to a vertex measures that vertex's weight.
Weights weights_from_edges(double e2, double e0, double twice_area)
{
    const double b1 = e2 / twice_area;
    const double b2 = e0 / twice_area;
    return {{1 - b1 - b2, b1, b2}};
}

double twice_area(const Triangle& triangle)
{
    return static_cast<double>(edge(triangle, 0, {triangle.x[2], triangle.y[2]}));
}

}  // namespace

std::uint64_t covered_samples(const Triangle& triangle, PixelAddress pixel,
                              const std::vector<SamplePoint>& pattern)
{
    std::uint64_t mask = 0;
    for (std::size_t s = 0; s < pattern.size(); ++s) {
        if (covers(triangle, position(pixel, pattern[s]))) {
            mask |= std::uint64_t{1} << s;
        }
    }
    return mask;
}

Weights weights_at_centroid(const Triangle& triangle, PixelAddress pixel, std::uint64_t mask,
                            const std::vector<SamplePoint>& pattern)
{
    // An edge function is affine: its value at the mean point is the mean of its values, and the
    // sum of those is exact where the mean point would have to be rounded.
    std::int64_t sum_e2 = 0;
    std::int64_t sum_e0 = 0;
    int count = 0;
    for (std::size_t s = 0; s < pattern.size(); ++s) {
        if (((mask >> s) & 1) != 0) {
            sum_e2 += edge(triangle, 2, position(pixel, pattern[s]));
            sum_e0 += edge(triangle, 0, position(pixel, pattern[s]));
            ++count;
        }
    }
    return weights_from_edges(static_cast<double>(sum_e2), static_cast<double>(sum_e0),
                              count * twice_area(triangle));
}

double depth_at(const Triangle& triangle, PixelAddress pixel, SamplePoint sample)
{
    const Point p = position(pixel, sample);
    const Weights weights =
        weights_from_edges(static_cast<double>(edge(triangle, 2, p)),
                           static_cast<double>(edge(triangle, 0, p)), twice_area(triangle));
    const double d0 = triangle.depth[0];
    const double d1 = triangle.depth[1];
    const double d2 = triangle.depth[2];
    const double depth = d0 + weights.b[1] * (d1 - d0) + weights.b[2] * (d2 - d0);
    return round_to_bits(std::clamp(depth, std::min({d0, d1, d2}), std::max({d0, d1, d2})));
}

}  // namespace sheer::reference
