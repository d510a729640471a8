// What shadow maps keep: of each texel's samples, those that light reaches have the moments that
// the masks' mathematics says (reference/methods.h). Confidence: methods/statistics.h.
#include <gtest/gtest.h>

#include <cmath>

#include <sheer/sheer.h>

#include "methods/statistics.h"
#include "reference/methods.h"
#include "shadows/maps.h"
#include "shadows/sheets.h"

namespace sheer {

namespace {

using reference::Masks;
using test::lit_parts, test::suns_map;

const std::vector<float> kOpacities = {0.3f, 0.5f, 0.2f, 0.6f};

Shadows shadows_with(Masks masks, int samples)
{
    Shadows shadows = test::stochastic_shadows(samples, 1);
    shadows.masks = masks == Masks::naive ? ShadowMasks::naive : ShadowMasks::stratified;
    return shadows;
}

// Behind sheet i of the scene, over some seeds.
std::vector<double> lit_parts_behind(std::size_t i, const Scene& scene, const Shadows& shadows)
{
    std::vector<double> all;
    const auto height = static_cast<double>(kOpacities.size() - i) - 0.25;
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
        const auto map = suns_map(scene, shadows, seed);
        const std::vector<double> parts = lit_parts(*map, height);
        all.insert(all.end(), parts.begin(), parts.end());
    }
    return all;
}

std::vector<double> in_doubles(const std::vector<float>& values)
{
    return {values.begin(), values.end()};
}

}  // namespace

TEST(ShadowMaps, LitSamplesHaveTheMomentsOfTheMasks)
{
    const Scene scene = test::sheets_over_floor(kOpacities);
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        for (const int samples : {1, 2, 4, 8, 16, 32, 64}) {
            const auto expected = reference::uncovered(in_doubles(kOpacities), masks, samples);
            for (std::size_t i = 0; i < kOpacities.size(); ++i) {
                SCOPED_TRACE(std::to_string(samples) + " samples, behind sheet " +
                             std::to_string(i) + (masks == Masks::naive ? ", naive" : ""));
                const Observed observed =
                    observe(lit_parts_behind(i, scene, shadows_with(masks, samples)));
                EXPECT_TRUE(mean_agrees(observed, expected[i]));
                EXPECT_TRUE(variance_agrees(observed, expected[i]));
            }
        }
    }
}

// The test above can fail: by other masks, and by an opacity that is off by a fiftieth.
TEST(ShadowMaps, PlantedFaultsAreSeen)
{
    const Scene scene = test::sheets_over_floor(kOpacities);
    const auto expected = reference::uncovered(in_doubles(kOpacities), Masks::stratified, 8);
    const Observed naive = observe(lit_parts_behind(2, scene, shadows_with(Masks::naive, 8)));
    EXPECT_FALSE(variance_agrees(naive, expected[2]));
    std::vector<float> opacities = kOpacities;
    opacities[1] += 0.02f;
    const Scene other = test::sheets_over_floor(opacities);
    const Observed off = observe(lit_parts_behind(2, other, shadows_with(Masks::stratified, 8)));
    EXPECT_FALSE(mean_agrees(off, expected[2]));
}

// What is opaque stops every sample, and hides what is behind it.
TEST(ShadowMaps, OpaqueSurfacesStopAllLight)
{
    Scene scene = test::sheets_over_floor(kOpacities);
    test::add_square(scene, 4, 2.5f, Material{});
    const auto map = suns_map(scene, shadows_with(Masks::stratified, 8), 0);
    for (const double part : lit_parts(*map, 2.25)) EXPECT_EQ(part, 0);
}

TEST(ShadowMaps, SeedsHaveNothingInCommon)
{
    const Scene scene = test::sheets_over_floor(kOpacities);
    const Shadows shadows = shadows_with(Masks::stratified, 8);
    const auto first = lit_parts(*suns_map(scene, shadows, 1), 0.5);
    for (const std::uint32_t seed : {0u, 2u, 0x80000001u}) {
        EXPECT_TRUE(uncorrelated(first, lit_parts(*suns_map(scene, shadows, seed), 0.5)));
    }
}

}  // namespace sheer
