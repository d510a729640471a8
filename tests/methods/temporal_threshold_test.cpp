// Thresholds that change from frame to frame: shaders/sheer/temporal_threshold.glsl against
// src/reference, and how often a fragment passes in a period. Confidence: statistics.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lanes/lone.h"
#include "methods/statistics.h"
#include "methods/stochastic_fixture.h"
#include "reference/hashed_threshold.h"

namespace sheer {
namespace {

using reference::StrataOrder;

template <class L>
struct ThresholdText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/hashed_threshold.glsl"
#include "sheer/temporal_threshold.glsl"
};
using InFloats = ThresholdText<Lone<float>>;
using InDoubles = ThresholdText<Lone<double>>;

constexpr std::pair<const char*, StrataOrder> kOrders[] = {
    {"linear", StrataOrder::linear},
    {"alternating", StrataOrder::alternating},
    {"van-der-corput", StrataOrder::van_der_corput}};

TEST(TemporalThreshold, StrataAreInTheOrderAskedFor)
{
    for (int n = 1; n <= 64; n *= 2) {
        for (int frame = 0; frame < 2 * n; ++frame) {
            for (int order = 0; order < 3; ++order) {
                const auto number = static_cast<std::uint32_t>(frame);
                EXPECT_EQ(static_cast<int>(InFloats::frame_stratum(number, n, order)),
                          reference::stratum(frame % n, n, kOrders[order].second))
                    << frame << " of " << n << ", order " << order;
            }
        }
    }
}

TEST(TemporalThreshold, TurnsAsEquation6Says)
{
    for (const double threshold : {1e-6, 0.1, 0.4999, 0.8, 0.99, 1.0}) {
        for (int stratum = 0; stratum < 8; ++stratum) {
            const double expected =
                std::max(reference::stratified_threshold(threshold, stratum, 8), 1e-6);
            EXPECT_NEAR(
                InDoubles::stratified_threshold(threshold, static_cast<std::uint32_t>(stratum), 8),
                expected, 1e-12)
                << threshold << ", " << stratum;
        }
    }
    // The threshold of no stratum is the fraction of the threshold itself.
    EXPECT_EQ(InFloats::stratified_threshold(0.3f, 0u, 1), 0.3f);
}

// A layer that fills a tile of places a cell apart, and how many samples of each pixel it keeps
// in each frame of two periods.
std::vector<std::vector<int>> kept_in_frames(const std::string& method, int samples, int period,
                                             double alpha)
{
    DrivenTile tile(method, samples);
    const auto put_places = [](FragmentStream& f) {
        for (int i = 0; i < f.size; ++i) {
            const auto x = static_cast<float>(f.pixel[i] % kTileSize);
            const auto y = static_cast<float>(f.pixel[i] / kTileSize);
            const float place[] = {x + 0.5f, y + 0.5f, 0.5f, 0.707f, 0, 0, 0, 0.707f, 0};
            for (std::size_t c = 0; c < 9; ++c) f.place[c][i] = place[c];
            f.level[i] = 0;
        }
    };
    std::vector<std::vector<int>> kept(kTilePixels);
    for (int frame = 0; frame < 2 * period; ++frame) {
        TilePlace place{0, 0, 1};
        place.film = {frame, period};
        const SampleColors& colors = tile.draw({{alpha, {1, 0, 0}, 1}}, place, put_places);
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            const float* red = colors.channel(pixel, 0);
            kept[pixel].push_back(
                static_cast<int>(std::count_if(red, red + samples, [](float r) { return r > 0; })));
        }
    }
    return kept;
}

int sum_of(const std::vector<int>& counts, int begin, int end)
{
    int sum = 0;
    for (int i = begin; i < end; ++i) sum += counts[static_cast<std::size_t>(i)];
    return sum;
}

// Pixels whose samples, over any period, are not as many as the opacity says to the next whole one.
int uneven_pixels(const std::vector<std::vector<int>>& kept, int period, double all)
{
    int uneven = 0;
    for (const std::vector<int>& counts : kept) {
        for (int begin = 0; begin < period; ++begin) {
            if (std::abs(sum_of(counts, begin, begin + period) - all) >= 1) {
                ++uneven;
                break;
            }
        }
    }
    return uneven;
}

TEST(TemporalThreshold, StrataPassAsOftenInAPeriodAsTheOpacitySays)
{
    for (const auto& [name, order] : kOrders) {
        for (const double alpha : {0.05, 0.3, 0.71}) {
            const std::string test = std::string("hashed-alpha-test:frames=") + name;
            EXPECT_EQ(uneven_pixels(kept_in_frames(test, 1, 8, alpha), 8, 8 * alpha), 0) << name;
            const std::string coverage = std::string("hashed-alpha-to-coverage:frames=") + name;
            EXPECT_EQ(uneven_pixels(kept_in_frames(coverage, 4, 8, alpha), 8, 32 * alpha), 0)
                << name;
        }
    }
    // What does not change, and what changes at random, is not so even.
    for (const char* frames : {"still", "offsets"}) {
        const std::string test = std::string("hashed-alpha-test:frames=") + frames;
        EXPECT_GT(uneven_pixels(kept_in_frames(test, 1, 8, 0.3), 8, 8 * 0.3), kTilePixels / 4);
    }
}

TEST(TemporalThreshold, AllFramesHaveTheOpacitysChanceAndComeAgain)
{
    constexpr int kPeriod = 8;
    for (const char* frames : {"offsets", "linear", "alternating", "van-der-corput"}) {
        const auto kept =
            kept_in_frames(std::string("hashed-alpha-test:frames=") + frames, 1, kPeriod, 0.3);
        std::vector<int> passing(kPeriod);
        for (const std::vector<int>& counts : kept) {
            for (std::size_t i = 0; i < kPeriod; ++i) {
                passing[i] += counts[i];
                ASSERT_EQ(counts[i], counts[i + kPeriod]) << frames << ", frame " << i;
            }
        }
        for (const int count : passing) EXPECT_TRUE(count_agrees(count, kTilePixels, 0.3));
    }
}

// Of independent frames, how many of 8 let a fragment pass has the binomial distribution.
TEST(TemporalThreshold, OffsetsAreIndependent)
{
    std::vector<int> passed;
    for (const auto& counts : kept_in_frames("hashed-alpha-test:frames=offsets", 1, 8, 0.5)) {
        passed.push_back(sum_of(counts, 0, 8));
    }
    std::vector<double> chances;
    for (const double ways : {1., 8., 28., 56., 70., 56., 28., 8., 1.})
        chances.push_back(ways / 256);
    expect_counts(passed, chances);
}

TEST(TemporalThreshold, NothingChangesThatIsStill)
{
    for (const char* method : {"hashed-alpha-test", "hashed-alpha-to-coverage"}) {
        EXPECT_FALSE(choose_method(method).traits().by_frame);
        EXPECT_TRUE(choose_method(std::string(method) + ":frames=linear").traits().by_frame);
        for (const auto& counts : kept_in_frames(method, 4, 2, 0.4)) {
            EXPECT_EQ(std::count(counts.begin(), counts.end(), counts[0]), 4);
        }
    }
}

}  // namespace
}  // namespace sheer
