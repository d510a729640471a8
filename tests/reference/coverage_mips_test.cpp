// Mip levels that keep the part that passes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "reference/coverage_mips.h"
#include "reference/printed.h"
#include "reference/random_fragments.h"

namespace sheer::reference {
namespace {

TEST(ReferenceCoverageMips, FourByFourTexels)
{
    const std::vector<double> texture = {1, 1, 0, 0, 1, 0, 0, 0, .8, .4, .6, 0, 0, 0, .6, 1};
    EXPECT_EQ(passing_part(texture, .5), .4375);
    const auto mip = halved(texture, 4, 4);
    const double expected[] = {.75, 0, .3, .55};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(mip[i], expected[i], 1e-12);
    EXPECT_NEAR(threshold_for_part(mip, .4375), .425, 1e-12);
    const auto scaled = scaled_for_part(mip, .4375, .5);
    const std::string printed[] = {".882353", "0", ".352941", ".647059"};
    for (std::size_t i = 0; i < 4; ++i) expect_printed(scaled[i], printed[i]);
    EXPECT_EQ(passing_part(scaled, .5), .5);
}

TEST(ReferenceCoverageMips, AllNoneAndEqualTexels)
{
    const std::vector<double> texels = {.2, .4, .4, .8};
    EXPECT_EQ(passing_part(texels, threshold_for_part(texels, 1)), 1);
    EXPECT_EQ(passing_part(texels, threshold_for_part(texels, 0)), 0);
    EXPECT_NEAR(threshold_for_part(texels, .25), .6, 1e-12);
    EXPECT_NEAR(threshold_for_part(texels, .75), .3, 1e-12);
    EXPECT_NEAR(threshold_for_part(texels, .5), .3, 1e-12);  // as far from a quarter: the lower
    const auto clamped = scaled_for_part(texels, .75, .5);
    EXPECT_EQ(clamped[3], 1);  // .8 / .6
    EXPECT_NEAR(clamped[0], 1. / 3, 1e-12);
}

TEST(ReferenceCoverageMips, NoThresholdIsCloser)
{
    RandomFragments random(1);
    for (int round = 0; round < 50; ++round) {
        std::vector<double> texels(1 + random.below(40));
        for (double& texel : texels) {
            texel = std::floor(9 * random.uniform()) / 8;  // many are equal, some 0 or 1
        }
        const double part = random.uniform();
        const double threshold = threshold_for_part(texels, part);
        EXPECT_GT(threshold, 0);
        EXPECT_LT(threshold, 1);
        const double off = std::abs(passing_part(texels, threshold) - part);
        for (int i = 0; i < 64; ++i) {
            EXPECT_LE(off, std::abs(passing_part(texels, (i + .5) / 64) - part) + 1e-12);
        }
        const auto scaled = scaled_for_part(texels, part, .5);
        EXPECT_EQ(passing_part(scaled, .5), passing_part(texels, threshold));
    }
}

}  // namespace
}  // namespace sheer::reference
