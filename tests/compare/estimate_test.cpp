// Intervals of confidence against printed tables and numbers drawn for the purpose.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "compare/estimate.h"
#include "support/math.h"
#include "support/random.h"

namespace sheer {
namespace {

// Printed in every table of Student's distribution, two-sided, 0.01.
TEST(Estimates, StudentsQuantilesAreThePrintedOnes)
{
    EXPECT_NEAR(student_within(2), 9.925, 0.0005);
    EXPECT_NEAR(student_within(4), 4.604, 0.0005);
    EXPECT_NEAR(student_within(8), 3.355, 0.0005);
    EXPECT_NEAR(student_within(16), 2.921, 0.0005);
    EXPECT_NEAR(student_within(120), 2.617, 0.0005);
}

TEST(Estimates, AMeanOfThreeIsWorkedOutByHand)
{
    const double values[] = {1, 2, 6};  // mean 3, squares 4 + 1 + 9, deviation sqrt(7)
    const Estimate estimate = estimate_mean(values);
    EXPECT_NEAR(estimate.mean, 3, 1e-12);
    EXPECT_NEAR(estimate.within, 9.9248 * std::sqrt(7.0 / 3), 1e-3);
}

// Of 20,000 intervals 200 miss, with a deviation of sqrt(20,000 x 0.01 x 0.99) = 14; six of them.
TEST(Estimates, OneIntervalInAHundredMisses)
{
    const CounterRandom random{7};
    constexpr int kTrials = 20000;
    int missed = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<double> values;
        for (int i = 0; i < 5; ++i) {
            const auto at = static_cast<std::uint64_t>(10 * trial + 2 * i);
            const double radius = std::sqrt(-2 * own_log(1 - random.uniform(at)));
            values.push_back(radius * own_cos(6.283185307179586 * random.uniform(at + 1)));
        }
        const Estimate estimate = estimate_mean(values);
        missed += std::abs(estimate.mean) > estimate.within ? 1 : 0;
    }
    EXPECT_NEAR(missed, 200, 84);
}

TEST(Estimates, ARatioIsThatOfRoots)
{
    const double squares[] = {4, 4.4, 3.6}, by[] = {16, 17.6, 14.4};
    const RatioEstimate same = estimate_ratio(squares, by);
    EXPECT_NEAR(same.ratio, 0.5, 1e-12);
    EXPECT_NEAR(same.most - same.least, 0, 1e-12);
    const double others[] = {17, 14, 16};
    const RatioEstimate estimate = estimate_ratio(squares, others);
    EXPECT_LT(estimate.least, estimate.ratio);
    EXPECT_NEAR(estimate.least * estimate.most, estimate.ratio * estimate.ratio, 1e-12);
}

}  // namespace
}  // namespace sheer
