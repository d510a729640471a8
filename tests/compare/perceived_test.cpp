// SSIM and FLIP against loops written from the papers, against what FLIP's authors' program says,
// and where the answer is a formula.
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include <sheer/error.h>

#include "compare/flip.h"
#include "compare/slow_metrics.h"
#include "compare/ssim.h"

namespace sheer {
namespace {

using Encoded = std::function<double(int x, int y, int c)>;

// From sRGB encoded values, by the standard's formula.
Image picture(int width, int height, const Encoded& value)
{
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const double v = value(x, y, c);
                image.at(x, y)[static_cast<std::size_t>(c)] = static_cast<float>(
                    v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
            }
            image.at(x, y)[3] = 1;
        }
    }
    return image;
}

double noise_a(int x, int y, int c)
{
    return (x * 7 + y * 13 + c * 29) % 32 / 31.0;
}
double noise_b(int x, int y, int c)
{
    return (x * 5 + y * 11 + c * 17) % 32 / 31.0;
}
double squares(int x, int y, int c)
{
    return (x / 8 + y / 8 + c) % 3 / 2.0;
}
double moved_squares(int x, int y, int c)
{
    return squares(x + 3, y, c);
}
Encoded all(double r, double g, double b)
{
    return [=](int, int, int c) { return c == 0 ? r : c == 1 ? g : b; };
}

// What FLIP.h of version 1.6 by the paper's authors gives for the same pictures. It computes in
// single precision: a filter is a sum of 441 products, each off by 2^-24 of the largest, so that
// colours, features and their roots agree to about four digits.
TEST(Flip, IsWhatTheAuthorsProgramSays)
{
    const auto dot = [](int x, int y, int) { return x == 16 && y == 12 ? 1.0 : 0.5; };
    struct Row {
        const char* what;
        Encoded test, reference;
        int width, height;
        double mean;
        int x, y;
        double there;
    };
    const std::array<Row, 8> rows = {{
        {"noise", noise_a, noise_b, 48, 36, 0.3199294, 7, 2, 0.3641018},
        {"moved", moved_squares, squares, 48, 36, 0.6784722, 7, 2, 0.9787723},
        {"green, blue", all(0, 1, 0), all(0, 0, 1), 32, 24, 1, 7, 2, 1},
        {"black, white", all(0, 0, 0), all(1, 1, 1), 32, 24, 0.9673883, 7, 2, 0.9673883},
        {"dot", dot, all(0.5, 0.5, 0.5), 32, 24, 0.0056277, 7, 2, 0},
        {"grey, black", all(0.5, 0.5, 0.5), all(0, 0, 0), 32, 24, 0.9315039, 7, 2, 0.9315039},
        {"small", noise_a, noise_b, 5, 3, 0.5650967, 2, 1, 0.5535136},
        {"noise, squares", noise_a, squares, 48, 36, 0.8788593, 7, 2, 0.8100128},
    }};
    for (const Row& row : rows) {
        const FlipErrors found = flip_errors(picture(row.width, row.height, row.test),
                                             picture(row.width, row.height, row.reference), 2);
        EXPECT_NEAR(found.mean, row.mean, 1e-4) << row.what;
        EXPECT_NEAR(found.errors[static_cast<std::size_t>(row.y * row.width + row.x)], row.there,
                    1e-4)
            << row.what;
    }
}

// Doubles: rounding is 2^-53 of sums of 441 terms of up to 500, times 0.95 / 41 for the distance,
// and square roots of differences of features, where that of 1e-14 is 1e-7.
TEST(Flip, IsWhatPlainLoopsSay)
{
    const Image a = picture(24, 21, noise_a), b = picture(24, 21, squares);
    const FlipErrors found = flip_errors(a, b, 1);
    const test::SlowFlip slow;
    double sum = 0;
    for (int y = 0; y < a.height; y += 1) {
        for (int x = 0; x < a.width; x += 1) {
            const double error = slow.error(a, b, x, y);
            sum += error;
            EXPECT_NEAR(found.errors[static_cast<std::size_t>(y * a.width + x)], error, 3e-7)
                << x << "," << y;
        }
    }
    EXPECT_NEAR(found.mean, sum / (24 * 21), 2e-7);
}

TEST(Flip, IsSymmetricAndZeroForTheSame)
{
    const Image a = picture(40, 70, noise_a), b = picture(40, 70, squares);
    EXPECT_EQ(flip_errors(a, b, 1).errors, flip_errors(b, a, 1).errors);
    EXPECT_EQ(flip_errors(a, a, 1).mean, 0);
    const FlipErrors one = flip_errors(a, b, 1), three = flip_errors(a, b, 3);
    EXPECT_EQ(one.mean, three.mean);
    EXPECT_EQ(one.errors, three.errors);
}

// An encoding ends at 0 and 1.
TEST(Flip, ClampsColours)
{
    Image bright(12, 12), white(12, 12);
    for (auto& pixel : bright.pixels) pixel = {7, 1.5f, 1, 1};
    for (auto& pixel : white.pixels) pixel = {1, 1, 1, 1};
    EXPECT_EQ(flip_errors(bright, white, 1).mean, 0);
    EXPECT_EQ(ssim(bright, white, 1), 1);
}

TEST(Perceived, RefusesWhatCannotBeCompared)
{
    EXPECT_THROW(flip_errors(Image(4, 3), Image(3, 4), 1), Error);
    EXPECT_THROW(flip_errors(Image(), Image(), 1), Error);
    EXPECT_THROW(ssim(Image(40, 30), Image(30, 40), 1), Error);
}

// Variances are sums of products of up to 1 less others: off by some 2^-50, over C2 = 0.0009.
TEST(Ssim, IsWhatPlainLoopsSay)
{
    for (const Encoded& other : {Encoded(noise_b), Encoded(squares), Encoded(moved_squares)}) {
        const Image a = picture(33, 48, squares), b = picture(33, 48, other);
        EXPECT_NEAR(*ssim(a, b, 2), test::slow_ssim(a, b), 1e-11);
        EXPECT_EQ(*ssim(a, b, 1), *ssim(a, b, 3));
        EXPECT_EQ(*ssim(a, b, 1), *ssim(b, a, 1));
    }
}

// Without contrast only brightness is left: (2 p q + C1) / (p^2 + q^2 + C1).
TEST(Ssim, OfOneColourEach)
{
    const Image a = picture(11, 11, all(0.2, 0.4, 0.9)), b = picture(11, 11, all(0.6, 0.4, 0));
    double sum = 0;
    for (const auto& [p, q] : {std::pair{0.2, 0.6}, {0.4, 0.4}, {0.9, 0.0}}) {
        sum += (2 * p * q + 1e-4) / (p * p + q * q + 1e-4);
    }
    // The pictures are floats: 2^-24 of each value, and of the quotient about as much.
    EXPECT_NEAR(*ssim(a, b, 1), sum / 3, 1e-6);
}

// Upside down about grey: covariance is less the variance, means are nearly alike.
TEST(Ssim, IsNegativeForANegative)
{
    const auto checker = [](int x, int y, int) { return (x + y) % 2 == 0 ? 1.0 : 0.0; };
    const auto other = [](int x, int y, int) { return (x + y) % 2 == 0 ? 0.0 : 1.0; };
    const Image a = picture(16, 16, checker), b = picture(16, 16, other);
    // Means 1/2 and variances 1/4 within 1e-3 under these windows; (-0.5 + C2) / (0.5 + C2).
    EXPECT_NEAR(*ssim(a, b, 1), (-0.5 + 9e-4) / (0.5 + 9e-4), 1e-3);
    EXPECT_EQ(*ssim(a, a, 1), 1);
}

TEST(Ssim, NeedsAWindow)
{
    EXPECT_FALSE(ssim(Image(10, 40), Image(10, 40), 1).has_value());
    EXPECT_TRUE(ssim(Image(11, 11), Image(11, 11), 1).has_value());
}

}  // namespace
}  // namespace sheer
