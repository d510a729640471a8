// Whole pictures behind glass that diffuses and refracts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "cpu/small_pictures.h"
#include "reference/phenomenological.h"
#include "simd_levels.h"

namespace sheer {

namespace {

constexpr float kWall = 4, kGlass = 2, kOpacity = 0.5f;

// Black glass before a wall that is black on the left and white on the right.
Scene glass_before_a_step()
{
    Scene scene;
    Camera camera;
    camera.orthographic = true;
    camera.znear = 0.1f;
    scene.cameras = {camera};
    add_upright(scene, -1, 0, kWall, {0, 0, 0}, 1);
    add_upright(scene, 0, 1, kWall, {1, 1, 1}, 1);
    add_upright(scene, -1, 1, kGlass, {0, 0, 0}, kOpacity);
    return scene;
}

}  // namespace

// The step becomes a normal distribution's function with the variance of the paper's formula, of
// 200 pixels for D = 1 where the picture is 1080 high. What the pyramid's kernel is off by is no
// more than 0.068 of the step (methods/backdrop_picture_test.cpp, where it is derived); a variance
// twice as large would be off by 0.083.
TEST(BackdropPictures, AStepBehindADiffuserIsBlurred)
{
    constexpr int kSide = 128;
    const double d2 = reference::phenomenological_diffusion(
        static_cast<double>(kOpacity), 0.9, static_cast<double>(kGlass),
        static_cast<double>(kWall) - static_cast<double>(kGlass));
    const double deviation = std::sqrt(d2) * kSide * 200 / 1080;
    ASSERT_GT(deviation, std::sqrt(7.75));  // of the levels of that test
    ASSERT_LT(deviation, std::sqrt(31.75));
    for (const int samples : {1, 4}) {
        const Image image =
            draw(glass_before_a_step(), square(kSide, samples), "phenomenological:diffusion=0.1");
        for (int x = 0; x < kSide; ++x) {
            const double wanted =
                0.25 * std::erfc(-(x + 0.5 - kSide / 2.0) / deviation / std::sqrt(2.0));
            for (const int y : {0, 31, 64, 127}) {
                EXPECT_NEAR(static_cast<double>(image.at(x, y)[1]), wanted, 0.5 * 0.068) << x;
            }
        }
    }
}

// Glass without anything to blur, or met at right angles by all rays, or that neither blurs nor
// turns: the picture without all of this. Reading mixes with weights that are off by some
// roundings.
TEST(BackdropPictures, WhatHasNoEffectChangesNothing)
{
    Scene alone;
    alone.cameras = glass_before_a_step().cameras;
    alone.background = Float4{0.3f, 0.6f, 0.2f, 1};
    add_upright(alone, -0.7f, 0.45f, kGlass, {0.8f, 0.1f, 0.1f}, kOpacity);
    const Scene step = glass_before_a_step();
    const auto expect_same = [](const Scene& scene, const char* method, float bound) {
        const View view = square(70, 4);
        const Image plain = draw(scene, view, "phenomenological");
        const Image other = draw(scene, view, std::string("phenomenological:") + method);
        for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
            for (std::size_t c = 0; c < 4; ++c) {
                EXPECT_NEAR(other.pixels[i][c], plain.pixels[i][c], bound) << method;
            }
        }
    };
    expect_same(alone, "diffusion=1.0", 1e-5f);
    expect_same(alone, "refraction=3.0", 1e-5f);
    expect_same(step, "refraction=1.5", 1e-4f);  // places in the picture are floats: 70 x 2^-24
    expect_same(step, "diffusion=0.0:refraction=1.0", 0);
}

// The picture is read over the edges of tiles, which different threads draw.
TEST(BackdropPictures, HaveTheSameBitsWhateverDrawsThem)
{
    const Scene scene = load("builtin:burning-house?particles=60");
    for (const int samples : {1, 8}) {
        View view = square(70, samples);
        view.height = 50;
        if (samples == 8) view.filter = Filter::gaussian;
        Options options;
        options.method = "phenomenological:diffusion=0.1:refraction=1.2";
        options.threads = 1;
        options.simd = Simd::scalar;
        const Image expected = render(scene, view, options).image;
        EXPECT_EQ(first_not_finite(expected, expected), std::nullopt);
        EXPECT_NE(expected.pixels, draw(scene, view, "phenomenological").pixels);
        for (const Simd level : simd_levels()) {
            options.simd = level;
            options.threads = 3;
            EXPECT_EQ(render(scene, view, options).image.pixels, expected.pixels);
        }
    }
}

TEST(BackdropPictures, HaveAStageAndAreCounted)
{
    Options options;
    options.method = "phenomenological:diffusion=0.1";
    const Scene scene = glass_before_a_step();
    const auto stages = [&] {
        const Stats stats = render(scene, square(64, 1), options).stats;
        return std::count_if(stats.ms_passes.begin(), stats.ms_passes.end(),
                             [](const PassTime& pass) { return pass.name == "backdrop"; });
    };
    EXPECT_EQ(stages(), 1);
    options.method = "phenomenological";
    EXPECT_EQ(stages(), 0);
    options.method = "phenomenological:refraction=1.1";
    options.memory_limit = 1;
    EXPECT_THROW(render(scene, square(64, 1), options), Error);
}

// Frames with shadows of their own are drawn one by one, each with its own picture of the backdrop.
TEST(BackdropPictures, AreMadeForEachFrameOfAPicture)
{
    Options options;
    options.method = "phenomenological:diffusion=0.1";
    options.accumulate = 3;
    View view = square(40, 1);
    const Image plain = render(glass_before_a_step(), view, options).image;
    view.shadows.kind = ShadowKind::stochastic;
    const Image shadowed = render(glass_before_a_step(), view, options).image;
    for (std::size_t i = 0; i < plain.pixels.size(); ++i) {  // the step is unlit
        EXPECT_NEAR(shadowed.pixels[i][0], plain.pixels[i][0], 1e-6f);
    }
}

}  // namespace sheer
