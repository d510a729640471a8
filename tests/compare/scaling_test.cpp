// Exponents of known laws, and scenes with more layers.
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <sheer/sheer.h>

#include "compare/scaling.h"

namespace sheer::test {

namespace {

using Numbers = std::vector<double>;

// Logarithms and sums of a few numbers of magnitude 10 round by a few 1e-15 each.
constexpr double kRounding = 1e-12;

TEST(Scaling, ExponentsOfKnownLaws)
{
    const Numbers x = {1, 2, 4, 8, 100};
    for (const double exponent : {-1.0, 0.0, 0.5, 1.0, 2.0}) {
        Numbers y;
        for (const double value : x) y.push_back(3.7 * std::pow(value, exponent));
        const PowerLaw law = fit_power_law(x, y);
        EXPECT_NEAR(law.exponent, exponent, kRounding);
        EXPECT_NEAR(law.error, 0, kRounding);
    }
}

// Logarithms to the base 2: (0, 0), (1, 1), (2, 3). The slope is ((-1)(-4/3) + (1)(5/3)) / 2, what
// is left of the three 1/6, -1/3, 1/6: a variance of 1/6 at one degree of freedom, over 2.
TEST(Scaling, ErrorOfAnExponent)
{
    const PowerLaw law = fit_power_law(Numbers{1, 2, 4}, Numbers{1, 2, 8});
    EXPECT_NEAR(law.exponent, 1.5, kRounding);
    EXPECT_NEAR(law.error, std::sqrt(1.0 / 12), kRounding);
}

// A fixed cost beside one in proportion is seen: 10 + x over 1..8 grows by less than the power 1/2.
TEST(Scaling, AFixedCostLowersTheExponent)
{
    const PowerLaw law = fit_power_law(Numbers{1, 2, 4, 8}, Numbers{11, 12, 14, 18});
    EXPECT_GT(law.exponent, 0);
    EXPECT_LT(law.exponent, 0.5);
    EXPECT_GT(law.error, 0);
}

TEST(Scaling, TwoPointsHaveNoError)
{
    const PowerLaw law = fit_power_law(Numbers{2, 8}, Numbers{5, 20});
    EXPECT_NEAR(law.exponent, 1, kRounding);
    EXPECT_TRUE(std::isnan(law.error));
}

TEST(Scaling, NoLawWhereThereIsNone)
{
    const Numbers none = {}, one = {1}, same = {3, 3, 3}, zero = {0, 1, 2}, negative = {-1, 2, 3};
    const Numbers good = {1, 2, 3};
    const std::vector<std::pair<Numbers, Numbers>> pairs = {
        {none, none}, {one, one}, {same, good}, {zero, good}, {good, zero}, {good, negative}};
    for (const auto& [x, y] : pairs) {
        const PowerLaw law = fit_power_law(x, y);
        EXPECT_TRUE(std::isnan(law.exponent)) << testing::PrintToString(x);
        EXPECT_TRUE(std::isnan(law.error)) << testing::PrintToString(x);
    }
}

std::uint64_t fragments_of(const Scene& scene)
{
    View view;
    view.width = 24;
    view.height = 16;
    view.samples = 4;
    Options options;
    options.method = "none";
    return render(scene, view, options).stats.fragments;
}

TEST(Scaling, LayersMultiplyTheFragments)
{
    for (const char* source : {"builtin:layers?n=3", "builtin:quads"}) {
        const Scene scene = load(source);
        const std::uint64_t fragments = fragments_of(scene);
        ASSERT_GT(fragments, 0u);
        for (const int times : {1, 2, 5}) {
            Scene more = scene;
            more.objects = repeat_transparent(scene, times, false);
            EXPECT_EQ(fragments_of(more), fragments * static_cast<unsigned>(times)) << source;
        }
    }
}

TEST(Scaling, LayersLeaveWhatIsOpaqueAlone)
{
    Scene scene = load("builtin:layers?n=3");
    scene.materials[1].alpha_mode = AlphaMode::opaque;
    scene.objects[2].id = 1000;
    const std::vector<Object> objects = repeat_transparent(scene, 3, false);
    ASSERT_EQ(objects.size(), 3u + 2 * 2);
    std::set<std::uint32_t> ids;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        ids.insert(objects[i].id);
        if (i >= 3) {
            EXPECT_NE(objects[i].mesh, 1u);
        }
    }
    EXPECT_EQ(ids.size(), objects.size());
}

TEST(Scaling, MaskedLayersAreRepeatedForMethodsThatTestThem)
{
    Scene scene = load("builtin:layers?n=3");
    for (Material& material : scene.materials) material.alpha_mode = AlphaMode::mask;
    EXPECT_EQ(repeat_transparent(scene, 3, false).size(), 3u);
    EXPECT_EQ(repeat_transparent(scene, 3, true).size(), 9u);
}

}  // namespace

}  // namespace sheer::test
