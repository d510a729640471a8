// Phenomenological transparency: weights and colours worked out by hand.
#include <gtest/gtest.h>

#include <vector>

#include "reference/five_layers.h"
#include "reference/phenomenological.h"
#include "reference/printed.h"

namespace sheer::reference {
namespace {

constexpr Rgba kBackdrop = {0.1, 0.2, 0.3, 0.5};

TEST(ReferencePhenomenological, Weights)
{
    EXPECT_DOUBLE_EQ(phenomenological_weight(0.5, 0), 0.5);
    EXPECT_DOUBLE_EQ(phenomenological_weight(0.5, 0.9), 0.5);  // .109^3 is more than 1e-4
    EXPECT_NEAR(phenomenological_weight(0.5, 0.99), 0.039402995, 1e-12);  // .0199^3 = 7.880599e-6
    EXPECT_NEAR(phenomenological_weight(0.5, 1), 0.005, 1e-14);
    EXPECT_DOUBLE_EQ(phenomenological_weight(0, 0.5), 1e-3);
    EXPECT_DOUBLE_EQ(phenomenological_weight(1e-4, 0), 1e-3);
}

TEST(ReferencePhenomenological, OneFragmentGoesOver)
{
    const std::vector<Fragment> gray = {{0.3, 0.6, {0.9, 0.5, 0.1}, 1}};
    for (const BackdropPart part : {BackdropPart::mean, BackdropPart::each}) {
        expect_same(phenomenological(gray, part, kBackdrop), composite(gray, kBackdrop));
    }
    const std::vector<Fragment> glass = {{0.3, 0.5, {0.9, 0.5, 0.1}, 1, {0.9, 0.4, 0.2}}};
    expect_same(phenomenological(glass, BackdropPart::mean, kBackdrop),
                composite(glass, kBackdrop));
    expect_same(phenomenological(glass, BackdropPart::each, kBackdrop),
                {0.1 * 0.9 + 0.9 * 0.1, 0.6 * 0.5 + 0.4 * 0.2, 0.8 * 0.1 + 0.2 * 0.3, 0.75});
}

TEST(ReferencePhenomenological, TwoFragmentsByHand)
{
    // Weights .5 and .005; times opacity .25 and .0025.
    const std::vector<Fragment> two = {{0, 0.5, {1, 0, 0}, 1}, {1, 0.5, {0, 0, 1}, 2}};
    const double far = 0.0025 / 0.2525;
    for (const BackdropPart part : {BackdropPart::mean, BackdropPart::each}) {
        expect_same(phenomenological(two, part, {0, 1, 0, 1}),
                    {0.75 * (1 - far), 0.25, 0.75 * far, 1});
    }
}

TEST(ReferencePhenomenological, TheOrderOfArrivalDoesNotMatter)
{
    const Rgba expected = phenomenological(kFiveLayers, BackdropPart::mean, kBackdrop);
    for_every_order([&](const auto& f) {
        expect_same(phenomenological(f, BackdropPart::mean, kBackdrop), expected);
    });
    EXPECT_NEAR(expected.a, 1 - 0.0672 / 2, 1e-12);
    expect_same(phenomenological({}, BackdropPart::mean, kBackdrop), kBackdrop);
}

TEST(ReferencePhenomenological, Diffusion)
{
    EXPECT_EQ(phenomenological_diffusion(0.5, 1, 2, 3), 0);  // collimated
    EXPECT_EQ(phenomenological_diffusion(0.5, 0, 2, 0), 0);  // touches
    EXPECT_NEAR(phenomenological_diffusion(0.5, 0, 2, 0.1), 1, 1e-12);
    EXPECT_NEAR(phenomenological_diffusion(0.5, 0.5, 2, 0.3), 0.5625, 1e-12);
}

}  // namespace
}  // namespace sheer::reference
