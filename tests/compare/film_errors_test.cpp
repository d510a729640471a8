// Flicker and ghosting of sequences for which they are known.
#include "compare/film_errors.h"

#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.h"

namespace sheer {
namespace {

constexpr int kWidth = 64, kHeight = 16, kFrames = 12;
constexpr double kNumbers = 3.0 * kWidth * kHeight;

using Picture = std::function<float(int frame, int x, int y, std::size_t channel)>;

Image image_of(const Picture& picture, int frame)
{
    Image image(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            for (std::size_t c = 0; c < 3; ++c) image.at(x, y)[c] = picture(frame, x, y, c);
        }
    }
    return image;
}

FilmScores scores_of(const Picture& method, const Picture& truth)
{
    FilmTruth frames;
    FilmErrors errors;
    for (int i = 0; i < kFrames; ++i) {
        frames.add(image_of(truth, i));
        errors.add(image_of(method, i), frames);
    }
    return errors.scores();
}

// In multiples of 1/256, so that sums are exact. From 0 to 1, in each frame another.
float number(std::uint64_t seed, int frame, int x, int y, std::size_t channel)
{
    const CounterRandom random{seed};
    const auto at = static_cast<std::uint64_t>(((frame * kHeight + y) * kWidth + x) * 3) + channel;
    return static_cast<float>(random.bits(at) >> 56) / 256;
}

// A pattern of stripes that moves by two pixels a frame, and comes back where it leaves.
float moving(int frame, int x, int y, std::size_t channel)
{
    return number(1, 0, (x + 2 * frame) % kWidth, y, channel);
}
float still(int, int x, int y, std::size_t channel)
{
    return number(1, 0, x, y, channel);
}

TEST(FilmErrors, TheTruthHasNone)
{
    const FilmScores scores = scores_of(moving, moving);
    EXPECT_EQ(scores.rmse, 0);
    EXPECT_EQ(*scores.flicker, 0);
    EXPECT_EQ(*scores.ghosting, 0);
}

TEST(FilmErrors, OneFrameHasNoChange)
{
    FilmTruth truth;
    truth.add(image_of(moving, 0));
    FilmErrors errors;
    errors.add(image_of([](auto...) { return 0.5f; }, 0), truth);
    EXPECT_GT(errors.scores().rmse, 0);
    EXPECT_FALSE(errors.scores().flicker);
    EXPECT_FALSE(errors.scores().ghosting);
}

TEST(FilmErrors, WhatGoesToAndFroFlickersByTheWholeOfIt)
{
    for (const Picture& truth : {Picture(still), Picture(moving)}) {
        const FilmScores scores = scores_of(
            [&](int frame, int x, int y, std::size_t c) {
                return truth(frame, x, y, c) + (frame % 2 == 0 ? 0.125f : -0.125f);
            },
            truth);
        EXPECT_NEAR(scores.rmse, 255 * 0.125, 1e-4);
        EXPECT_NEAR(*scores.flicker, 255 * 0.25, 1e-4);
        // The sum of all differences of the truth's frames is 0, and so is their product with a
        // picture of one colour.
        EXPECT_NEAR(*scores.ghosting, 0, 1e-3);
    }
}

TEST(FilmErrors, WhatIsWrongInAllFramesAlikeDoesNotFlicker)
{
    const FilmScores scores =
        scores_of([](int frame, int x, int y,
                     std::size_t c) { return moving(frame, x, y, c) + number(2, 0, x, y, c); },
                  moving);
    EXPECT_GT(scores.rmse, 100);
    EXPECT_NEAR(*scores.flicker, 0, 1e-4);
}

double root_mean_square(const Picture& picture, int first)
{
    double sum = 0;
    for (int i = first; i < kFrames; ++i) {
        for (const Float4& p : image_of(picture, i).pixels) {
            for (std::size_t c = 0; c < 3; ++c) sum += double{p[c]} * double{p[c]};
        }
    }
    return 255 * std::sqrt(sum / ((kFrames - first) * kNumbers));
}

TEST(FilmErrors, MixturesOfEarlierFramesAreNothingButGhosts)
{
    const auto earlier = [](int frame, int lag, int x, int y, std::size_t c) {
        return moving(std::max(frame - lag, 0), x, y, c);
    };
    const Picture mixture = [&](int frame, int x, int y, std::size_t c) {
        return 0.5f * moving(frame, x, y, c) + 0.25f * earlier(frame, 1, x, y, c) +
               0.125f * earlier(frame, 2, x, y, c) + 0.125f * earlier(frame, 8, x, y, c);
    };
    const Picture error = [&](int frame, int x, int y, std::size_t c) {
        return mixture(frame, x, y, c) - moving(frame, x, y, c);
    };
    FilmTruth truth;
    FilmErrors errors;
    // The first eight frames, whose lags are not there yet, are the truth.
    double squares = 0;
    for (int i = 0; i < kFrames; ++i) {
        truth.add(image_of(moving, i));
        errors.add(image_of(i < 8 ? Picture(moving) : mixture, i), truth);
    }
    squares = std::pow(root_mean_square(error, 8), 2) * (kFrames - 8) / (kFrames - 1);
    EXPECT_GT(squares, 100);
    EXPECT_NEAR(*errors.scores().ghosting, std::sqrt(squares), 1e-4 * std::sqrt(squares));
}

// Of independent numbers of variance v the change has 2 v. Ghosts are what falls on at most 4 of
// their N directions: of squares of normal numbers, no more than 36 in all of 11 frames, have a sum
// above 100 less than once in 10^7.
TEST(FilmErrors, NoiseFlickersAndLeavesNoGhosts)
{
    const double variance = (1 - 1.0 / 65536) / 12;
    const FilmScores scores =
        scores_of([](int frame, int x, int y,
                     std::size_t c) { return moving(frame, x, y, c) + number(3, frame, x, y, c); },
                  moving);
    // The mean square of 11 N changes: a deviation below 2 v sqrt(2 / (11 N)), and 6 of those.
    const double square = std::pow(*scores.flicker / 255, 2);
    EXPECT_NEAR(square, 2 * variance, 6 * 2 * variance * std::sqrt(2 / (11 * kNumbers)));
    EXPECT_LT(std::pow(*scores.ghosting / 255, 2), variance * 100 / (11 * kNumbers));
}

// Frames that do not change have no ghosts, whatever is wrong.
TEST(FilmErrors, WhatStandsStillHasNoGhosts)
{
    const FilmScores scores = scores_of(
        [](int frame, int x, int y, std::size_t c) { return number(4, frame, x, y, c); }, still);
    EXPECT_EQ(*scores.ghosting, 0);
    EXPECT_GT(*scores.flicker, 0);
}

}  // namespace
}  // namespace sheer
