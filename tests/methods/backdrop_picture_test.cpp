// Blurred backdrops: moments that a blur must have wherever it is read, and a step's profile.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "methods/backdrop_picture.h"
#include "methods/rounding.h"

namespace sheer {

namespace {

BackdropPicture picture_of(int width, int height, const std::function<double(double, double)>& f)
{
    BackdropPicture picture(width, height, {1, 1});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto value = static_cast<float>(f(x + 0.5, y + 0.5));
            picture.color(x, y) = {value, value, value, value};
        }
    }
    picture.make_levels();
    return picture;
}

double blurred(const BackdropPicture& picture, float x, float y, float variance)
{
    const Float4 sharp = picture.between(x, y);
    return static_cast<double>(picture.blurred(x, y, variance, sharp)[1]);
}

// Of what is read of some ten levels, in units of the largest value: no weight is negative, and
// each level is a sum of 4x4 products by rows, 10 roundings with those of its weights; as many for
// the spline, whose weights are off by 4 more each, and the mean of two.
constexpr double kBlurRoundings = (10 * 10 + 20) * kUnit;

constexpr float kVariances[] = {0.1f, 0.25f, 0.7f, 1.75f, 3, 7.75f, 12, 25, 31.75f, 60};

double normal_below(double x)
{
    return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

}  // namespace

TEST(BackdropPicture, AConstantStaysThat)
{
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{37, 5}, std::pair{64, 33}}) {
        const BackdropPicture picture =
            picture_of(width, height, [](double, double) { return 0.7; });
        std::mt19937 random(1);
        std::uniform_real_distribution<float> place(-50, 100);
        for (const float variance : {0.0f, 0.1f, 1.0f, 20.0f, 1e3f, 1e6f, 1e30f}) {
            for (int i = 0; i < 20; ++i) {
                const double got = blurred(picture, place(random), place(random), variance);
                EXPECT_NEAR(got, 0.7, 0.7 * kBlurRoundings) << variance;
            }
        }
    }
}

// A kernel w around x has the sums: w is 1, w (t - x) is 0, w (t - x)^2 is its variance. So what is
// linear stays as it is, and squares become larger by the variance, at every place alike.
TEST(BackdropPicture, ABlurHasItsVarianceAndMovesNothing)
{
    constexpr double kReach = 48;  // level 4, twice: 3/2 x 16 pixels each; values there are 1
    const auto square = [](double x, double y) {
        return ((x - 128) * (x - 128) + (y - 128) * (y - 128)) / (kReach * kReach);
    };
    const auto slope = [](double x, double y) { return (x - 2 * y + 128) / 128; };
    const BackdropPicture squares = picture_of(256, 256, square);
    const BackdropPicture slopes = picture_of(256, 256, slope);
    std::mt19937 random(2);
    std::uniform_real_distribution<float> uniform(126, 130);
    // The kernel reaches 50 pixels from the middle; and variances are floats.
    const double bound = 4 * kBlurRoundings;
    for (const float variance : kVariances) {
        for (int i = 0; i < 50; ++i) {
            float x = uniform(random), y = uniform(random);
            // Below level 0's own variance what is sharp counts too: at pixels' centres it has
            // none.
            if (variance < 0.25f) x = std::floor(x) + 0.5f, y = std::floor(y) + 0.5f;
            const auto px = static_cast<double>(x), py = static_cast<double>(y);
            const double more = 2 * static_cast<double>(variance) / (kReach * kReach);
            EXPECT_NEAR(blurred(squares, x, y, variance), square(px, py) + more, bound) << variance;
            EXPECT_NEAR(blurred(slopes, x, y, variance), slope(px, py), bound) << variance;
        }
    }
    // Twice the variance would be seen.
    EXPECT_GT(2 * 0.1 / (kReach * kReach), 2 * bound);
}

// All pixels' blurred colours have the sum of all pixels' colours, where the border is far: every
// pixel is read with weights that add up to 1.
TEST(BackdropPicture, LightIsKept)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    const BackdropPicture picture = picture_of(192, 160, [&](double x, double y) {
        return x > 64 && x < 128 && y > 56 && y < 104 ? uniform(random) : 0.0;
    });
    double sharp = 0;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 192; ++x) {
            sharp +=
                blurred(picture, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0);
        }
    for (const float variance : kVariances) {
        double sum = 0;
        for (int y = 0; y < 160; ++y) {
            for (int x = 0; x < 192; ++x) {
                sum += blurred(picture, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f,
                               variance);
            }
        }
        EXPECT_NEAR(sum, sharp, sharp * kBlurRoundings) << variance;
    }
}

// A step becomes a normal distribution's function, but for what two things change:
// - two levels are mixed, whose variances the wanted one lies between: the gap between the mixture
//   and one normal distribution is worked out here;
// - a level's kernel is no normal one: its excess kurtosis is -0.6 to 0.15, by where it is read (a
//   quarter of -0.4, of three uniform distributions, and of the spline's -2 to 1), which changes
//   its function by 0.6 / 24 max |(x^3 - 3 x) phi(x)| = 0.6 / 24 x 0.551 at most, to first order;
//   and so does its skewness, the spline's third moment f / 4 - f^3 at f from a pixel's centre over
//   (1/2)^(3/2): 0.136 / 6 max |(x^2 - 1) phi(x)| = 0.136 / 6 x 0.399; half as much again for what
//   follows.
struct Gap {
    double bound;  // of a step's blur from the normal distribution's function
    double fault;  // of that of twice the variance
};

Gap gap_of(double variance)
{
    double finer = 0.25, coarser = 1.75;
    while (coarser < variance) {
        finer = coarser;
        coarser = 4 * coarser + 0.75;  // 4^l / 2 - 1/4
    }
    const double part = (variance - finer) / (coarser - finer);
    double gap = 0, fault = 0;
    for (double x = 0; x < 5; x += 0.002) {
        const double wanted = normal_below(x), scale = std::sqrt(variance);
        const double mixture = (1 - part) * normal_below(x * scale / std::sqrt(finer)) +
                               part * normal_below(x * scale / std::sqrt(coarser));
        gap = std::max(gap, std::abs(mixture - wanted));
        fault = std::max(fault, std::abs(normal_below(x / std::sqrt(2.0)) - wanted));
    }
    return {gap + 1.5 * (0.6 / 24 * 0.551 + 0.136 / 6 * 0.399), fault};
}

TEST(BackdropPicture, AStepBecomesABlurredOne)
{
    const BackdropPicture picture =
        picture_of(256, 8, [](double x, double) { return x < 128 ? 0.0 : 1.0; });
    for (const float variance : {7.75f, 12.0f, 18.0f, 25.0f, 31.75f}) {
        const auto v = static_cast<double>(variance);
        const Gap gap = gap_of(v);
        EXPECT_GT(gap.fault, gap.bound);  // twice the variance would be found
        for (int x = 0; x < 256; ++x) {
            const double got = blurred(picture, static_cast<float>(x) + 0.5f, 4, variance);
            EXPECT_NEAR(got, normal_below((x + 0.5 - 128) / std::sqrt(v)), gap.bound)
                << variance << ", " << x;
        }
    }
}

// The same where most of what is read lies beyond the border, in pictures of any size: the step's
// two halves go on.
TEST(BackdropPicture, BeyondTheBorderTheLastPixelsGoOn)
{
    for (const int size : {97, 128, 135, 270, 513}) {
        const int middle = size / 2;  // between two pixels
        for (const bool along_x : {true, false}) {
            const auto step = [&](double x, double y) {
                return (along_x ? x : y) < middle ? 0.0 : 1.0;
            };
            const BackdropPicture picture =
                picture_of(along_x ? size : 7, along_x ? 7 : size, step);
            for (const float variance : {511.75f, 900.0f, 2000.0f, 2047.75f, 2500.0f}) {
                if (variance > static_cast<float>(size * size) / 8) continue;  // of its last level
                const auto v = static_cast<double>(variance);
                const double bound = gap_of(v).bound;
                for (int i = 0; i < size; i += 3) {
                    const float at = static_cast<float>(i) + 0.5f;
                    const double got = along_x ? blurred(picture, at, 3.5f, variance)
                                               : blurred(picture, 3.5f, at, variance);
                    EXPECT_NEAR(got, normal_below((i + 0.5 - middle) / std::sqrt(v)), bound)
                        << size << ", " << variance << ", " << i;
                }
            }
        }
    }
}

}  // namespace sheer
