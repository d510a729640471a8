// What shadow maps keep: of each texel's samples, those that light reaches have the moments that
// the masks' mathematics says (reference/methods.h). Confidence: methods/statistics.h.
#include <gtest/gtest.h>

#include <cmath>

#include <sheer/sheer.h>

#include "cpu/shadow_maps.h"
#include "geometry/build.h"
#include "methods/statistics.h"
#include "reference/methods.h"
#include "shadows/sheets.h"

namespace sheer {

namespace {

using reference::Masks;

const std::vector<float> kOpacities = {0.3f, 0.5f, 0.2f, 0.6f};

Shadows shadows_with(Masks masks, int samples)
{
    Shadows shadows;
    shadows.kind = ShadowKind::stochastic;
    shadows.masks = masks == Masks::naive ? ShadowMasks::naive : ShadowMasks::stratified;
    shadows.size = 64;
    shadows.samples = samples;
    return shadows;
}

// The sun's map of a scene, as a picture of the floor would have it.
std::unique_ptr<ShadowMap> suns_map(const Scene& scene, const Shadows& shadows, std::uint32_t key)
{
    const View view = test::floor_view(shadows);
    const SampleSet samples = make_sample_set(1, SamplePositions::standard);
    const Geometry geometry = build_geometry(
        {scene, resolve_camera(scene, view), {view.width, view.height, 0}, samples.extent, 1});
    const FrameSurfaces surfaces = make_surfaces(scene, 0, geometry.eye, 1, Shadowed::yes);
    FrameShadows made = prepare_shadows(
        {scene, shadows, geometry, surfaces, targets_of(Simd::best), 2, key}, Options{});
    return std::move(made.shadows.front().map);
}

// Of each texel, the part of the samples that light reaches at a height; the camera is 0.5 above
// the floor.
std::vector<double> lit_parts(const ShadowMap& map, double height)
{
    const auto& row = map.space.rows[2];
    const auto depth = static_cast<float>(row[1] * (height - 0.5) + row[3]);
    std::vector<double> parts;
    constexpr int kEdge = 4;  // beyond the sheets
    for (int y = kEdge; y < map.size - kEdge; ++y) {
        for (int x = kEdge; x < map.size - kEdge; ++x) {
            double lit = 0;
            for (int s = 0; s < map.samples; ++s) {
                lit += map.layers[0].depth[map.at(x, y) + static_cast<std::size_t>(s)] >= depth;
            }
            parts.push_back(lit / map.samples);
        }
    }
    return parts;
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
