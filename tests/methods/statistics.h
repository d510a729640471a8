// Whether random numbers agree with what they should be: verdicts, so that planted faults can be
// shown to fail them.
//
// All seeds are fixed: a verdict never changes from run to run. The confidence says how likely a
// right program was to fail any of the tests on the day the seeds were chosen.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <sheer/image.h>

#include "reference/methods.h"

namespace sheer {

// Of all the statistical tests together, shared out evenly (Bonferroni). kZ is the normal
// distribution's two-sided quantile of kFamilyError / kMostTests; so far out, and at the thousands
// of trials made here, true distributions are within a small factor of it.
inline constexpr double kFamilyError = 1e-6;
inline constexpr double kMostTests = 16384;  // all made are fewer
inline constexpr double kZ = 6.55;

// Trials of one random number.
struct Observed {
    double count = 0, mean = 0, variance = 0;  // the unbiased one
    bool varies = false;
};

inline Observed observe(std::span<const double> values)
{
    Observed o;
    o.count = static_cast<double>(values.size());
    for (const double x : values) o.mean += x / o.count;
    for (const double x : values) o.variance += (x - o.mean) * (x - o.mean) / (o.count - 1);
    o.varies = std::any_of(values.begin(), values.end(), [&](double x) { return x != values[0]; });
    return o;
}

inline testing::AssertionResult verdict(double difference, double bound, const char* what)
{
    if (std::abs(difference) <= bound) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << what << " is off by " << difference << ", " << kZ * difference / bound
           << " standard deviations; " << kZ << " are allowed";
}

// Of numbers that are always the same: an oracle in doubles leaves some 1e-16 of their size.
inline bool is_constant(const reference::Moments& moments)
{
    return moments.variance < 1e-28;
}

// A pixel is a mean of floats: a few roundings of numbers up to 1.
inline constexpr double kPixelRounding = 4 * 0x1p-24;

inline testing::AssertionResult mean_agrees(const Observed& observed,
                                            const reference::Moments& expected)
{
    if (is_constant(expected)) {
        if (observed.varies) return testing::AssertionFailure() << "what should not vary does";
        return verdict(observed.mean - expected.mean, kPixelRounding, "the constant");
    }
    return verdict(observed.mean - expected.mean,
                   kZ * std::sqrt(expected.variance / observed.count), "the mean");
}

// Var(s^2) = (mu4 - sigma^4 (n - 3) / (n - 1)) / n. Where mu4 is hardly more than sigma^4 (two
// values, equally likely) s^2 is not normal: what is left of it is (mean - mu)^2, which has a bound
// of its own.
inline testing::AssertionResult variance_agrees(const Observed& observed,
                                                const reference::Moments& expected)
{
    if (is_constant(expected)) return mean_agrees(observed, expected);
    const double n = observed.count, v = expected.variance;
    const double variance = std::max(0.0, expected.fourth - v * v * (n - 3) / (n - 1)) / n;
    return verdict(observed.variance - v, kZ * std::sqrt(variance) + kZ * kZ * v / n,
                   "the variance");
}

// Of pairs: without correlation the coefficient has variance 1 / (n - 1).
inline testing::AssertionResult uncorrelated(std::span<const double> a, std::span<const double> b)
{
    const Observed oa = observe(a), ob = observe(b);
    if (!oa.varies || !ob.varies) return testing::AssertionFailure() << "what should vary does not";
    double covariance = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        covariance += (a[i] - oa.mean) * (b[i] - ob.mean) / (oa.count - 1);
    }
    return verdict(covariance / std::sqrt(oa.variance * ob.variance), kZ / std::sqrt(oa.count - 1),
                   "the correlation");
}

// How often something of this probability happened.
inline testing::AssertionResult count_agrees(double count, double trials, double probability)
{
    const double deviation = std::sqrt(trials * probability * (1 - probability));
    return verdict(count - trials * probability, kZ * deviation, "the count");
}

// How often each whole number came out. Outcomes too rare for a normal
// distribution are counted together.
inline void expect_counts(const std::vector<int>& outcomes, const std::vector<double>& chances)
{
    std::vector<double> counts(chances.size());
    for (const int outcome : outcomes) counts[static_cast<std::size_t>(outcome)] += 1;
    const auto trials = static_cast<double>(outcomes.size());
    double rare_count = 0, rare_chance = 0;
    for (std::size_t i = 0; i < chances.size(); ++i) {
        if (trials * chances[i] < 200) {
            rare_count += counts[i];
            rare_chance += chances[i];
            continue;
        }
        EXPECT_TRUE(count_agrees(counts[i], trials, chances[i])) << i << " samples";
    }
    // Poisson's distribution has more than this with less than the confidence's probability.
    const double mean = trials * rare_chance;
    EXPECT_LE(rare_count, mean + kZ * std::sqrt(mean) + (mean > 1e-9 ? kZ * kZ : 0.0));
}

// The moments of the mean of `count` independent numbers.
inline reference::Moments moments_of_mean(const reference::Moments& one, double count)
{
    const double square = one.variance * one.variance;
    return {one.mean, one.variance / count,
            (one.fourth + 3 * (count - 1) * square) / (count * count * count)};
}

inline std::vector<double> channel_of(const Image& image, std::size_t channel)
{
    std::vector<double> values;
    for (const auto& pixel : image.pixels) values.push_back(static_cast<double>(pixel[channel]));
    return values;
}

struct Offset {
    int x, y;
};

// Of each pixel with the one at `offset` from it.
inline testing::AssertionResult pixels_uncorrelated(const Image& image, std::size_t channel,
                                                    Offset offset)
{
    std::vector<double> a, b;
    for (int y = 0; y + offset.y < image.height; ++y) {
        for (int x = 0; x + offset.x < image.width; ++x) {
            a.push_back(static_cast<double>(image.at(x, y)[channel]));
            b.push_back(static_cast<double>(image.at(x + offset.x, y + offset.y)[channel]));
        }
    }
    return uncorrelated(a, b);
}

}  // namespace sheer
