// Student's distribution in closed form, inverted by halving.
#include "compare/estimate.h"

#include <cmath>
#include <vector>

#include "support/math.h"

namespace sheer {

namespace {

constexpr double kConfidence = 0.99;

// How likely |T| < t is. Abramowitz and Stegun. Handbook of Mathematical Functions. 1964, 26.7.4.
double student_probability(double t, int degrees)
{
    const double square = degrees / (degrees + t * t);
    double sum = 0, term = 1;
    for (int k = 1; 2 * k <= degrees; ++k) {
        sum += term;
        term *= square * (2 * k - 1) / (2 * k);
    }
    return t / std::sqrt(degrees + t * t) * sum;
}

}  // namespace

double student_within(int degrees)
{
    double below = 0, above = 16;  // of 2 degrees it is 9.9, and of more it is less
    for (int i = 0; i < 60; ++i) {
        const double middle = (below + above) / 2;
        (student_probability(middle, degrees) < kConfidence ? below : above) = middle;
    }
    return above;
}

Estimate estimate_mean(std::span<const double> values)
{
    const auto n = static_cast<double>(values.size());
    double mean = 0, squares = 0;
    for (const double value : values) mean += value / n;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double error = std::sqrt(squares / (n - 1) / n);
    return {mean, student_within(static_cast<int>(values.size()) - 1) * error};
}

RatioEstimate estimate_ratio(std::span<const double> squares, std::span<const double> by_squares)
{
    std::vector<double> logs;
    for (std::size_t i = 0; i < squares.size(); ++i) {
        logs.push_back(own_log(squares[i] / by_squares[i]) / 2);
    }
    const Estimate log = estimate_mean(logs);
    return {own_exp(log.mean), own_exp(log.mean - log.within), own_exp(log.mean + log.within)};
}

}  // namespace sheer
