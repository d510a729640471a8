// The metrics on pictures whose differences are known. Values are multiples of powers of two where
// the answer is to be exact: sums and means of their squares are then exact too.
#include "compare/metrics.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include <sheer/error.h>

namespace sheer {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

Image filled(int width, int height, const std::array<float, 4>& pixel)
{
    Image image(width, height);
    for (std::array<float, 4>& p : image.pixels) p = pixel;
    return image;
}

Image grey(int width, int height, float value)
{
    return filled(width, height, {value, value, value, 1});
}

TEST(Metrics, AConstantOffset)
{
    for (const double d : {0.5, 0.25, 0.0078125, -0.125}) {
        const auto v = static_cast<float>(d);
        const Difference found = compare_images(grey(8, 4, 0.5f + v), grey(8, 4, 0.5f));
        EXPECT_EQ(found.rmse, 255 * std::abs(d));
        // Two logarithms within 3 units in the last place (of at most 2^-52), a few roundings.
        const double psnr = -20 * std::log10(std::abs(d));
        EXPECT_NEAR(found.psnr, psnr, 10 * 0x1p-52 * psnr);
        for (const double channel : found.bias_mean) EXPECT_EQ(channel, 255 * d);
        EXPECT_EQ(found.largest, 255 * std::abs(d));
        EXPECT_EQ(found.largest_x, 0);
        EXPECT_EQ(found.largest_y, 0);
    }
}

TEST(Metrics, ACheckerboardHasNoMean)
{
    Image a = grey(8, 6, 0.5f);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) a.at(x, y)[c] += (x + y) % 2 == 0 ? 0.25f : -0.25f;
        }
    }
    const Difference found = compare_images(a, grey(8, 6, 0.5f));
    EXPECT_EQ(found.rmse, 255 * 0.25);
    for (const double channel : found.bias_mean) EXPECT_EQ(channel, 0);
}

TEST(Metrics, OneChannelOfOnePixel)
{
    Image a = grey(8, 8, 0.25f);
    a.at(5, 2)[1] = 0.75f;
    const Difference found = compare_images(a, grey(8, 8, 0.25f));
    EXPECT_EQ(found.rmse, std::sqrt(0.25 / 64 / 3) * 255);
    EXPECT_EQ(found.bias_mean, (std::array<double, 3>{0, 255 * 0.5 / 64, 0}));
    EXPECT_EQ(found.largest, 127.5);
    EXPECT_EQ(found.largest_x, 5);
    EXPECT_EQ(found.largest_y, 2);
    const Difference back = compare_images(grey(8, 8, 0.25f), a);
    EXPECT_EQ(back.rmse, found.rmse);
    EXPECT_EQ(back.bias_mean[1], -found.bias_mean[1]);
}

TEST(Metrics, TheFirstOfTheLargest)
{
    Image a = grey(4, 4, 0);
    a.at(3, 1)[2] = -0.5f;
    a.at(0, 2)[0] = 0.5f;
    a.at(1, 0)[0] = 0.25f;
    const Difference found = compare_images(a, grey(4, 4, 0));
    EXPECT_EQ(found.largest, 127.5);
    EXPECT_EQ(found.largest_x, 3);
    EXPECT_EQ(found.largest_y, 1);
}

TEST(Metrics, NothingIsClamped)
{
    const Difference found = compare_images(grey(2, 2, 64), grey(2, 2, -64));
    EXPECT_EQ(found.rmse, 255 * 128);
    EXPECT_LT(found.psnr, 0);
}

TEST(Metrics, EqualPicturesAndAlpha)
{
    const Image a = filled(3, 2, {0.1f, 0.2f, 0.3f, 0.5f});
    const Image clearer = filled(3, 2, {0.1f, 0.2f, 0.3f, 0.4f});
    for (const Image& b : {a, clearer}) {
        const Difference found = compare_images(a, b);
        EXPECT_EQ(found.rmse, 0);
        EXPECT_EQ(found.psnr, std::numeric_limits<double>::infinity());
        EXPECT_EQ(found.bias_mean, (std::array<double, 3>{}));
        EXPECT_EQ(found.largest, 0);
    }
    EXPECT_TRUE(same_bits(a, a));
    EXPECT_FALSE(same_bits(a, clearer));
    EXPECT_FALSE(same_bits(grey(2, 2, 0.0f), grey(2, 2, -0.0f)));
    EXPECT_FALSE(same_bits(grey(2, 3, 0), grey(3, 2, 0)));
    EXPECT_TRUE(same_bits(grey(2, 2, kNaN), grey(2, 2, kNaN)));
}

TEST(Metrics, RefusesOtherSizes)
{
    const auto message = [](const Image& a, const Image& b) -> std::string {
        try {
            compare_images(a, b);
        } catch (const Error& error) {
            EXPECT_EQ(error.fault(), Fault::input);
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message(grey(4, 2, 0), grey(2, 4, 0)),
              "pictures of 4x2 and 2x4 pixels cannot be compared");
    EXPECT_EQ(message(Image(), Image()), "pictures without pixels have no distance");
}

// What is no number shows in every result, wherever it is, and its pixel is found.
TEST(Metrics, DoesNotHideWhatIsNotFinite)
{
    for (const float bad : {kInfinity, -kInfinity, kNaN}) {
        Image a = grey(4, 4, 0.5f);
        const Image b = a;
        a.at(0, 0)[0] = 1000;  // larger than all that is finite, and before
        a.at(2, 1)[2] = bad;
        a.at(3, 3)[0] = bad;
        const Difference found = compare_images(a, b);
        EXPECT_FALSE(std::isfinite(found.rmse));
        EXPECT_FALSE(std::isfinite(found.largest));
        EXPECT_EQ(found.largest_x, 2);
        EXPECT_EQ(found.largest_y, 1);
        const std::optional<Pixel> pixel = first_not_finite(a, b);
        ASSERT_TRUE(pixel);
        EXPECT_EQ(pixel->x, 2);
        EXPECT_EQ(pixel->y, 1);
        EXPECT_FALSE(first_not_finite(b, a));
        EXPECT_FALSE(std::isfinite(bias({a, grey(4, 4, 0), 2}, b)));
        EXPECT_FALSE(std::isfinite(rmse({a, grey(4, 4, 0), 2}, b)));
    }
}

TEST(Metrics, TheSameInfinityIsNoDifference)
{
    for (const float bad : {kInfinity, kNaN}) {
        const Image a = grey(4, 4, bad);
        EXPECT_FALSE(first_not_finite(a, a));
        EXPECT_EQ(compare_images(a, a).rmse, 0);
    }
    EXPECT_FALSE(first_not_finite(filled(2, 2, {0, 0, 0, kNaN}), grey(2, 2, 0)));
}

// Rounding errors of a sum row by row: each term and the quotient add less than 5 units of 2^-53,
// each addition one more; the square root halves them.
TEST(Metrics, AgreesWithASumInHigherPrecision)
{
    Image a(301, 127), b(301, 127);
    long double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            a.pixels[i][c] = static_cast<float>((i * 37 + c * 11) % 101) / 101;
            b.pixels[i][c] = static_cast<float>((i * 53 + c * 29) % 103) / 103;
            const long double d = static_cast<long double>(a.pixels[i][c]) - b.pixels[i][c];
            sum += d * d;
        }
    }
    const auto expected =
        static_cast<double>(std::sqrt(sum / (3 * static_cast<long double>(a.pixels.size()))) * 255);
    EXPECT_NEAR(compare_images(a, b).rmse, expected, expected * (301 + 127 + 10) / 2 * 0x1p-53);
}

}  // namespace
}  // namespace sheer
