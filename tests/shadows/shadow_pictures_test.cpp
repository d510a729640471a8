// Shadows in pictures: right on average, exactly right where they are exact, and none where nothing
// is in the light's way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <sheer/sheer.h>

#include "methods/statistics.h"
#include "shadows/sheets.h"

namespace sheer {

namespace {

using test::exact_shadows, test::stochastic_shadows;

double mean_of(const Image& image)
{
    const auto values = channel_of(image, 0);
    return observe(values).mean;
}

Light spot_above(float height)
{
    Light light;
    light.kind = LightKind::spot;
    light.position = {0, height, 0};
    light.direction = {0, -1, 0};
    light.inner_cone = 0.6f;
    light.outer_cone = 0.8f;
    light.intensity = {30, 30, 30};
    return light;
}

// The same light without what stands in its way.
Image without_shadows(const Scene& scene, View view)
{
    view.shadows = {};
    return render(scene, view, {}).image;
}

// Of the light that arrives without shadows, least and most over the lit pixels; those whose light
// is weaker than `dim` don't count.
std::pair<double, double> visible_range(const Scene& scene, const View& view, double dim)
{
    const Image with = render(scene, view, {}).image, without = without_shadows(scene, view);
    double least = 1, most = 0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i) {
        const auto full = static_cast<double>(without.pixels[i][0]);
        if (full <= dim) continue;
        const double part = static_cast<double>(with.pixels[i][0]) / full;
        least = std::min(least, part);
        most = std::max(most, part);
    }
    return {least, most};
}

// A white floor that the sun meets at `degrees` from its normal, seen from above; nothing else.
Scene tilted_sun(double degrees)
{
    Scene scene = test::sheets_over_floor({});
    const double angle = degrees * 3.14159265358979 / 180;
    const auto side = static_cast<float>(std::sin(angle) * 0.8);
    const auto other = static_cast<float>(std::sin(angle) * 0.6);
    scene.sun.to_light = {side, static_cast<float>(std::cos(angle)), other};
    return scene;
}

Scene sphere_under_sun()
{
    constexpr int kRings = 48, kSides = 96;
    Scene scene = test::sheets_over_floor({});
    scene.objects.clear();
    Mesh ball;
    for (int i = 0; i <= kRings; ++i) {
        for (int j = 0; j <= kSides; ++j) {
            const double a = 3.14159265358979 * i / kRings, b = 2 * 3.14159265358979 * j / kSides;
            const Float3 p = {static_cast<float>(std::sin(a) * std::cos(b)),
                              static_cast<float>(std::cos(a)),
                              static_cast<float>(std::sin(a) * std::sin(b))};
            ball.positions.push_back(p);
            ball.normals.push_back(p);
        }
    }
    for (std::uint32_t i = 0; i < kRings; ++i) {
        for (std::uint32_t j = 0; j < kSides; ++j) {
            const std::uint32_t at = i * (kSides + 1) + j, below = at + kSides + 1;
            for (const std::uint32_t k : {at, at + 1, below, below, at + 1, below + 1}) {
                ball.indices.push_back(k);
            }
        }
    }
    scene.meshes.push_back(ball);
    Object object;
    object.mesh = static_cast<std::uint32_t>(scene.meshes.size() - 1);
    scene.objects.push_back(object);
    scene.sun.to_light = {0.6f, 0.8f, 0};
    return scene;
}

View from(Float3 eye)
{
    View view;
    view.width = view.height = 96;
    view.samples = 1;
    view.eye = eye;
    view.target = Float3{0, 0, 0};
    return view;
}

}  // namespace

// A picture is one trial: its texels are many, and pictures of other seeds have others.
TEST(ShadowPictures, StochasticShadowsAreRightOnAverage)
{
    const std::vector<float> opacities = {0.3f, 0.5f, 0.2f, 0.6f};
    const double expected = 0.7 * 0.5 * 0.8 * 0.4;
    Scene under_sun = test::sheets_over_floor(opacities);
    for (const ShadowMasks masks : {ShadowMasks::naive, ShadowMasks::stratified}) {
        for (const auto& [samples, filter] :
             {std::pair(1, 1), std::pair(1, 4), std::pair(2, 3), std::pair(8, 1), std::pair(16, 2),
              std::pair(64, 1)}) {
            SCOPED_TRACE(std::to_string(samples) + " samples, filter " + std::to_string(filter));
            Shadows shadows = stochastic_shadows(samples, filter);
            shadows.masks = masks;
            std::vector<double> means;
            for (std::uint64_t seed = 0; seed < 60; ++seed) {
                Options options;
                options.seed = seed;
                means.push_back(
                    mean_of(render(under_sun, test::floor_view(shadows), options).image));
            }
            const Observed o = observe(means);
            EXPECT_TRUE(
                verdict(o.mean - expected, kZ * std::sqrt(o.variance / o.count), "the mean"));
            // Few samples leave too much noise to see a tenth too much light.
            if (samples < 8) continue;
            EXPECT_FALSE(
                verdict(o.mean - 1.1 * expected, kZ * std::sqrt(o.variance / o.count), "a fault"));
        }
    }
}

// Frames have shadows of their own, and the mean of many is nearer the truth.
TEST(ShadowPictures, AccumulatedFramesHaveTheirOwnShadows)
{
    const Scene scene = test::sheets_over_floor({0.5f, 0.5f});
    const View view = test::floor_view(stochastic_shadows(4, 1));
    const auto spread = [&](int frames) {
        Options options;
        options.accumulate = frames;
        const Observed o = observe(channel_of(render(scene, view, options).image, 0));
        return std::sqrt(o.variance);
    };
    // 64 times the samples leave an eighth of the deviation; neighbours share texels, which leaves
    // few independent ones to know it from.
    EXPECT_LT(spread(64), spread(1) / 4);
}

TEST(ShadowPictures, SpotLightsCastStochasticShadows)
{
    Scene scene = test::sheets_over_floor({0.5f, 0.25f});
    scene.sun.color = {0, 0, 0};
    scene.lights = {spot_above(3.5f)};
    const View view = test::floor_view(stochastic_shadows(64, 8));
    const Image with = render(scene, view, {}).image, without = without_shadows(scene, view);
    // A texel's 64 stratified samples are off by 0.03; a footprint's 64 texels by an eighth of it.
    for (const auto& [x, y] : {std::pair(16, 16), std::pair(12, 19)}) {
        const double part =
            static_cast<double>(with.at(x, y)[0]) / static_cast<double>(without.at(x, y)[0]);
        EXPECT_NEAR(part, 0.375, kZ * 0.03 / 8);
    }
}

TEST(ShadowPictures, ExactShadowsAreProducts)
{
    Scene scene = test::sheets_over_floor({0.3f, 0.5f, 0.2f, 0.6f});
    View view = test::floor_view(exact_shadows());
    const double expected = 0.7 * 0.5 * 0.8 * 0.4;
    for (const double value : channel_of(render(scene, view, {}).image, 0)) {
        EXPECT_NEAR(value, expected, 1e-6);
    }
    scene.sun.color = {0, 0, 0};
    scene.lights = {spot_above(4.5f)};
    const auto [least, most] = visible_range(scene, view, 1e-3);
    EXPECT_NEAR(least, expected, 1e-6);
    EXPECT_NEAR(most, expected, 1e-6);
}

// Point lights and dark ones cast none.
TEST(ShadowPictures, PointLightsCastNone)
{
    Scene scene = test::sheets_over_floor({0.5f});
    scene.sun.color = {0, 0, 0};
    scene.lights = {spot_above(3.5f)};
    scene.lights[0].kind = LightKind::point;
    for (const Shadows& shadows : {stochastic_shadows(8, 1), exact_shadows()}) {
        const View view = test::floor_view(shadows);
        EXPECT_EQ(render(scene, view, {}).image.pixels, without_shadows(scene, view).pixels);
    }
}

// A flat surface never shadows itself, however the light meets it.
TEST(ShadowPictures, FlatSurfacesHaveNoAcne)
{
    for (const double degrees : {0.0, 20.0, 45.0, 63.0, 75.0, 82.0}) {
        for (const int filter : {1, 3, 8}) {
            const Scene scene = tilted_sun(degrees);
            View view = from({1, 5, 2});
            view.shadows = stochastic_shadows(8, filter);
            const auto [least, most] = visible_range(scene, view, 1e-3);
            // The shading without shadows rounds otherwise.
            EXPECT_GT(least, 1 - 1e-5) << degrees << " degrees, filter " << filter;
            EXPECT_LT(most, 1 + 1e-5);
        }
    }
}

// Nor does a sphere, but where light grazes it: of a quarter's light less than a hundredth is lost.
TEST(ShadowPictures, CurvedSurfacesHaveNoAcne)
{
    const Scene scene = sphere_under_sun();
    View view = from({2, 2, 3});
    view.shadows = stochastic_shadows(16, 2);
    view.shadows.size = 256;
    const auto [least, most] = visible_range(scene, view, 0.25);
    EXPECT_GT(least, 0.99);
    EXPECT_LT(most, 1 + 1e-5);
    view.shadows = exact_shadows();
    EXPECT_GT(visible_range(scene, view, 0.25).first, 0.999);
}

// A sheet casts its shadow on the floor but not on itself.
TEST(ShadowPictures, ATransparentSheetIsNotDarkenedByItself)
{
    const Scene scene = test::sheets_over_floor({0.5f});
    View view = from({1, 5, 2});
    view.shadows = stochastic_shadows(8, 1);
    view.shadows.masks = ShadowMasks::naive;
    Scene alone = scene;
    alone.objects.erase(alone.objects.begin());
    const auto [least, most] = visible_range(alone, view, 1e-3);
    EXPECT_GT(least, 1 - 1e-5);
    EXPECT_LT(most, 1 + 1e-5);
}

// Where a map and rays differ by more than a third, an edge of the true shadow is within two
// texels: a footprint's half and what the slack moves it by.
TEST(ShadowPictures, ShadowsBeginWhereTheyShould)
{
    Scene scene = test::sheets_over_floor({});
    test::add_square(scene, 1, 0.5f, Material{});
    scene.materials.back().double_sided = true;
    scene.sun.to_light = {0.6f, 0.8f, 0};
    View view = from({0.5f, 6, 0.1f});
    view.width = view.height = 160;
    view.shadows = exact_shadows();
    const Image exact = render(scene, view, {}).image;
    view.shadows = stochastic_shadows(16, 1);
    view.shadows.size = 256;
    const Image ours = render(scene, view, {}).image;
    const int reach = 3;  // pixels; one is 0.027 m, a texel 0.03 m
    for (int y = reach; y < 160 - reach; ++y) {
        for (int x = reach; x < 160 - reach; ++x) {
            const float difference = ours.at(x, y)[0] - exact.at(x, y)[0];
            if (std::abs(difference) < 0.33f) continue;
            float least = 1, most = 0;
            for (int j = -reach; j <= reach; ++j) {
                for (int i = -reach; i <= reach; ++i) {
                    least = std::min(least, exact.at(x + i, y + j)[0]);
                    most = std::max(most, exact.at(x + i, y + j)[0]);
                }
            }
            EXPECT_GT(most - least, 0.33f) << x << ", " << y;
        }
    }
}

// The total is the true one: an opaque floor behind everything gets what passes through the sheets,
// to the last bit that is kept, whatever the masks.
TEST(ShadowPictures, CorrectionGivesOpaqueReceiversTheTrueTotal)
{
    const Scene scene = test::sheets_over_floor({0.3f, 0.5f, 0.2f, 0.6f});
    for (const ShadowMasks masks : {ShadowMasks::naive, ShadowMasks::stratified,
                                    ShadowMasks::tracked, ShadowMasks::systematic}) {
        Shadows shadows = stochastic_shadows(16, 2);
        shadows.masks = masks;
        shadows.correction = true;
        for (const double value :
             channel_of(render(scene, test::floor_view(shadows), {}).image, 0)) {
            // Half a step of Layer::through, and floats.
            EXPECT_NEAR(value, 0.7 * 0.5 * 0.8 * 0.4, 0x1p-14 + 1e-6);
        }
    }
}

TEST(ShadowPictures, RandomFootprintsAreRightOnAverage)
{
    const Scene scene = test::sheets_over_floor({0.3f, 0.5f});
    Shadows shadows = stochastic_shadows(8, 2);
    shadows.footprint = Footprint::random;
    std::vector<double> means;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        Options options;
        options.seed = seed;
        means.push_back(mean_of(render(scene, test::floor_view(shadows), options).image));
    }
    const Observed o = observe(means);
    const double bound = kZ * std::sqrt(o.variance / o.count);
    EXPECT_TRUE(verdict(o.mean - 0.35, bound, "the mean"));
    EXPECT_FALSE(verdict(o.mean - 1.1 * 0.35, bound, "a fault"));
}

// Red glass lets red through; without colours its shadow is grey, by the mean.
TEST(ShadowPictures, ColouredGlassCastsItsColour)
{
    Scene scene = test::sheets_over_floor({1.0f});
    Material& glass = scene.materials.back();
    glass.shading = Shading::metallic_roughness;
    glass.transmission = 1;
    glass.base_color = {0.9f, 0.3f, 0};
    const Float3 through = {0.96f * 0.9f, 0.96f * 0.3f, 0};
    Shadows shadows = stochastic_shadows(64, 4);
    // With correction the floor gets the true total.
    shadows.correction = true;
    for (const ShadowMasks masks : {ShadowMasks::stratified, ShadowMasks::tracked}) {
        shadows.masks = masks;
        for (const bool colored : {false, true}) {
            shadows.colored = colored;
            const Image image = render(scene, test::floor_view(shadows), {}).image;
            const float mean = (through[0] + through[1] + through[2]) / 3;
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(image.at(16, 16)[c], colored ? through[c] : mean, 0x1p-14 + 1e-5);
            }
        }
    }
    // Without it 64 samples of each of the footprint's 16 texels or more, off by a sample each.
    shadows.correction = false;
    const Image uncorrected = render(scene, test::floor_view(shadows), {}).image;
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(uncorrected.at(16, 16)[c], through[c], 1.0 / 64 + 1e-5);
    }
    const Image exact = render(scene, test::floor_view(exact_shadows()), {}).image;
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(exact.at(16, 16)[c], through[c], 1e-6);
}

// Unlit surfaces have their light already, and let the sun's through: skies are made of them.
TEST(ShadowPictures, UnlitSurfacesCastNone)
{
    Scene scene = test::sheets_over_floor({0.5f});
    scene.materials.back().shading = Shading::unlit;
    for (const Shadows& shadows : {stochastic_shadows(8, 1), exact_shadows()}) {
        for (const double value :
             channel_of(render(scene, test::floor_view(shadows), {}).image, 0)) {
            EXPECT_NEAR(value, 1, 1e-5);
        }
    }
}

}  // namespace sheer
