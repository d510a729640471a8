// Maps of moments to [0, 1]: their ranges, their inverses, and rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "reference/printed.h"
#include "reference/rounded_moments.h"

namespace sheer::reference {
namespace {

// The papers' constants have 8 to 10 decimals; four of them with factors below 100 make a number.
constexpr double kConstants = 1e-8, kOfFour = 4 * 100 * 0.5e-8;

constexpr RoundedMoments kKinds[] = {RoundedMoments::shadow, RoundedMoments::four,
                                     RoundedMoments::six, RoundedMoments::eight};

std::vector<double> powers(double z, RoundedMoments kind)
{
    const std::size_t most = kind == RoundedMoments::six     ? 6
                             : kind == RoundedMoments::eight ? 8
                                                             : 4;
    std::vector<double> b;
    for (std::size_t j = 1; j <= most; ++j) b.push_back(std::pow(z, static_cast<double>(j)));
    return b;
}

TEST(ReferenceRoundedMoments, ADepthTakesAllOfTheUnitRange)
{
    for (const RoundedMoments kind : kKinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        const double low = kind == RoundedMoments::shadow ? 0 : -1;
        std::vector<double> least(powers(0, kind).size(), 1), most(least.size(), 0);
        constexpr int kSteps = 4000;
        for (int i = 0; i <= kSteps; ++i) {
            const double z = low + (1 - low) * i / kSteps;
            const auto numbers = to_unit_range(powers(z, kind), kind);
            for (std::size_t j = 0; j < numbers.size(); ++j) {
                least[j] = std::min(least[j], numbers[j]);
                most[j] = std::max(most[j], numbers[j]);
            }
        }
        // Between steps polynomials with second derivatives below 5000 have bends of less than
        // 5000 / 8 times a step squared.
        const double bend = 5000.0 / 8 * 4 / kSteps / kSteps;
        for (std::size_t j = 0; j < least.size(); ++j) {
            EXPECT_GE(least[j], -kOfFour);
            EXPECT_LE(least[j], bend);
            EXPECT_LE(most[j], 1 + kOfFour);
            EXPECT_GE(most[j], 1 - bend);
        }
    }
}

TEST(ReferenceRoundedMoments, HalfWayOfAShadowMap)
{
    const auto numbers = to_unit_range(powers(0.5, RoundedMoments::shadow), RoundedMoments::shadow);
    const std::string printed[] = {".948353", ".074534", ".328812", ".949801"};
    for (std::size_t j = 0; j < 4; ++j) expect_printed(numbers[j], printed[j]);
}

TEST(ReferenceRoundedMoments, BackAndForth)
{
    for (const RoundedMoments kind : kKinds) {
        for (const double z : {0.1, 0.45, 0.8}) {
            auto b = powers(z, kind);
            const auto other = powers(1 - 0.7 * z, kind);
            for (std::size_t j = 0; j < b.size(); ++j) b[j] = 0.3 * b[j] + 0.7 * other[j];
            const auto back = from_unit_range(to_unit_range(b, kind), kind);
            for (std::size_t j = 0; j < b.size(); ++j) EXPECT_NEAR(back[j], b[j], 1e-11);
        }
    }
}

// How number i, half of the unit range further, changes moment j.
double slope(RoundedMoments kind, std::size_t i, std::size_t j)
{
    std::vector<double> low(powers(0, kind).size(), 0.25), high = low;
    high[i] += 0.5;
    return 2 * (from_unit_range(high, kind)[j] - from_unit_range(low, kind)[j]);
}

TEST(ReferenceRoundedMoments, PublishedInverses)
{
    const double shadow[4][4] = {{0.2227744146, 0.1549679261, 0.1451988946, 0.163127443},
                                 {0.0771972861, 0.1394629426, 0.2120202157, 0.2591432266},
                                 {0.7926986636, 0.7963415838, 0.7258694464, 0.6539092497},
                                 {0.0319417555, -0.1722823173, -0.2758014811, -0.3376131734}};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            EXPECT_NEAR(slope(RoundedMoments::shadow, i, j), shadow[i][j], kConstants);
        }
    }
    const double root = std::sqrt(3.0);
    const double four[4][4] = {
        {-1. / 3, 0, -.75, 0}, {0, .125, 0, -.125}, {root, 0, .75 * root, 0}, {0, 1, 0, 1}};
    const double six[6][6] = {{-.02877789192, 0, .09995235706, 0, .25893353755, 0},
                              {0, .00001253044, 0, -.24998746956, 0, -.37498825271},
                              {.47635550422, 0, .84532580931, 0, .90779616657, 0},
                              {0, .16668494186, 0, .16668494186, 0, .21876713299},
                              {1.55242808973, 0, 1.05472570761, 0, .83327335647, 0},
                              {0, .86602540579, 0, .86602540579, 0, .81189881793}};
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            EXPECT_NEAR(slope(RoundedMoments::six, i, j), six[i][j], kConstants);
            if (i > 3 || j > 3) continue;
            EXPECT_NEAR(slope(RoundedMoments::four, i, j), four[i][j], 1e-12);
        }
    }
}

TEST(ReferenceRoundedMoments, SixteenBits)
{
    EXPECT_EQ(rounded_to_16_bits(0), 0);
    EXPECT_EQ(rounded_to_16_bits(1), 1);
    EXPECT_EQ(rounded_to_16_bits(1.1), 1);
    EXPECT_EQ(rounded_to_16_bits(-0.1), 0);
    EXPECT_DOUBLE_EQ(rounded_to_16_bits(0.4 / 65535), 0);
    EXPECT_DOUBLE_EQ(rounded_to_16_bits(0.6 / 65535), 1.0 / 65535);
}

}  // namespace
}  // namespace sheer::reference
