// shaders/sheer/fade_in.glsl: against src/reference, and against numbers of the paper's equations.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lanes/lone.h"
#include "reference/hashed_threshold.h"

namespace sheer::test {
namespace {

template <class L>
struct FadeInText {
#include "lanes/text_words.h"
#include "sheer/fade_in.glsl"
};
using InFloats = FadeInText<Lone<float>>;
using InDoubles = FadeInText<Lone<double>>;

TEST(FadeInText, GrowsWithTheSquareOfTheLevel)
{
    const double rows[][2] = {{-2, 0},  {0, 0},       {1, 1. / 36}, {2, 1. / 9},
                              {3, .25}, {4.5, .5625}, {6, 1},       {7, 1}};
    for (const auto& [x, b] : rows) {
        EXPECT_NEAR(InDoubles::fade_in(x, 6), b, 1e-12) << x;
        EXPECT_NEAR(InDoubles::fade_in(x, 6), reference::fade_in(x, 6), 1e-12) << x;
        EXPECT_NEAR(static_cast<double>(InFloats::fade_in(static_cast<float>(x), 6.0f)), b, 1e-6);
    }
    const float endless = std::numeric_limits<float>::infinity();
    EXPECT_EQ(InFloats::fade_in(endless, 0.1f), 1.0f);
    EXPECT_EQ(InFloats::fade_in(-endless, 16.0f), 0.0f);
}

// Of 1,000 thresholds; b = 1/4: .3 of them let .45 pass, .7 of them .55, none .3.
TEST(FadeInText, MakesAlphaTestsOfThresholds)
{
    const auto passing = [](double opacity, double b) {
        int passed = 0;
        for (int i = 0; i < 1000; ++i) {
            const double threshold = (i + .5) / 1000;
            EXPECT_NEAR(InDoubles::faded_threshold(threshold, b),
                        reference::faded_threshold(threshold, b), 1e-12);
            passed += opacity >= InDoubles::faded_threshold(threshold, b) ? 1 : 0;
        }
        return passed / 1000.;
    };
    EXPECT_NEAR(passing(.45, .25), .3, 1e-3);
    EXPECT_NEAR(passing(.55, .25), .7, 1e-3);
    EXPECT_EQ(passing(.3, .25), 0);
    EXPECT_EQ(passing(.499, 0), 0);
    EXPECT_EQ(passing(.5, 0), 1);
    EXPECT_NEAR(passing(.2, 1), .2, 1e-3);
}

TEST(FadeInText, NoOpacityNeverPassesAllAlwaysDoes)
{
    for (const float threshold : {1e-6f, 0.3f, 1.0f}) {
        for (const float x : {-1.0f, 0.0f, 2.5f, 6.0f, 1e30f}) {
            const float t = InFloats::faded_threshold(threshold, InFloats::fade_in(x, 6.0f));
            EXPECT_GT(t, 0.0f);
            EXPECT_LE(t, 1.0f);
        }
    }
}

TEST(FadeInText, AnisotropyIsAPixelsLengthOverItsWidth)
{
    EXPECT_NEAR(InDoubles::texture_anisotropy(3, 4, 0, 1), 5, 1e-12);
    EXPECT_NEAR(InDoubles::texture_anisotropy(0, 1, 3, 4), 5, 1e-12);
    EXPECT_EQ(InFloats::texture_anisotropy(0.5f, 0, 0, -0.5f), 1.0f);
    for (int i = 1; i < 40; ++i) {
        const double a = .01 * i, b = .3 - .02 * i, c = .07, d = -.005 * i;
        EXPECT_NEAR(InDoubles::texture_anisotropy(a, b, c, d),
                    reference::anisotropy({a, b}, {c, d}), 1e-9);
    }
    // As long as nothing is wide, and of what has no extent at all.
    EXPECT_NEAR(static_cast<double>(InFloats::texture_anisotropy(1, 0, 0, 0)), 1e6, 10);
    EXPECT_EQ(InFloats::texture_anisotropy(0, 0, 0, 0), 1.0f);
    const float most = std::numeric_limits<float>::max();
    EXPECT_TRUE(std::isfinite(InFloats::texture_anisotropy(most, most, 0, 0)));
}

}  // namespace
}  // namespace sheer::test
