// Foveated shading: full rate within the circle, squares of pixels beyond.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <sheer/sheer.h>

#include "cpu/shading_rates.h"
#include "methods/statistics.h"
#include "shade/textured_wall.h"
#include "same_bits.h"

namespace sheer {
namespace {

Float4 at(const Image& image, int x, int y)
{
    return image.pixels[static_cast<std::size_t>(y * image.width + x)];
}

double distance(const Foveation& foveation, int x, int y)
{
    return std::hypot(x + 0.5 - static_cast<double>(foveation.x),
                      y + 0.5 - static_cast<double>(foveation.y));
}

TEST(Foveation, RatesFallWithTheDistance)
{
    const Foveation foveation{21.3f, 40.9f, 9};
    // As of a tile with an apron, whose first pixel is no square's.
    const PixelRect rect{9, 27, 41, 59};
    ShadingRates rates;
    rates.set(foveation, rect);
    EXPECT_TRUE(rates.coarse);
    for (int y = rect.y0; y < rect.y1; ++y) {
        for (int x = rect.x0; x < rect.x1; ++x) {
            const int i = (y - rect.y0) * kTileSize + x - rect.x0;
            const auto side = static_cast<int>(rates.side[i]);
            const double from = distance(foveation, x, y);
            if (from <= 9) {
                EXPECT_EQ(side, 1);
            }
            if (from <= 18) {
                EXPECT_LE(side, 2);
            }
            if (from > 9 + 2 * std::sqrt(2.0)) {
                EXPECT_GE(side, 2);
            }
            if (from > 18 + 4 * std::sqrt(2.0)) {
                EXPECT_EQ(side, 4);
            }
            // Squares lie on the picture, and a pixel is no farther from its middle than a corner.
            const double left = static_cast<double>(rates.x[i]) - 0.5 * (side - 1) + rect.x0;
            const double top = static_cast<double>(rates.y[i]) - 0.5 * (side - 1) + rect.y0;
            EXPECT_EQ(left, x / side * side);
            EXPECT_EQ(top, y / side * side);
        }
    }
    rates.set({25, 43, 40}, rect);
    EXPECT_FALSE(rates.coarse);
}

// The built-in fence before lit ground.
struct Fence {
    Scene scene = load("builtin:fence");
    View view;
    Options options;

    Fence()
    {
        view.width = 100;
        view.height = 76;
        view.samples = 1;
        options.method = "hashed-alpha-test";
    }
    Image draw() const { return render(scene, view, options).image; }
};

TEST(Foveation, ACircleAroundThePictureChangesNoBit)
{
    Fence fence;
    for (const Filter filter : {Filter::box, Filter::gaussian}) {
        fence.view.filter = filter;
        fence.view.foveation = std::nullopt;
        const Image expected = fence.draw();
        fence.view.foveation = Foveation{50, 38, 70};
        EXPECT_EQ(fence.draw().pixels, expected.pixels);
    }
}

TEST(Foveation, NothingChangesInTheCircle)
{
    Fence fence;
    const Image expected = fence.draw();
    const Foveation foveation{30, 40, 16};
    fence.view.foveation = foveation;
    const Image drawn = fence.draw();
    int changed = 0;
    for (int y = 0; y < 76; ++y) {
        for (int x = 0; x < 100; ++x) {
            if (distance(foveation, x, y) <= 16) {
                EXPECT_EQ(at(drawn, x, y), at(expected, x, y)) << x << ", " << y;
            } else {
                changed += at(drawn, x, y) != at(expected, x, y);
            }
        }
    }
    EXPECT_GT(changed, 500);
}

TEST(Foveation, SameBitsOnEveryLevelAndAnyNumberOfThreads)
{
    for (const char* source : {"builtin:fence", "builtin:motor", "builtin:cloth"}) {
        const Scene scene = load(source);
        View view;
        view.width = 100;
        view.height = 76;
        view.samples = 4;
        view.filter = Filter::gaussian;
        view.foveation = Foveation{30, 20, 12};
        for (const char* method : {"exact", "hashed-alpha-test:fade-in=6"}) {
            expect_same_bits(scene, view, method, source);
        }
    }
}

// Shaded in squares of 4 x 4 pixels, what fills the picture is the picture of a quarter of its
// width and height, whose pixels are shaded at the same points and have textures as coarse.
TEST(Foveation, SquaresAreThePixelsOfASmallerPicture)
{
    test::Wall wall(test::checkers(64), 0.1f, -0.2f, 3.7f, 3.1f);
    wall.view.samples = 1;
    wall.view.width = wall.view.height = 96;
    wall.view.foveation = Foveation{-1000, -1000, 1};
    const Image drawn = wall.draw();
    wall.view.foveation = std::nullopt;
    wall.view.width = wall.view.height = 24;
    const Image small = wall.draw();
    for (int y = 0; y < 96; ++y) {
        for (int x = 0; x < 96; ++x) {
            EXPECT_NEAR(at(drawn, x, y)[0], at(small, x / 4, y / 4)[0], 1e-4f);
        }
    }
}

TEST(Foveation, ThresholdsAreThoseOfASmallerPicture)
{
    // Of opacity 1/2 everywhere.
    test::Wall wall(test::image_of(1, 1, {{255, 255, 255, 255}}), 0, 0, 1, 1);
    wall.material().alpha_mode = AlphaMode::blend;
    wall.material().opacity = 0.5f;
    wall.view.samples = 1;
    Options options;
    const auto passed = [&](const char* method, int size, bool foveated) {
        options.method = method;
        wall.view.width = wall.view.height = size;
        wall.view.foveation.reset();
        if (foveated) wall.view.foveation = Foveation{-1000, -1000, 1};
        return render(wall.scene, wall.view, options).image;
    };
    for (const char* method : {"hashed-alpha-test", "hashed-alpha-test:variant=isotropic"}) {
        const Image drawn = passed(method, 256, true), small = passed(method, 64, false);
        int off = 0;
        for (int y = 0; y < 256; ++y) {
            for (int x = 0; x < 256; ++x) {
                off += at(drawn, x, y)[3] != at(small, x / 4, y / 4)[3];
            }
        }
        // Places that are a rounding off may lie beyond a cell's side: of 64 x 64 squares some ten.
        EXPECT_LT(off, 16 * 64) << method;
        EXPECT_NE(passed(method, 256, false).pixels, drawn.pixels);
    }
}

// Of a plain surface, and of one in triangles smaller than squares.
TEST(Foveation, CoverageStaysAtFullRate)
{
    for (const char* source : {"builtin:motor?alpha=1", "builtin:cloth?alpha=1"}) {
        const Scene scene = load(source);
        View view;
        view.width = view.height = 96;
        view.samples = 4;
        view.background = Float4{0, 0, 0, 0};
        const Image expected = render(scene, view, {}).image;
        view.foveation = Foveation{48, 48, 8};
        const Image drawn = render(scene, view, {}).image;
        EXPECT_EQ(channel_of(drawn, 3), channel_of(expected, 3)) << source;
        EXPECT_NE(drawn.pixels, expected.pixels) << source;
    }
}

}  // namespace
}  // namespace sheer
