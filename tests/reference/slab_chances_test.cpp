// Implicit coverage: chances of insertion against masks counted one by one and against numbers
// known from elsewhere, and moments against throws.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "reference/printed.h"
#include "reference/random_fragments.h"
#include "reference/slab.h"

namespace sheer::reference {
namespace {

using Fragments = std::vector<Fragment>;

constexpr Rgba kBackdrop = {0.1, 0.2, 0.3, 0.5};

TEST(ReferenceSlabChance, OfEightBits)
{
    // Rows: beta_A; columns: beta_B.
    const std::vector<std::vector<std::string>> table = {
        {"0", "1", "1", "1", "1", "1", "1", "1", "1"},
        {"0", ".875", "1", "1", "1", "1", "1", "1", "1"},
        {"0", ".75", ".964286", "1", "1", "1", "1", "1", "1"},
        {"0", ".625", ".892857", ".982143", "1", "1", "1", "1", "1"},
        {"0", ".5", ".785714", ".928571", ".985714", "1", "1", "1", "1"},
        {"0", ".375", ".642857", ".821429", ".928571", ".982143", "1", "1", "1"},
        {"0", ".25", ".464286", ".642857", ".785714", ".892857", ".964286", "1", "1"},
        {"0", ".125", ".25", ".375", ".5", ".625", ".75", ".875", "1"},
        {"0", "0", "0", "0", "0", "0", "0", "0", "0"}};
    for (std::size_t a = 0; a <= 8; ++a) {
        for (std::size_t b = 0; b <= 8; ++b) {
            SCOPED_TRACE(testing::Message() << a << " " << b);
            const double chance =
                slab_stratified_chance(8, static_cast<int>(a), static_cast<int>(b));
            // Whole numbers are exact, others are printed to six digits or fewer if these are all.
            const std::string& printed = table[a][b];
            if (printed.size() < 7) {
                EXPECT_DOUBLE_EQ(chance, std::stod(printed));
            } else {
                expect_printed(chance, printed);
            }
        }
    }
}

TEST(ReferenceSlabChance, OfOtherMasks)
{
    expect_printed(slab_stratified_chance(16, 12, 4), ".728022");
    expect_printed(slab_naive_chance(16, 12, 4 / 16.0), ".683594");
    expect_printed(slab_stratified_chance(32, 24, 8), ".930077");
    expect_printed(slab_naive_chance(32, 24, 8 / 32.0), ".899887");
    EXPECT_DOUBLE_EQ(slab_naive_chance(8, 4, 0.5), .9375);
    EXPECT_DOUBLE_EQ(slab_naive_chance(8, 6, 0.25), .4375);
    expect_printed(slab_naive_chance(8, 4, 0.125), ".413818");
}

// For masks of b bits behind one that has the lowest beta_A of them: counts[beta_A][beta_B] of
// those that show.
using Counts = std::vector<std::vector<double>>;

Counts count_visible(unsigned b)
{
    Counts counts(b + 1, std::vector<double>(b + 1));
    for (unsigned mask = 0; mask >> b == 0; ++mask) {
        for (unsigned a = 0; a < static_cast<unsigned>(std::bit_width(mask)); ++a) {
            ++counts[a][static_cast<std::size_t>(std::popcount(mask))];
        }
    }
    return counts;
}

double binomial(unsigned n, unsigned k)
{
    double result = 1;
    for (unsigned i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
    return result;
}

TEST(ReferenceSlabChance, IsThePartOfAllMasksThatShow)
{
    for (unsigned b = 1; b <= 16; ++b) {
        const Counts counts = count_visible(b);
        for (unsigned a = 0; a <= b; ++a) {
            double naive = 0;  // of bits with a chance of 0.3
            for (unsigned n = 0; n <= b; ++n) {
                const double chance = slab_stratified_chance(
                    static_cast<int>(b), static_cast<int>(a), static_cast<int>(n));
                EXPECT_NEAR(chance, counts[a][n] / binomial(b, n), 1e-14);
                naive += counts[a][n] * std::pow(0.3, n) * std::pow(0.7, b - n);
            }
            EXPECT_NEAR(slab_naive_chance(static_cast<int>(b), static_cast<int>(a), 0.3), naive,
                        1e-13);
        }
    }
}

// 1 - beta_A! (b - beta_B)! / (b! (beta_A - beta_B)!)
TEST(ReferenceSlabChance, IsTheTalksFactorials)
{
    const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
    for (int b = 1; b <= 20; ++b) {
        for (int beta_a = 0; beta_a <= b; ++beta_a) {
            for (int beta_b = 0; beta_b <= beta_a; ++beta_b) {
                const double hidden = factorial(beta_a) * factorial(b - beta_b) /
                                      (factorial(b) * factorial(beta_a - beta_b));
                EXPECT_NEAR(slab_stratified_chance(b, beta_a, beta_b), 1 - hidden, 1e-13);
            }
        }
    }
}

TEST(ReferenceSlabChance, GoesToOneWithTheBits)
{
    const auto chance = [](int b) {
        return slab_chance({b, true, SlabRounding::down, SlabRounding::down})(0.9, 0.1);
    };
    expect_printed(chance(32), ".3395");
    expect_printed(chance(128), ".7401");
    expect_printed(chance(512), ".9969");
    EXPECT_GT(chance(2048), 1 - 1e-9);
}

TEST(ReferenceSlabChance, RoundsAlphaToBits)
{
    // 8 alpha is 4.4 and 1.6.
    const double a = 0.55, b = 0.2;
    const auto p = [](int beta_a, int beta_b) { return slab_stratified_chance(8, beta_a, beta_b); };
    using enum SlabRounding;
    EXPECT_NEAR(slab_chance({8, true, down, down})(a, b), p(4, 1), 1e-15);
    EXPECT_NEAR(slab_chance({8, true, up, up})(a, b), p(5, 2), 1e-15);
    EXPECT_NEAR(slab_chance({8, true, down, random})(a, b), .4 * p(4, 1) + .6 * p(4, 2), 1e-14);
    EXPECT_NEAR(slab_chance({8, true, random, down})(a, b), .6 * p(4, 1) + .4 * p(5, 1), 1e-14);
    EXPECT_NEAR(slab_chance({8, false, down, down})(a, b), 1 - std::pow(7.0 / 8, 4), 1e-15);
    EXPECT_NEAR(slab_chance({8, false, down, down, true})(a, b), 1 - std::pow(0.8, 4), 1e-15);
    EXPECT_EQ(slab_chance({8, true})(0.5, 0), 0);
    EXPECT_EQ(slab_chance({8, true})(1, 1), 0);
}

// alpha is a multiple of 1/8.
const Fragments kFragments = {{3, 0.75, {0.2, 0.8, 0.5}, 2},
                              {1, 0.5, {0.9, 0.3, 0.1}, 1},
                              {2, 0.25, {0.1, 0.4, 0.8}, 3},
                              {4, 0.875, {0.7, 0.7, 0.2}, 4}};

TEST(ReferenceSlabImplicit, BehindOneLayerAFragmentIsKeptWithItsChance)
{
    for (int a = 0; a <= 8; ++a) {
        for (int b = 0; b <= 8; ++b) {
            const Fragments two = {{1, a / 8.0, {1, 0, 0}, 1}, {2, b / 8.0, {0, 1, 0}, 2}};
            const auto moments = slab_implicit_moments(two, 2, slab_chance({8, true}),
                                                       SlabResolve::depth_corrected, {});
            EXPECT_NEAR(moments.kept[0], a > 0 ? 1 : 0, 1e-15);
            EXPECT_NEAR(moments.kept[1], slab_stratified_chance(8, a, b), 1e-14);
        }
    }
}

TEST(ReferenceSlabImplicit, AlwaysInsertingIsInfinitelyManyBits)
{
    RandomFragments random(1);
    for (int round = 0; round < 20; ++round) {
        const Fragments fragments = random.list(6);
        for (const int k : {1, 3, 6}) {
            const Rgba expected = slab(fragments, slab_store_of_alpha(fragments, k),
                                       SlabResolve::depth_corrected, kBackdrop);
            const SlabChance one = [](double, double) { return 1.0; };
            const auto thrown =
                slab_implicit_moments(fragments, k, one, SlabResolve::depth_corrected, kBackdrop);
            EXPECT_NEAR(thrown.channels[0].mean, expected.r, 1e-12);
            EXPECT_NEAR(thrown.channels[0].variance, 0, 1e-12);
            expect_same(slab(fragments, slab_systematic_store(fragments, k, one, 0.5),
                             SlabResolve::depth_corrected, kBackdrop),
                        expected);
        }
    }
}

TEST(ReferenceSlabImplicit, MomentsAreThoseOfThrows)
{
    constexpr int kTrials = 20000;
    const SlabChance chance = slab_chance({8, true});
    RandomFragments random(2);
    const auto exact =
        slab_implicit_moments(kFragments, 2, chance, SlabResolve::depth_corrected, kBackdrop);
    double mean = 0;
    std::vector<double> kept(4);
    for (int trial = 0; trial < kTrials; ++trial) {
        const SlabStore store =
            slab_implicit_store(kFragments, 2, [&](std::size_t i, double alpha_a) {
                return random.uniform() < chance(alpha_a, kFragments[i].opacity);
            });
        mean += slab(kFragments, store, SlabResolve::depth_corrected, kBackdrop).g / kTrials;
        for (std::size_t i = 0; i < 4; ++i) {
            for (const SlabLayer& layer : store.layers) {
                if (layer.id == kFragments[i].id) kept[i] += 1.0 / kTrials;
            }
        }
    }
    // Four standard deviations of each mean.
    const auto bound = [](double variance) { return 4 * std::sqrt(variance / kTrials); };
    EXPECT_NEAR(mean, exact.channels[1].mean, bound(exact.channels[1].variance));
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(kept[i], exact.kept[i], bound(exact.kept[i] * (1 - exact.kept[i])) + 1e-12);
    }
    // A chance of one bit more is told apart.
    const auto other = slab_implicit_moments(kFragments, 2, slab_chance({9, true}),
                                             SlabResolve::depth_corrected, kBackdrop);
    EXPECT_GT(std::abs(mean - other.channels[1].mean), bound(other.channels[1].variance));
}

TEST(ReferenceSlabSystematic, MomentsAreTheMeanOverXi)
{
    constexpr int kSteps = 20000;
    for (const SlabChance& chance :
         {slab_chance({8, true}), SlabChance([](double, double alpha) { return alpha; })}) {
        for (const int k : {1, 2, 4}) {
            const auto exact = slab_systematic_moments(kFragments, k, chance,
                                                       SlabResolve::color_corrected, kBackdrop);
            double mean = 0, square = 0;
            for (int step = 0; step < kSteps; ++step) {
                const SlabStore store =
                    slab_systematic_store(kFragments, k, chance, (step + 0.5) / kSteps);
                const Rgba got = slab(kFragments, store, SlabResolve::color_corrected, kBackdrop);
                mean += got.r / kSteps;
                square += got.r * got.r / kSteps;
            }
            // Colours within [0, 1] jump at most at 16 values of xi, each within one step.
            EXPECT_NEAR(mean, exact.channels[0].mean, 16.0 / kSteps);
            EXPECT_NEAR(square - mean * mean, exact.channels[0].variance, 32.0 / kSteps);
        }
    }
}

TEST(ReferenceSlabSystematic, WithoutRegardToTheFrontEachIsKeptWithItsChance)
{
    const SlabChance alpha = [](double, double b) { return b; };
    const auto moments = slab_systematic_moments(kFragments, 4, alpha, SlabResolve::color, {});
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(moments.kept[i], kFragments[i].opacity, 1e-12);
    }
    // Of 2.375 expected layers there are 2 or 3, never fewer or more.
    for (int step = 0; step < 100; ++step) {
        const auto store = slab_systematic_store(kFragments, 4, alpha, step / 100.0);
        EXPECT_EQ(store.layers.size(), step < 63 ? 2u : 3u);
    }
}

}  // namespace
}  // namespace sheer::reference
