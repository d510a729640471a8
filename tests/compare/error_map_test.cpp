// Error maps: the colours, what they stand for, and scales.
#include "compare/error_map.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <sheer/error.h>

#include "image/color.h"
#include "image/png.h"

namespace sheer {
namespace {

using Codes = std::array<int, 3>;

constexpr Codes kBlack = {0, 0, 4}, kYellow = {252, 253, 191}, kGreen = {0, 255, 0};

Image grey(int width, int height, float value)
{
    Image image(width, height);
    for (std::array<float, 4>& pixel : image.pixels) pixel = {value, value, value, 1};
    return image;
}

// The map of a row of grey pixels with these values against black.
Image map_of(const std::vector<float>& values, double scale)
{
    Image image(static_cast<int>(values.size()), 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
        image.pixels[i] = {values[i], values[i], values[i], 1};
    }
    return error_map(image, Image(image.width, 1), scale);
}

// What a PNG file of the picture holds.
Codes codes_at(const Image& map, int x)
{
    Codes codes{};
    for (std::size_t c = 0; c < 3; ++c) codes[c] = srgb8_from_linear(map.at(x, 0)[c]);
    return codes;
}

TEST(ErrorMap, ShowsTheTableInPng)
{
    std::vector<float> values;
    for (int i = 0; i <= 15; ++i) values.push_back(static_cast<float>(i) / 16);
    const Image map = map_of(values, 255 * 15.0 / 16);
    EXPECT_EQ(codes_at(map, 0), kBlack);
    EXPECT_EQ(codes_at(map, 5), (Codes{114, 31, 129}));
    EXPECT_EQ(codes_at(map, 9), (Codes{222, 73, 104}));
    EXPECT_EQ(codes_at(map, 15), kYellow);
    for (const std::array<float, 4>& pixel : map.pixels) EXPECT_EQ(pixel[3], 1);
    const Image read = decode_png(encode_png(map), "map.png");
    for (int x = 0; x < 16; ++x) EXPECT_EQ(codes_at(read, x), codes_at(map, x));
}

// Colours of the original's 256, where the straight lines are furthest from them (43) and
// elsewhere.
TEST(ErrorMap, IsCloseToTheOriginalBetweenItsPoints)
{
    struct Original {
        int index;
        std::array<double, 3> srgb;
    };
    for (const Original& original : {Original{43, {0.178212, 0.066576, 0.379497}},
                                     Original{60, {0.291366, 0.064553, 0.475462}},
                                     Original{128, {0.716387, 0.214982, 0.475290}},
                                     Original{200, {0.992785, 0.594891, 0.410283}}}) {
        const Image map = map_of({static_cast<float>(original.index) / 256}, 255 * 255.0 / 256);
        for (std::size_t c = 0; c < 3; ++c) {
            const double shown = srgb_from_linear(map.at(0, 0)[c]);
            EXPECT_NEAR(shown * 255, original.srgb[c] * 255, 2.2) << original.index;
        }
    }
}

TEST(ErrorMap, LargerErrorsAreLighter)
{
    std::vector<float> values;
    for (int i = 0; i <= 1024; ++i) values.push_back(static_cast<float>(i) / 1024);
    const Image map = map_of(values, 255);
    double before = -1;
    for (const std::array<float, 4>& p : map.pixels) {
        const double luminance = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
        EXPECT_GT(luminance, before);
        before = luminance;
    }
}

TEST(ErrorMap, ShowsWhatIsAboveTheScaleAndWhatIsNoNumber)
{
    const float infinity = std::numeric_limits<float>::infinity();
    const Image map = map_of({0.5f, 100, infinity, std::nanf(""), 0, -0.5f}, 10);
    EXPECT_EQ(codes_at(map, 0), kYellow);
    EXPECT_EQ(codes_at(map, 1), kYellow);
    EXPECT_EQ(codes_at(map, 2), kGreen);
    EXPECT_EQ(codes_at(map, 3), kGreen);
    EXPECT_EQ(codes_at(map, 4), kBlack);
    EXPECT_EQ(codes_at(map, 5), kYellow);
    // Equal pictures have the scale 0.
    EXPECT_EQ(codes_at(map_of({0, 1}, 0), 0), kBlack);
    EXPECT_EQ(codes_at(map_of({0, 1}, 0), 1), kYellow);
    const Image no_numbers = grey(1, 1, infinity);
    EXPECT_EQ(codes_at(error_map(no_numbers, no_numbers, 1), 0), kBlack);
}

TEST(ErrorMap, AlphaDoesNotCount)
{
    Image a = grey(1, 1, 0.5f);
    const Image b = a;
    a.pixels[0][3] = 0.5f;
    EXPECT_EQ(codes_at(error_map(a, b, 1), 0), kBlack);
    EXPECT_EQ(error_scale(a, b), 0);
}

TEST(ErrorMap, RefusesOtherSizes)
{
    EXPECT_THROW(error_map(grey(2, 1, 0), grey(1, 2, 0), 1), Error);
    EXPECT_THROW(error_scale(grey(2, 1, 0), grey(1, 2, 0)), Error);
}

TEST(ErrorScale, IsOneTwoOrFiveTimesAPowerOfTen)
{
    struct Case {
        float difference;
        double scale;  // the next above 255 times that
    };
    for (const Case& c :
         {Case{0, 0}, Case{1, 500}, Case{0.5f, 200}, Case{0.25f, 100}, Case{0.125f, 50},
          Case{0x1p-4f, 20}, Case{0x1p-5f, 10}, Case{0x1p-6f, 5}, Case{0x1p-7f, 2},
          Case{0x1p-8f, 1}, Case{0x1p-9f, 0.5}, Case{0x1p-11f, 0.2}, Case{0x1p-12f, 0.1},
          Case{0x1p-17f, 0.002}, Case{0x1p-18f, 0.001}, Case{0x1p-26f, 5e-6}, Case{16, 5000},
          Case{0x1p20f, 5e8}, Case{-1, 500}}) {
        EXPECT_EQ(error_scale(grey(3, 3, c.difference), grey(3, 3, 0)), c.scale) << c.difference;
    }
}

// 255 / sqrt(3) = 147 for one channel of three; the largest channel would say 500, the mean 100.
TEST(ErrorScale, IsOfTheRootMeanSquare)
{
    Image a(1, 1);
    a.pixels[0] = {0, 1, 0, 0};
    EXPECT_EQ(error_scale(a, Image(1, 1)), 200);
}

TEST(ErrorScale, LeavesOutOneInAThousandOfWhatDiffers)
{
    const auto scale_of = [](int differing) {
        Image a = grey(2000, 1, 0);
        for (int x = 0; x < differing; ++x) a.at(x, 0) = {0x1p-7f, 0x1p-7f, 0x1p-7f, 1};
        a.at(differing / 2, 0) = {1, 1, 1, 1};
        return error_scale(a, grey(2000, 1, 0));
    };
    EXPECT_EQ(scale_of(1), 500);
    EXPECT_EQ(scale_of(999), 500);
    EXPECT_EQ(scale_of(1000), 2);
    EXPECT_EQ(scale_of(2000), 2);
}

TEST(ErrorScale, LooksPastWhatIsNoNumber)
{
    Image a = grey(4, 1, 0.25f);
    a.at(0, 0)[0] = std::numeric_limits<float>::infinity();
    a.at(1, 0)[0] = std::nanf("");
    EXPECT_EQ(error_scale(a, grey(4, 1, 0)), 100);
}

TEST(ErrorMap, MapsShareTheMiddleScale)
{
    EXPECT_EQ(shared_scale({}), 0);
    EXPECT_EQ(shared_scale({0, 0}), 0);
    EXPECT_EQ(shared_scale({5}), 5);
    EXPECT_EQ(shared_scale({5, 0.2}), 5);
    EXPECT_EQ(shared_scale({500, 0.2, 0, 2}), 2);
}

}  // namespace
}  // namespace sheer
