// Maps of moments: right where moments are, and never out of what light there is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <sheer/error.h>
#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "shade/moment_part.h"
#include "shadows/maps.h"
#include "shadows/sheets.h"

namespace sheer {

namespace {

Shadows moment_shadows(int samples = 1, int filter = 1)
{
    Shadows shadows = test::stochastic_shadows(samples, filter);
    shadows.kind = ShadowKind::moment;
    return shadows;
}

// Of the sun's light what arrives at a height over the floor's middle; the camera is 0.5 above it.
double light_at(const ShadowMap& map, double height)
{
    const auto& row = map.space.rows[2];
    MapPoint point{};
    point.x = point.y = 0.5f * static_cast<float>(map.size) + 0.3f;
    point.depth = static_cast<float>(row[1] * (height - 0.5) + row[3]);
    return static_cast<double>(moment_part(map, point));
}

}  // namespace

// Below everything all of the optical depth is before a point, whatever the moments; between two
// sheets, which four moments know, they are right but for their bias (moment_test.cpp).
TEST(MomentShadows, TwoSheetsAndAllThereAreAreKnown)
{
    const std::vector<float> opacities = {0.3f, 0.5f, 0.2f, 0.6f};
    const auto two = test::suns_map(test::sheets_over_floor({0.3f, 0.5f}), moment_shadows(), 0);
    EXPECT_EQ(light_at(*two, 2.5), 1);
    EXPECT_NEAR(light_at(*two, 1.5), 0.7, 1e-3);
    EXPECT_NEAR(light_at(*two, 0.5), 0.35, 1e-3);
    const auto four = test::suns_map(test::sheets_over_floor(opacities), moment_shadows(), 0);
    EXPECT_NEAR(light_at(*four, 0.5), 0.7 * 0.5 * 0.8 * 0.4, 1e-3);
    // Without overestimation no more than there is; and never lighter farther down.
    double before = 1, truth = 1;
    for (std::size_t i = 0; i < opacities.size(); ++i) {
        truth *= 1 - static_cast<double>(opacities[i]);
        const double light = light_at(*four, static_cast<double>(opacities.size() - i) - 0.5);
        EXPECT_GE(light, truth - 1e-3);
        EXPECT_LE(light, before + 1e-3);
        before = light;
    }
    Shadows over = moment_shadows();
    over.overestimation = 1;
    const auto most = test::suns_map(test::sheets_over_floor(opacities), over, 0);
    EXPECT_LE(light_at(*most, 2.5), 0.35 + 1e-3);
}

// What covers half of a texel's samples and lets nothing through leaves half the light.
TEST(MomentShadows, OpacityCountsByWhatItCovers)
{
    Scene scene = test::sheets_over_floor({});
    Mesh half;
    half.positions = {{0, 1, -12}, {-12, 1, 0}, {0, 1, 12}};
    half.indices = {0, 1, 2};
    test::add_mesh(scene, half, test::sheet_of(0.75f));
    const auto map = test::suns_map(scene, moment_shadows(16), 0);
    const MomentTexels& texels = *map->moments;
    double least = 1;
    for (int x = 0; x < map->size; ++x) {
        const double depth =
            texels.sums[kFourMoments * (static_cast<std::size_t>(map->size / 2 * map->size) +
                                        static_cast<std::size_t>(x))];
        const double through = std::exp(-depth);
        EXPECT_GE(through, 0.25 - 1e-6);
        // The part that is covered is a number of samples.
        const double covered = (1 - through) / 0.75 * 16;
        EXPECT_NEAR(covered, std::round(covered), 1e-4);
        least = std::min(least, through);
    }
    EXPECT_NEAR(least, 0.25, 1e-6);
}

// The floor hides what is below it as in any map, and a picture's shadows are nearly the exact
// ones.
TEST(MomentShadows, PicturesOfTwoSheetsAreExact)
{
    const Scene scene = test::sheets_over_floor({0.3f, 0.5f});
    const Image moments = render(scene, test::floor_view(moment_shadows(4, 2)), {}).image;
    const Image exact = render(scene, test::floor_view(test::exact_shadows()), {}).image;
    EXPECT_LT(compare_images(moments, exact).largest, 0.5);
    View below = test::floor_view(moment_shadows());
    below.eye = Float3{0, -0.5f, 0};
    below.target = Float3{0, -3, 0};
    Scene cellar = scene;
    test::add_square(cellar, 4, -2, Material{});
    cellar.materials[0].double_sided = true;
    for (const Float4& color : render(cellar, below, {}).image.pixels) EXPECT_EQ(color[0], 0);
}

TEST(MomentShadows, AreCountedAndChecked)
{
    const Scene scene = test::sheets_over_floor({0.5f});
    Shadows shadows = moment_shadows();
    shadows.size = 8192;  // 2.5 GiB
    Options options;
    options.memory_limit = std::uint64_t{1} << 30;
    EXPECT_THROW(render(scene, test::floor_view(shadows), options), Error);
    shadows = moment_shadows();
    shadows.overestimation = 1.5f;
    EXPECT_THROW(render(scene, test::floor_view(shadows), {}), Error);
}

}  // namespace sheer
