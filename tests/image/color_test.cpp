// The sRGB curve: anchors of the standard, both directions, and rounding to 8 bits.
#include "image/color.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace sheer {
namespace {

TEST(Color, CurveMeetsItsAnchors)
{
    EXPECT_EQ(linear_from_srgb(0), 0);
    EXPECT_EQ(linear_from_srgb(1), 1);
    EXPECT_EQ(srgb_from_linear(0), 0);
    EXPECT_NEAR(srgb_from_linear(1), 1, 1e-15);
    EXPECT_DOUBLE_EQ(linear_from_srgb(0.02), 0.02 / 12.92);
    EXPECT_NEAR(linear_from_srgb(0.5), 0.21404114048223255, 1e-15);
    EXPECT_NEAR(srgb_from_linear(0.5), 0.73535698305244946, 1e-15);
}

TEST(Color, DirectionsUndoEachOther)
{
    for (int i = 0; i <= 1000; ++i) {
        const double x = i / 1000.0;
        EXPECT_NEAR(srgb_from_linear(linear_from_srgb(x)), x, 2e-15);
    }
}

TEST(Color, EightBitsAreTheRoundedCurve)
{
    for (int i = 0; i <= 100000; ++i) {
        const double x = i / 100000.0;
        EXPECT_EQ(srgb8_from_linear(x), std::floor(255 * srgb_from_linear(x) + 0.5)) << x;
    }
    for (int c = 0; c <= 255; ++c) EXPECT_EQ(srgb8_from_linear(linear_from_srgb(c / 255.0)), c);
}

TEST(Color, EightBitsTakeAnyNumber)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(srgb8_from_linear(-1), 0);
    EXPECT_EQ(srgb8_from_linear(-kInfinity), 0);
    EXPECT_EQ(srgb8_from_linear(std::numeric_limits<double>::quiet_NaN()), 0);
    EXPECT_EQ(srgb8_from_linear(1.5), 255);
    EXPECT_EQ(srgb8_from_linear(kInfinity), 255);
}

}  // namespace
}  // namespace sheer
