#include "reference/hashed_threshold.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace sheer::reference {
namespace {

double fraction(double x)
{
    return x - std::floor(x);
}

double length(const Point3& v)
{
    return std::hypot(v[0], v[1], v[2]);
}

// How much the position changes in a pixel, along each axis.
Point3 derivatives(const SurfacePoint& point, HashedThreshold::Variant variant)
{
    if (variant == HashedThreshold::Variant::isotropic) {
        const double most = std::clamp(std::max(length(point.dx), length(point.dy)), 1e-8, 1e8);
        return {most, most, most};
    }
    Point3 d;
    for (std::size_t i = 0; i < 3; ++i) {
        d[i] = std::max(std::abs(point.dx[i]), std::abs(point.dy[i]));
    }
    const double most = std::clamp(std::max({d[0], d[1], d[2]}), 1e-8, 1e8);
    for (double& component : d) component = std::clamp(component, most / 16, 1e8);
    return d;
}

// One of the cells that are mixed, and its part.
struct Corner {
    Point3 scales;
    double weight;
};

// The paper's factor lets cells keep their mean size.
constexpr double kAnisotropicScale = 0.707;

std::vector<Corner> corners(const Point3& scales, const HashedThreshold& how)
{
    if (!how.discrete) return {{scales, 1}};
    Point3 low, high, q;
    for (std::size_t i = 0; i < 3; ++i) {
        const double octave = std::log2(scales[i]);
        low[i] = std::exp2(std::floor(octave));
        high[i] = std::exp2(std::ceil(octave));
        q[i] = fraction(octave);
    }
    if (how.variant == HashedThreshold::Variant::isotropic) {
        return {{low, 1 - q[0]}, {high, q[0]}};
    }
    if (how.variant == HashedThreshold::Variant::anisotropic) {
        const double from = length(q), to = length({1 - q[0], 1 - q[1], 1 - q[2]});
        const double t = from / (from + to);
        return {{low, 1 - t}, {high, t}};
    }
    std::vector<Corner> all;
    for (unsigned bits = 0; bits < 8; ++bits) {
        Corner corner = {low, 1};
        for (std::size_t i = 0; i < 3; ++i) {
            const bool up = (bits >> i & 1) != 0;
            if (up) corner.scales[i] = high[i];
            corner.weight *= up ? q[i] : 1 - q[i];
        }
        all.push_back(corner);
    }
    return all;
}

}  // namespace

double paper_hash(double x, double y)
{
    return fraction(1e4 * std::sin(17 * x + 0.1 * y) * (0.1 + std::abs(std::sin(13 * y + x))));
}

double paper_hash(const Point3& cell)
{
    return paper_hash(paper_hash(cell[0], cell[1]), cell[2]);
}

double mix_of_two_cdf(double x, double t)
{
    const double a = std::min(t, 1 - t);
    if (x < a) return x * x / (2 * a * (1 - a));
    if (x < 1 - a || a == 0) return (x - a / 2) / (1 - a);
    return 1 - (1 - x) * (1 - x) / (2 * a * (1 - a));
}

double mix_cdf(double x, std::span<const double> weights)
{
    // The volume of a corner of the unit cube, by inclusion and exclusion of the corners beyond.
    std::vector<long double> w;
    for (const double weight : weights) {
        if (weight > 0) w.push_back(weight);
    }
    long double sum = 0, divisor = 1;
    for (std::size_t i = 0; i < w.size(); ++i) divisor *= w[i] * static_cast<long double>(i + 1);
    for (unsigned set = 0; set >> w.size() == 0; ++set) {
        long double left = x;
        for (std::size_t i = 0; i < w.size(); ++i) left -= (set >> i & 1) != 0 ? w[i] : 0;
        long double volume = 1;
        for (std::size_t i = 0; i < w.size(); ++i) volume *= std::max(left, 0.0L);
        sum += std::popcount(set) % 2 == 0 ? volume : -volume;
    }
    return std::clamp(static_cast<double>(sum / divisor), 0.0, 1.0);
}

double hashed_threshold(const SurfacePoint& point, const HashedThreshold& how)
{
    const bool isotropic = how.variant == HashedThreshold::Variant::isotropic;
    Point3 scales = derivatives(point, how.variant);
    for (double& scale : scales) {
        scale = (isotropic ? 1 : kAnisotropicScale) / (how.hash_scale * scale);
    }
    const std::vector<Corner> mixed = corners(scales, how);
    double x = 0;
    std::vector<double> weights;
    for (const Corner& corner : mixed) {
        Point3 cell;
        for (std::size_t i = 0; i < 3; ++i) {
            cell[i] = std::floor(corner.scales[i] * point.position[i]);
        }
        if (!how.third) cell[2] = 0;
        x += corner.weight * how.hash(cell);
        weights.push_back(corner.weight);
    }
    if (how.uniform && mixed.size() == 2) x = mix_of_two_cdf(x, weights[1]);
    if (how.uniform && mixed.size() == 8) x = mix_cdf(x, weights);
    return std::clamp(x, 1e-6, 1.0);
}

double fade_in(double x, double n)
{
    if (x <= 0) return 0;
    return x < n ? (x / n) * (x / n) : 1;
}

double faded_threshold(double threshold, double b)
{
    return 0.5 + (threshold - 0.5) * b;
}

double faded_pass_chance(double opacity, double b)
{
    if (b == 0) return opacity >= 0.5 ? 1 : 0;
    return std::clamp(0.5 + (opacity - 0.5) / b, 0.0, 1.0);
}

double anisotropy(std::array<double, 2> uv_dx, std::array<double, 2> uv_dy)
{
    const double ratio = std::hypot(uv_dx[0], uv_dx[1]) / std::hypot(uv_dy[0], uv_dy[1]);
    return std::max(ratio, 1 / ratio);
}

int stratum(int frame, int n, StrataOrder order)
{
    switch (order) {
        case StrataOrder::linear: break;
        case StrataOrder::alternating: return frame / 2 + frame % 2 * (n / 2);
        case StrataOrder::van_der_corput: {
            int reversed = 0;
            for (int bit = 1; bit < n; bit *= 2) {
                reversed = 2 * reversed + (frame & bit ? 1 : 0);
            }
            return reversed;
        }
    }
    return frame;
}

double stratified_threshold(double threshold, int stratum, int n)
{
    return fraction(threshold + static_cast<double>(stratum) / n);
}

Point3 cosine_direction(double chi1, double chi2)
{
    const double radius = std::sqrt(chi1), angle = 2 * std::numbers::pi * chi2;
    return {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(std::max(0.0, 1 - chi1))};
}

}  // namespace sheer::reference
