// Equation and table numbers are those of the paper that flip.h cites.
#include "compare/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "support/math.h"

namespace sheer {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kPixelsPerDegree = 0.7 * 3840 / 0.7 * kPi / 180;  // section 4.1

// Table 1: the sensitivity is a sum of a exp(-b f^2) over frequencies f, in cycles a degree; a
// picture is filtered by its Fourier transform, a sqrt(pi / b) exp(-pi^2 x^2 / b) with x in
// degrees.
struct Term {
    double a, b;
};
const std::vector<Term> kAchromatic = {{1, 0.0047}};
const std::vector<Term> kRedGreen = {{1, 0.0053}};
const std::vector<Term> kBlueYellow = {{34.1, 0.04}, {13.5, 0.025}};

// Half of the width of what finds features, 0.082 degrees from trough to peak (section 4.2).
constexpr double kFeatureDeviation = 0.5 * 0.082 * kPixelsPerDegree;

template <class Weight>
std::vector<double> sampled(std::size_t radius, const Weight& weight)
{
    std::vector<double> weights;
    const auto r = static_cast<int>(radius);
    for (int i = -r; i <= r; ++i) weights.push_back(weight(static_cast<double>(i)));
    return weights;
}

double sum_of(const std::vector<double>& weights)
{
    double sum = 0;
    for (const double weight : weights) sum += weight;
    return sum;
}

// Three standard deviations of the widest of all, which is blue and yellow's (equation 5).
std::size_t spatial_radius()
{
    return static_cast<std::size_t>(
        std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * kPixelsPerDegree));
}

SpatialFilter make_spatial(const std::vector<Term>& terms, std::size_t radius)
{
    SpatialFilter filter;
    double total = 0;
    for (const Term& term : terms) {
        // The square root of the factor goes into each of x and y.
        const double factor = std::sqrt(term.a * std::sqrt(kPi / term.b));
        filter.gaussians.push_back(sampled(radius, [&](double i) {
            const double x = i / kPixelsPerDegree;
            return factor * own_exp(-kPi * kPi * x * x / term.b);
        }));
        const double sum = sum_of(filter.gaussians.back());
        total += sum * sum;
    }
    for (std::vector<double>& gaussian : filter.gaussians) {
        for (double& weight : gaussian) weight /= std::sqrt(total);
    }
    return filter;
}

void normalize_signs(std::vector<double>& weights)
{
    double above = 0, below = 0;
    for (const double weight : weights) (weight > 0 ? above : below) += weight;
    for (double& weight : weights) weight /= weight > 0 ? above : -below;
}

// With zeros on both sides, so that all filters are as long.
std::vector<double> padded(const std::vector<double>& weights, std::size_t radius)
{
    std::vector<double> result(2 * radius + 1);
    const std::size_t margin = (result.size() - weights.size()) / 2;
    std::copy(weights.begin(), weights.end(), result.begin() + static_cast<std::ptrdiff_t>(margin));
    return result;
}

// Section 4.2: g, -x g and (x^2 / sigma^2 - 1) g.
void make_features(FlipFilters& filters)
{
    const double square = kFeatureDeviation * kFeatureDeviation;
    const auto radius = static_cast<std::size_t>(std::ceil(3 * kFeatureDeviation));
    const auto gaussian = [&](double x) { return own_exp(-x * x / (2 * square)); };
    const auto edge = [&](double x) { return -x * gaussian(x); };
    const auto point = [&](double x) { return (x * x / square - 1) * gaussian(x); };
    std::vector<double> smooth = sampled(radius, gaussian);
    const double sum = sum_of(smooth);
    for (double& weight : smooth) weight /= sum;
    filters.smooth = padded(smooth, filters.radius);
    filters.edge = padded(sampled(radius, edge), filters.radius);
    filters.point = padded(sampled(radius, point), filters.radius);
    normalize_signs(filters.edge);
    normalize_signs(filters.point);
}

}  // namespace

FlipFilters make_flip_filters()
{
    FlipFilters filters;
    filters.radius = spatial_radius();
    filters.achromatic = make_spatial(kAchromatic, filters.radius);
    filters.red_green = make_spatial(kRedGreen, filters.radius);
    filters.blue_yellow = make_spatial(kBlueYellow, filters.radius);
    make_features(filters);
    return filters;
}

}  // namespace sheer
