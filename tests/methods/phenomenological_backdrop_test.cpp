// Diffusion and refraction in phenomenological stores: what black glass shows of a picture behind.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "lanes/lone.h"
#include "methods/backdrop_picture.h"
#include "methods/rounding.h"
#include "methods/tile_fixture.h"
#include "reference/phenomenological.h"

namespace sheer {

namespace {

struct Text {
    using L = Lone<float>;
#include "lanes/text_words.h"
#include "sheer/phenomenological.glsl"
};

constexpr int kSide = 256;  // of the picture, of which the tile shows pixels 96 to 127
constexpr TilePlace kPlace = {96, 96};
constexpr float kScale = 200;  // pixels for a tangent of 1
constexpr EyeSpace kEye = {false, 0.1f, 500.0f};

// f of a pixel's centre; all of it as far away.
template <class F>
BackdropPicture picture_of(float distance, F&& f)
{
    BackdropPicture picture(kSide, kSide, {kScale, kScale});
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const auto value = static_cast<float>(f(x + 0.5, y + 0.5));
            picture.color(x, y) = {value, value, value, 1};
            picture.nearness(x, y) = 1 / distance;
        }
    }
    picture.make_levels();
    return picture;
}

double slope_right(double x, double)
{
    return x / kSide;
}
double slope_down(double, double y)
{
    return y / kSide;
}

// A plane through (0, 0, z) with a normal (toward_x, toward_y, -1): depth as fragments have it.
Plate pane(double z, double toward_x, double toward_y, float opacity)
{
    // toward . (p - (0, 0, z)) = 0 along p = d (px, py, 1): 1 / d = (1 - tx px - ty py) / z.
    const auto depth = [&](double x, double y) {
        const double px = (x - kSide / 2.0) / static_cast<double>(kScale);
        const double py = (y - kSide / 2.0) / static_cast<double>(kScale);
        return -(1 - toward_x * px - toward_y * py) / z;
    };
    const double at = depth(kPlace.x + 0.5, kPlace.y + 0.5);
    Plate plate;
    plate.depth = make_plane(at, depth(kPlace.x + 1.5, kPlace.y + 0.5) - at,
                             depth(kPlace.x + 0.5, kPlace.y + 1.5) - at);
    plate.color = {0, 0, 0, opacity};
    plate.samples.fill(1);
    return plate;
}

struct Shown {
    const SampleSet set = make_sample_set(1, SamplePositions::standard);
    Colors colors;

    // Red of a used pixel.
    double red(std::size_t used) const
    {
        return static_cast<double>(colors[color_index(set, tile_pixel(used), 0, 0)]);
    }
    static double x(std::size_t used) { return kPlace.x + tile_pixel(used) % kTileSize + 0.5; }
    static double y(std::size_t used) { return kPlace.y + tile_pixel(used) / kTileSize + 0.5; }
};

Shown show(const std::string& parameters, const Plates& plates, const BackdropPicture& picture,
           bool back_facing = false, bool merged = false)
{
    Shown shown;
    const ChosenMethod method = choose_method("phenomenological:" + parameters);
    const StoreVerbs verbs = method.row->verbs(targets_of(Simd::best), method, 1);
    const auto make = [&](std::span<const Plate> some) {
        FragmentStream stream(4096);
        fill_stream(some, stream);
        for (int r = 0; r < stream.run_count; ++r) stream.runs[r].back_facing = back_facing;
        StoreShape shape{&shown.set, &method, kEye, 4096};
        shape.backdrop = &picture;
        auto store = verbs.make(shape);
        verbs.clear(store.get(), kPlace);
        verbs.insert(store.get(), stream, 0);
        return store;
    };
    const std::span<const Plate> all(plates);
    const auto store = make(merged ? all.first(1) : all);
    if (merged) verbs.merge(store.get(), make(all.subspan(1)).get());
    SampleColors colors(1);
    for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
        const auto at = static_cast<int>(pixel);
        const Float4 own = picture.between(static_cast<float>(kPlace.x + at % kTileSize) + 0.5f,
                                           static_cast<float>(kPlace.y + at / kTileSize) + 0.5f);
        for (std::size_t c = 0; c < 4; ++c) *colors.channel(pixel, c) = own[c];
    }
    verbs.resolve(store.get(), colors);
    shown.colors.assign(colors.values.data(), colors.values.data() + colors.values.size());
    return shown;
}

// Places in the picture are floats of some 2^7 pixels, depths and the rest are off by some 100
// units of what they are; a shift is up to 2^5 pixels.
constexpr double kPixels = (256 + 100 * 32) * kUnit;

}  // namespace

TEST(PhenomenologicalBackdrop, TheTextTurnsRaysBySnellsLaw)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 2000; ++i) {
        const double ray[3] = {uniform(random), uniform(random), 1};
        double normal[3] = {uniform(random), uniform(random), -1};
        const double length = std::hypot(normal[0], normal[1], normal[2]);
        for (double& c : normal) c /= length;
        const double facing = -(ray[0] * normal[0] + ray[1] * normal[1] + normal[2]);
        if (facing < 0.1) continue;
        const double eta = 1 + std::abs(uniform(random)) * 2;
        const auto f = [](double x) { return static_cast<float>(x); };
        const auto got = Text::phenomenological_refraction(
            {f(ray[0]), f(ray[1]), 1}, {f(normal[0]), f(normal[1]), f(normal[2])}, f(eta));
        const auto wanted = reference::phenomenological_refraction(ray, normal, eta);
        // Roundings of numbers up to 3 x 9, of which c, at least 0.1, is a small difference.
        const double bound = 30 * 27 * kUnit / 0.1;
        EXPECT_NEAR(static_cast<double>(got.x), wanted.x, bound);
        EXPECT_NEAR(static_cast<double>(got.y), wanted.y, bound);
        const auto straight = Text::phenomenological_refraction(
            {f(ray[0]), f(ray[1]), 1}, {f(normal[0]), f(normal[1]), f(normal[2])}, 1.0f);
        EXPECT_EQ(straight.x, 0.0f);
        EXPECT_EQ(straight.y, 0.0f);
    }
}

// A surface that all rays of the picture's middle column meet at right angles in x, at any index;
// and glass seen from behind, which rays leave.
TEST(PhenomenologicalBackdrop, WhatMeetsASurfaceStraightOnIsNotDisplaced)
{
    const BackdropPicture picture = picture_of(9, slope_right);
    // At each pixel by itself the surface whose normal is the ray.
    for (std::size_t used = 0; used < kUsedPixels; ++used) {
        const double px = (Shown::x(used) - kSide / 2.0) / static_cast<double>(kScale);
        const double py = (Shown::y(used) - kSide / 2.0) / static_cast<double>(kScale);
        const Plates straight = {pane(3, -px, -py, 0.5f)}, tilted = {pane(3, 1 - px, -py, 0.5f)};
        const double own = 0.5 * slope_right(Shown::x(used), 0);
        const double bound = kPixels / kSide + 10 * kUnit;
        EXPECT_NEAR(show("refraction=1.5", straight, picture).red(used), own, bound);
        EXPECT_GT(std::abs(show("refraction=1.5", tilted, picture).red(used) - own), 10 * bound);
        EXPECT_NEAR(show("refraction=1.5", tilted, picture, true).red(used), own, bound);
        EXPECT_NEAR(show("refraction=1.0", tilted, picture).red(used), own, bound);
    }
}

// What lies where the turned ray meets the distance of the wall is seen; of two panes the sum.
TEST(PhenomenologicalBackdrop, DisplacementIsThatOfTheTurnedRay)
{
    constexpr double kWall = 6;
    const BackdropPicture right = picture_of(static_cast<float>(kWall), slope_right);
    const BackdropPicture down = picture_of(static_cast<float>(kWall), slope_down);
    const double tilts[2][2] = {{0.3, -0.2}, {-0.1, 0.25}};
    const double eta = 1.25, distances[2] = {4, 3};
    Plates plates;
    for (int i = 0; i < 2; ++i)
        plates.push_back(pane(distances[i], tilts[i][0], tilts[i][1], 0.5f));
    for (const bool merged : {false, true}) {
        const Shown x = show("refraction=1.25", plates, right, false, merged);
        const Shown y = show("refraction=1.25", plates, down, false, merged);
        for (std::size_t used = 0; used < kUsedPixels; ++used) {
            const double ray[3] = {(Shown::x(used) - kSide / 2.0) / static_cast<double>(kScale),
                                   (Shown::y(used) - kSide / 2.0) / static_cast<double>(kScale), 1};
            double at[2] = {Shown::x(used), Shown::y(used)};
            for (int i = 0; i < 2; ++i) {
                const double x_slope = tilts[i][0], y_slope = tilts[i][1];
                const double length = std::hypot(x_slope, y_slope, 1.0);
                const double normal[3] = {x_slope / length, y_slope / length, -1 / length};
                const double z = distances[i] / (1 - x_slope * ray[0] - y_slope * ray[1]);
                const auto turned = reference::phenomenological_refraction(ray, normal, eta);
                at[0] += static_cast<double>(kScale) * turned.x * (1 - z / kWall);
                at[1] += static_cast<double>(kScale) * turned.y * (1 - z / kWall);
            }
            const double bound = kPixels / kSide + 10 * kUnit;
            EXPECT_NEAR(x.red(used), 0.25 * slope_right(at[0], 0), bound);
            EXPECT_NEAR(y.red(used), 0.25 * slope_down(0, at[1]), bound);
        }
    }
    // An eighth of the picture at most.
    const Shown far = show("refraction=3.0", {pane(0.2, 1.2, 0, 0.5f)}, right);
    for (std::size_t used = 0; used < kUsedPixels; ++used) {
        const double shift = std::abs(2 * far.red(used) * kSide - Shown::x(used));
        EXPECT_NEAR(shift, kSide / 8.0, kPixels);
    }
}

// Squares grow by the sum of the variances that the paper's formula gives.
TEST(PhenomenologicalBackdrop, VariancesOfDiffusionAddUp)
{
    constexpr double kWall = 4.5, kSpan = 64;
    const auto square = [](double x, double) { return (x - 112) * (x - 112) / (kSpan * kSpan); };
    const BackdropPicture picture = picture_of(static_cast<float>(kWall), square);
    const Plates plates = {pane(4, 0, 0, 0.5f), pane(3, 0, 0, 0.25f)};
    const double scale = kSide * 200.0 / 1080;
    const double variance = scale * scale *
                            (reference::phenomenological_diffusion(0.5, 0.8, 4, 0.5) +
                             reference::phenomenological_diffusion(0.25, 0.8, 3, 1.5));
    ASSERT_GT(variance, 30);   // and squares differ by far more than rounding
    ASSERT_LT(variance, 127);  // no more than level 4, which reaches 48 pixels
    for (const bool merged : {false, true}) {
        const Shown shown = show("diffusion=0.2", plates, picture, false, merged);
        for (std::size_t used = 0; used < kUsedPixels; ++used) {
            const double wanted = 0.375 * (square(Shown::x(used), 0) + variance / (kSpan * kSpan));
            EXPECT_NEAR(shown.red(used), wanted, 400 * kUnit * 4);
        }
    }
    const Shown off = show("diffusion=0.0", plates, picture);
    for (std::size_t used = 0; used < kUsedPixels; ++used) {
        EXPECT_NEAR(off.red(used), 0.375 * square(Shown::x(used), 0), 10 * kUnit);
    }
}

}  // namespace sheer
