// What triangles have of pixels: closed forms, and sums over all of a triangle's pixels.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "raster/pixel_overlap.h"

namespace sheer {
namespace {

// In subpixels, turning as the renderer's do.
Triangle triangle_of(int x0, int y0, int x1, int y1, int x2, int y2)
{
    Triangle t = {};
    const int x[] = {x0, x1, x2}, y[] = {y0, y1, y2};
    for (std::size_t i = 0; i < 3; ++i) {
        t.x[i] = x[i];
        t.y[i] = y[i];
    }
    return t;
}

double twice_area(const Triangle& t)
{
    return static_cast<double>(t.x[1] - t.x[0]) * (t.y[2] - t.y[0]) -
           static_cast<double>(t.y[1] - t.y[0]) * (t.x[2] - t.x[0]);
}

TEST(PixelOverlap, OfHalfAPixelAllOfItAndNone)
{
    const PixelOverlap half = overlap_of(triangle_of(0, 0, 256, 0, 0, 256), 0, 0);
    EXPECT_EQ(half.part, 0.5);
    EXPECT_NEAR(half.x, 256.0 / 3 - 128, 1e-12);
    EXPECT_NEAR(half.y, 256.0 / 3 - 128, 1e-12);
    const Triangle large = triangle_of(-1000, -1000, 3000, -1000, -1000, 3000);
    const PixelOverlap whole = overlap_of(large, 2, 1);
    EXPECT_EQ(whole.part, 1);
    EXPECT_EQ(whole.x, 0);
    EXPECT_EQ(whole.y, 0);
    // Next to it, across a corner, and along an edge.
    EXPECT_EQ(overlap_of(triangle_of(0, 0, 256, 0, 0, 256), 1, 0).part, 0);
    EXPECT_EQ(overlap_of(triangle_of(0, 0, 256, 0, 0, 256), 1, 1).part, 0);
    EXPECT_EQ(overlap_of(triangle_of(0, 0, 256, 0, 0, 256), 0, -1).part, 0);
}

// A square whose corners are in the middle of the pixel's sides, as two triangles.
TEST(PixelOverlap, PartsAddUpToThePolygon)
{
    const PixelOverlap right = overlap_of(triangle_of(128, 0, 256, 128, 128, 256), 0, 0);
    const PixelOverlap left = overlap_of(triangle_of(128, 0, 128, 256, 0, 128), 0, 0);
    EXPECT_EQ(right.part, 0.25);
    EXPECT_EQ(left.part, 0.25);
    EXPECT_NEAR(right.x, 128.0 / 3, 1e-12);
    EXPECT_NEAR(left.x, -128.0 / 3, 1e-12);
    EXPECT_NEAR(right.y, 0, 1e-12);
}

// Parts below kLeastOverlap are left out, of a pixel each; each of some ten operations on numbers
// up to 2^13 rounds by 2^-53 of those, and areas are their products.
TEST(PixelOverlap, PixelsAddUpToTheTriangle)
{
    std::mt19937 random(3);
    for (int round = 0; round < 500; ++round) {
        const int reach = round % 2 == 0 ? 300 : 2600;
        const auto draw = [&] { return static_cast<int>(random() % static_cast<unsigned>(reach)); };
        Triangle t = triangle_of(draw(), draw(), draw(), draw(), draw(), draw());
        if (twice_area(t) == 0) continue;
        if (twice_area(t) < 0) {
            std::swap(t.x[1], t.x[2]);
            std::swap(t.y[1], t.y[2]);
        }
        double sum = 0, x = 0, y = 0;
        constexpr int kAcross = 11;
        for (int j = 0; j < kAcross; ++j) {
            for (int i = 0; i < kAcross; ++i) {
                const PixelOverlap o = overlap_of(t, i, j);
                EXPECT_LE(std::abs(o.x), 128);
                EXPECT_LE(std::abs(o.y), 128);
                sum += o.part;
                x += o.part * (o.x + 128 + 256 * i);
                y += o.part * (o.y + 128 + 256 * j);
            }
        }
        const double left_out = kAcross * kAcross * (kLeastOverlap + 1e-9);
        const double area = twice_area(t) / (2 * 256 * 256);
        EXPECT_NEAR(sum, area, left_out);
        EXPECT_NEAR(x, area * (t.x[0] + t.x[1] + t.x[2]) / 3, 256 * kAcross * left_out);
        EXPECT_NEAR(y, area * (t.y[0] + t.y[1] + t.y[2]) / 3, 256 * kAcross * left_out);
    }
}

}  // namespace
}  // namespace sheer
