// Masks of alpha to coverage: counts and overlaps, exactly and by throws.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "reference/alpha_to_coverage.h"
#include "reference/methods.h"
#include "reference/printed.h"
#include "reference/random_fragments.h"

namespace sheer::reference {
namespace {

struct Spread {
    double mean = 0, deviation = 0;  // of the part of the samples
};

Spread spread_of(const std::vector<double>& chances)
{
    Spread spread;
    const auto n = static_cast<double>(chances.size() - 1);
    for (std::size_t h = 0; h < chances.size(); ++h) spread.mean += chances[h] * double(h) / n;
    for (std::size_t h = 0; h < chances.size(); ++h) {
        spread.deviation += chances[h] * std::pow(double(h) / n - spread.mean, 2);
    }
    spread.deviation = std::sqrt(spread.deviation);
    return spread;
}

TEST(ReferenceAlphaToCoverage, FixedThresholdsRound)
{
    for (const int n : {1, 4, 8}) {
        for (int step = 0; step <= 100; ++step) {
            const double alpha = step / 100.0;
            int count = 0;
            for (int i = 0; i < n; ++i) count += alpha >= fixed_threshold(i, n) ? 1 : 0;
            const auto chances = count_chances(n, alpha, CoverageMasks::fixed);
            EXPECT_EQ(chances[static_cast<std::size_t>(count)], 1) << n << " " << alpha;
        }
    }
    EXPECT_EQ(count_chances(8, 0.1, CoverageMasks::fixed)[1], 1);  // not floor(.8)
}

TEST(ReferenceAlphaToCoverage, FiveWaysToKeepAHalfOfEight)
{
    const auto chances = overlap_chances(8, .5, .5, CoverageMasks::decorrelated);
    const double expected[] = {1. / 16, 1. / 4, 3. / 8, 1. / 4, 1. / 16, 0, 0, 0, 0};
    for (std::size_t h = 0; h <= 8; ++h) EXPECT_NEAR(chances[h], expected[h], 1e-12);
}

TEST(ReferenceAlphaToCoverage, SpreadOfTheOverlap)
{
    // Of any sets the variance of a hypergeometric number: 1 / 16 / (n - 1).
    const std::pair<int, std::string> any_set[] = {{4, ".1443"}, {8, ".0945"}, {16, ".0645"}};
    for (const auto& [n, printed] : any_set) {
        const Spread any = spread_of(overlap_chances(n, .5, .5, CoverageMasks::any_set));
        EXPECT_NEAR(any.mean, .25, 1e-12);
        expect_printed(any.deviation, printed);
        const Spread ours = spread_of(overlap_chances(n, .5, .5, CoverageMasks::decorrelated));
        EXPECT_NEAR(ours.mean, .25, 1e-12);
        EXPECT_NEAR(ours.deviation, std::sqrt(1 / (8.0 * n)), 1e-12);
    }
}

TEST(ReferenceAlphaToCoverage, WithoutDecorrelationTheSmallerIsAllShared)
{
    for (const CoverageMasks masks : {CoverageMasks::fixed, CoverageMasks::jittered}) {
        EXPECT_NEAR(spread_of(overlap_chances(8, .5, .75, masks)).mean, .5, 1e-12);
    }
    EXPECT_NEAR(spread_of(overlap_chances(8, .3, .7, CoverageMasks::decorrelated)).mean, .21,
                1e-12);
    EXPECT_NEAR(spread_of(overlap_chances(8, .3, .7, CoverageMasks::any_set)).mean, .21, 1e-12);
}

// Any set of a fragment's samples behind another's is what stochastic transparency has.
TEST(ReferenceAlphaToCoverage, AnySetIsStratifiedMasks)
{
    const double alphas[] = {.3, .7};
    const auto overlap = spread_of(overlap_chances(16, .3, .7, CoverageMasks::any_set));
    const auto open = uncovered(alphas, Masks::stratified, 16).back();
    // Uncovered = 1 - a - b + overlap, on the mean.
    EXPECT_NEAR(open.mean, 1 - .3 - .7 + overlap.mean, 1e-12);
}

std::uint64_t decorrelated_mask(int n, double alpha, bool one_chi, RandomFragments& random)
{
    const int offset = decorrelated_offset(n, random.uniform());
    const int increment = decorrelated_increment(n, random.uniform());
    EXPECT_LT(offset, n);
    EXPECT_EQ(increment % 2, 1);
    const double chi = random.uniform();
    std::uint64_t mask = 0;
    for (int i = 0; i < n; ++i) {
        const double own = one_chi ? chi : random.uniform();
        if (alpha >= decorrelated_threshold(i, n, own, offset, increment)) {
            mask |= std::uint64_t{1} << i;
        }
    }
    return mask;
}

TEST(ReferenceAlphaToCoverage, ChancesAreThoseOfThrows)
{
    constexpr int kTrials = 20000, n = 8;
    RandomFragments random(1);
    for (const bool one_chi : {true, false}) {
        std::vector<double> counts(n + 1), overlaps(n + 1);
        for (int trial = 0; trial < kTrials; ++trial) {
            const auto a = decorrelated_mask(n, .3, one_chi, random);
            const auto b = decorrelated_mask(n, .65, one_chi, random);
            counts[static_cast<std::size_t>(std::popcount(a))] += 1. / kTrials;
            overlaps[static_cast<std::size_t>(std::popcount(a & b))] += 1. / kTrials;
        }
        const auto expected_counts = count_chances(n, .3, CoverageMasks::decorrelated);
        const auto expected = overlap_chances(n, .3, .65, CoverageMasks::decorrelated);
        const auto other = overlap_chances(n, .3, .65, CoverageMasks::any_set);
        double off = 0;
        for (std::size_t h = 0; h <= n; ++h) {
            // Four standard deviations.
            const auto bound = [](double p) { return 4 * std::sqrt(p * (1 - p) / kTrials); };
            EXPECT_NEAR(counts[h], expected_counts[h], bound(expected_counts[h]) + 1e-12);
            EXPECT_NEAR(overlaps[h], expected[h], bound(expected[h]) + 1e-12);
            off = std::max(off, std::abs(overlaps[h] - other[h]) - bound(other[h]));
        }
        EXPECT_GT(off, 0);  // other masks are told apart
    }
}

TEST(ReferenceAlphaToCoverage, JitteredThresholdsKeepTheFirstSamples)
{
    for (int step = 0; step < 64; ++step) {
        const double chi = (step + .5) / 64;
        int count = 0;
        bool first = true;
        for (int i = 0; i < 8; ++i) {
            const bool kept = .45 >= jittered_threshold(i, 8, chi);
            first = first && (kept == (i == count));
            if (kept) ++count;
        }
        EXPECT_EQ(count, chi <= .6 ? 4 : 3);  // 8 alpha = 3.6
    }
    const auto chances = count_chances(8, .45, CoverageMasks::jittered);
    EXPECT_NEAR(chances[4], .6, 1e-12);
    EXPECT_NEAR(std::accumulate(chances.begin(), chances.end(), 0.0), 1, 1e-12);
}

}  // namespace
}  // namespace sheer::reference
