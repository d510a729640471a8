// Frames where they are needed, and the post filter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <sheer/error.h>
#include <sheer/sheer.h>

#include "cpu/adaptive_frames.h"
#include "cpu/post_filter.h"
#include "methods/statistics.h"
#include "methods/stochastic_fixture.h"

namespace sheer {

namespace {

constexpr const char* kCorrected = "stochastic:depth-based=on:correction=on";

Image filled(int width, int height, float value)
{
    Image image(width, height);
    std::fill(image.pixels.begin(), image.pixels.end(), Float4{value, value, value, value});
    return image;
}

// Mean over a tile's pixels and colours of the variance over pictures: largest of all tiles.
double largest_tile_variance(const std::vector<Image>& pictures)
{
    const int width = pictures[0].width, height = pictures[0].height;
    const auto count = static_cast<double>(pictures.size());
    double most = 0;
    for (int y0 = 0; y0 + kTileSize <= height; y0 += kTileSize) {
        for (int x0 = 0; x0 + kTileSize <= width; x0 += kTileSize) {
            double sum = 0;
            for (int i = 0; i < kTilePixels; ++i) {
                for (std::size_t c = 0; c < 3; ++c) {
                    double mean = 0, square = 0;
                    for (const Image& image : pictures) {
                        const auto value = static_cast<double>(
                            image.at(x0 + i % kTileSize, y0 + i / kTileSize)[c]);
                        mean += value / count;
                        square += value * value / count;
                    }
                    sum += (square - mean * mean) * count / (count - 1);
                }
            }
            most = std::max(most, sum / (3 * kTilePixels));
        }
    }
    return most;
}

}  // namespace

TEST(ShareFrames, TargetIsVarianceOverItsSquare)
{
    AdaptiveFrames adaptive;
    adaptive.noise_target = 2;
    const double target = 2.0 / 255;
    for (const double frames : {0.0, 0.3, 1.0, 6.5, 100.0}) {
        const auto variance = static_cast<float>(frames * target * target);
        const auto counts = share_frames(adaptive, filled(9, 7, variance), filled(9, 7, 0.5f));
        ASSERT_EQ(counts.size(), 63u);
        for (const int count : counts) EXPECT_NEAR(count, std::max(1.0, frames), 1.0) << frames;
    }
    adaptive.most = 10;
    const auto counts = share_frames(adaptive, filled(4, 4, 1), filled(4, 4, 1));
    EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), 10);
}

TEST(ShareFrames, BudgetIsSharedByDeviation)
{
    Image variance = filled(40, 20, 0.01f);
    for (int y = 0; y < 20; ++y) {
        for (int x = 20; x < 40; ++x) variance.at(x, y) = {0.16f, 0.16f, 0.16f, 0};
    }
    AdaptiveFrames adaptive;
    adaptive.budget = 54;  // 50 without the pilots
    const auto counts = share_frames(adaptive, variance, filled(40, 20, 0.5f));
    double sum = 0;
    for (const int count : counts) sum += count;
    EXPECT_LE(sum / 800, 50);
    EXPECT_GT(sum / 800, 48);
    // Four times the deviation, four times the frames: 20 and 80, rounded up.
    EXPECT_NEAR(counts[0], 20, 1.5);
    EXPECT_NEAR(counts[39], 80, 3);
}

// The same noise on black is worse: 9 times the deviation of that on white.
TEST(ShareFrames, RelativeNoiseFavoursTheDark)
{
    AdaptiveFrames adaptive;
    adaptive.noise_target = 3;
    adaptive.relative = true;
    adaptive.most = 65'535;
    const Image variance = filled(8, 8, 0.02f);
    const auto dark = share_frames(adaptive, variance, filled(8, 8, 0));
    const auto light = share_frames(adaptive, variance, filled(8, 8, 1));
    EXPECT_NEAR(dark[0] / static_cast<double>(light[0]), 81, 1);
}

// Each pixel is a mean of as many frames as the pilots asked for, which are none of these.
TEST(AdaptiveFrames, ChoosingDoesNotBias)
{
    const Scene scene = scene_of(red_over_green());
    Options options;
    options.method = "stochastic";
    options.adaptive.noise_target = 12;
    const Frame frame = render(scene, centered_view(256, 4), options);
    EXPECT_GT(frame.stats.frames_per_pixel, kPilotFrames + 2);
    const double truth[] = {0.45, 0.2475, 0.3025};
    for (std::size_t c = 0; c < 3; ++c) {
        const Observed observed = observe(channel_of(frame.image, c));
        EXPECT_TRUE(verdict(observed.mean - truth[c],
                            kZ * std::sqrt(observed.variance / observed.count), "the mean"));
    }
}

TEST(AdaptiveFrames, ReachTheTargetWithHalfOfTheFrames)
{
    const Scene scene = load("builtin:motor");
    View view;
    view.width = view.height = 192;
    constexpr float kTarget = 1.2f;
    std::vector<Image> even, adapted;
    double frames = 0;
    Options options;
    options.method = kCorrected;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        options.seed = seed;
        options.adaptive.noise_target = 0;
        even.push_back(render(scene, view, options).image);
        options.adaptive.noise_target = kTarget;
        const Frame frame = render(scene, view, options);
        adapted.push_back(frame.image);
        frames = std::max(frames, frame.stats.frames_per_pixel);
    }
    const double reached = largest_tile_variance(adapted);
    // Variances of 4 pictures over 1,024 pixels and 3 channels: 2 % of themselves, and those that
    // pilots saw 5 %.
    EXPECT_LE(255 * std::sqrt(reached), kTarget * 1.1);
    const double even_frames = largest_tile_variance(even) / reached;
    EXPECT_LE(frames, even_frames / 2) << "of which " << kPilotFrames << " are pilots";
}

TEST(AdaptiveFrames, ThreadsAndFiltersMakeNoDifference)
{
    const Scene scene = load("builtin:quads");
    View view = centered_view(70, 4);
    view.positions = SamplePositions::standard;
    for (const Filter filter : {Filter::box, Filter::gaussian}) {
        view.filter = filter;
        Options options;
        options.method = kCorrected;
        options.adaptive.noise_target = 3;
        options.channels = true;
        options.threads = 1;
        const Frame one = render(scene, view, options);
        options.threads = 3;
        const Frame three = render(scene, view, options);
        EXPECT_EQ(one.image.pixels, three.image.pixels);
        EXPECT_EQ(one.channels->frames, three.channels->frames);
        // A pixel with as many frames as the others have is what it is there.
        const float most =
            *std::max_element(one.channels->frames.begin(), one.channels->frames.end());
        options.adaptive = {};
        options.accumulate = static_cast<int>(most);
        const Frame even = render(scene, view, options);
        for (std::size_t i = 0; i < even.image.pixels.size(); ++i) {
            if (one.channels->frames[i] == most) {
                EXPECT_EQ(one.image.pixels[i], even.image.pixels[i]) << "pixel " << i;
            }
        }
    }
}

TEST(PostFilter, SmoothsNoiseAndLeavesTheRest)
{
    const Scene scene = scene_of(red_over_green());
    Options options;
    options.method = kCorrected;
    const Image noisy = render(scene, centered_view(128, 4), options).image;
    options.post_filter.cross_bilateral = true;
    const Image smooth = render(scene, centered_view(128, 4), options).image;
    for (std::size_t c = 0; c < 2; ++c) {
        const Observed before = observe(channel_of(noisy, c));
        const Observed after = observe(channel_of(smooth, c));
        EXPECT_NEAR(after.mean, before.mean, 1e-4);
        EXPECT_LT(after.variance, before.variance / 2);
    }
    // Total alpha is the same everywhere, and so is what is left of the background.
    EXPECT_FALSE(observe(channel_of(smooth, 2)).varies);
}

// Two halves of other colours. Where their total alpha differs by five sigma_r or more, a pixel of
// the other half weighs exp(-12.5) at most; where it doesn't, the nearest weighs exp(-1 / (2
// 0.6^2)) = 0.25.
TEST(PostFilter, StopsWhereTotalAlphaChanges)
{
    const auto filtered = [](float left_alpha, float right_alpha) {
        Image transparent(16, 16);
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) {
                transparent.at(x, y) = x < 8 ? Float4{0.2f, 0.2f, 0.2f, left_alpha}
                                             : Float4{0.8f, 0.8f, 0.8f, right_alpha};
            }
        }
        Image image = transparent;
        PostFilter filter;
        filter.cross_bilateral = true;
        apply_post_filter(filter, transparent, 1, image);
        return image.at(7, 8)[0];
    };
    // Of at most 25 others with a difference of 0.6 in colour.
    EXPECT_NEAR(filtered(0.5f, 0.75f), 0.2f, 25 * 0.6f * 3.8e-6f);
    EXPECT_GT(filtered(0.5f, 0.5f), 0.25f);
}

TEST(PostFilter, WantsTotalAlpha)
{
    Options options;
    options.method = "stochastic";
    options.post_filter.cross_bilateral = true;
    EXPECT_THROW(render(load("builtin:layers"), centered_view(8, 4), options), Error);
}

}  // namespace sheer
