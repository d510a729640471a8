// Noise, bias and error of random methods, on pictures whose mean and variance are known.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "compare/metrics.h"
#include "support/random.h"

namespace sheer {
namespace {

Image grey(int width, int height, float value)
{
    Image image(width, height);
    for (std::array<float, 4>& pixel : image.pixels) pixel = {value, value, value, 1};
    return image;
}

// In double precision, rounded to float once.
Moments moments_of(const std::vector<Image>& pictures)
{
    const auto n = static_cast<double>(pictures.size());
    const Image& first = pictures.front();
    Moments moments{first, first, static_cast<int>(pictures.size())};
    for (std::size_t i = 0; i < first.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
            double mean = 0, squares = 0;
            for (const Image& picture : pictures) mean += picture.pixels[i][c] / n;
            for (const Image& picture : pictures) {
                squares += (picture.pixels[i][c] - mean) * (picture.pixels[i][c] - mean);
            }
            moments.mean.pixels[i][c] = static_cast<float>(mean);
            moments.variance.pixels[i][c] = static_cast<float>(n > 1 ? squares / (n - 1) : 0);
        }
    }
    return moments;
}

// Uniform in [middle - spread, middle + spread], each channel of each pixel of each seed for
// itself.
Image random_picture(std::uint64_t seed, float middle, float spread)
{
    const CounterRandom random{seed};
    Image image(64, 64);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto u = static_cast<float>(2 * random.uniform(3 * i + c) - 1);
            image.pixels[i][c] = middle + spread * u;
        }
    }
    return image;
}

std::vector<Image> random_pictures(int seeds, float middle, float spread)
{
    std::vector<Image> pictures;
    for (int seed = 0; seed < seeds; ++seed) {
        pictures.push_back(random_picture(static_cast<std::uint64_t>(seed), middle, spread));
    }
    return pictures;
}

// What is allowed to the mean squares of values in [0, 1] for means and variances being floats:
// the square of m - C changes by 2 * 2^-25, and s^2 <= 1 by 2^-25.
constexpr double kFloatMoments = 3 * 0x1p-25;

// C + b + e and C + b - e: s^2 = 2 e^2, exactly.
TEST(Moments, TwoSeeds)
{
    const double b = 0.5, e = 0.25;
    const Image truth = grey(4, 4, 0.25f);
    const Moments moments = moments_of({grey(4, 4, 1.0f), grey(4, 4, 0.5f)});
    EXPECT_EQ(noise(moments), std::sqrt(2 * e * e) * 255);
    EXPECT_EQ(rmse(moments, truth), std::sqrt(b * b + e * e) * 255);
    EXPECT_EQ(bias(moments, truth), std::sqrt(b * b - e * e) * 255);
    for (const double channel : bias_mean(moments, truth)) EXPECT_EQ(channel, 255 * b);
}

// C + b + e and C + b - e, each for half of n seeds: s^2 = e^2 n / (n - 1).
TEST(Moments, EqualCountsAboveAndBelow)
{
    const double b = 0.125, e = 0.25;
    const Image truth = grey(4, 4, 0.5f);
    for (const int n : {4, 6, 16, 64}) {
        std::vector<Image> pictures;
        for (int i = 0; i < n; ++i) pictures.push_back(grey(4, 4, i % 2 == 0 ? 0.875f : 0.375f));
        const Moments moments = moments_of(pictures);
        const double s2 = e * e * n / (n - 1);
        const double bias2 = std::max(0.0, b * b - e * e / (n - 1));
        const auto near_root = [](double found, double square) {
            EXPECT_NEAR(found * found, square * 255 * 255, kFloatMoments * 255 * 255) << square;
        };
        near_root(noise(moments), s2);
        near_root(rmse(moments, truth), b * b + e * e);
        near_root(bias(moments, truth), bias2);
        for (const double channel : bias_mean(moments, truth)) {
            EXPECT_NEAR(channel, 255 * b, 255 * 0x1p-25);
        }
    }
}

TEST(Moments, BiasIsNeverBelowZero)
{
    // The mean is the truth; the variance alone would make the estimate negative.
    const Moments moments = moments_of({grey(2, 2, 0.75f), grey(2, 2, 0.25f)});
    EXPECT_EQ(bias(moments, grey(2, 2, 0.5f)), 0);
    EXPECT_GT(noise(moments), 0);
}

TEST(Moments, OneSeedIsOnePicture)
{
    const Image picture = random_picture(3, 0.5f, 0.25f);
    const Image truth = grey(64, 64, 0.25f);
    const Moments moments = moments_of({picture});
    const Difference difference = compare_images(picture, truth);
    EXPECT_EQ(noise(moments), 0);
    EXPECT_EQ(rmse(moments, truth), difference.rmse);
    EXPECT_EQ(bias(moments, truth), difference.rmse);
    EXPECT_EQ(bias_mean(moments, truth), difference.bias_mean);
}

TEST(Moments, RmseIsTheRootOfTheMeanOverTheSeeds)
{
    const std::vector<Image> pictures = random_pictures(7, 0.5f, 0.5f);
    const Image truth = random_picture(99, 0.5f, 0.5f);
    double mean = 0;
    for (const Image& picture : pictures) {
        const double one = compare_images(picture, truth).rmse / 255;
        mean += one * one / 7;
    }
    const double found = rmse(moments_of(pictures), truth) / 255;
    EXPECT_NEAR(found * found, mean, kFloatMoments);
}

// With y_i = x_i - C, (m - C)^2 - s^2/n is the mean of y_i y_j over all i != j. Of a value whose
// variance is v and whose mean is C + b, its mean is b^2 and its variance
// 2 v^2 / (n (n - 1)) + 4 b^2 v / n, whatever the distribution. Five standard deviations of the
// mean of all values: one run in a million fails where the seeds are drawn anew.
TEST(Moments, BiasOfAKnownDistribution)
{
    const int n = 8;
    const double values = 3 * 64 * 64;
    const float spread = 0.25f;
    const double v = double{spread} * spread / 3;
    const Moments moments = moments_of(random_pictures(n, 0.5f, spread));
    for (const float b : {0.0f, 0.015625f, 0.125f}) {
        const Image truth = grey(64, 64, 0.5f - b);
        const double b2 = double{b} * b;
        const double deviation = std::sqrt((2 * v * v / (n * (n - 1)) + 4 * b2 * v / n) / values);
        const double found = bias(moments, truth) / 255;
        EXPECT_LE(found * found, b2 + 5 * deviation + kFloatMoments) << b;
        EXPECT_GE(found * found, std::max(0.0, b2 - 5 * deviation - kFloatMoments)) << b;
        for (const double channel : bias_mean(moments, truth)) {
            EXPECT_NEAR(channel / 255, double{b}, 5 * std::sqrt(v / n * 3 / values) + 0x1p-24) << b;
        }
    }
    // The test would see the missing of the second term: that is far above what is allowed.
    EXPECT_GT(v / n, 5 * 5 * std::sqrt(2 * v * v / (n * (n - 1)) / values));
    // s^2 of a uniform distribution varies by less than that of a normal one.
    const double found = noise(moments) / 255;
    EXPECT_NEAR(found * found, v, 5 * v * std::sqrt(2 / ((n - 1) * values)) + kFloatMoments);
}

}  // namespace
}  // namespace sheer
