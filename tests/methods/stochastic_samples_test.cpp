// Stochastic transparency at spread samples: the mean over many seeds is `exact`, pixel by pixel.
#include <gtest/gtest.h>

#include <cmath>

#include <sheer/sheer.h>

#include "methods/statistics.h"

namespace sheer {

namespace {

constexpr int kSize = 64, kBlock = 8;

// Sums over seeds for each pixel of white surfaces on black, which are one number.
struct SeedSums {
    double seeds = 0;
    std::vector<double> sum = std::vector<double>(kSize * kSize), square = sum;

    void add(const Image& image)
    {
        seeds += 1;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            const auto value = static_cast<double>(image.pixels[i][0]);
            sum[i] += value;
            square[i] += value * value;
        }
    }
    double mean(std::size_t i) const { return sum[i] / seeds; }
    double variance(std::size_t i) const
    {
        return std::max(0.0, (square[i] - sum[i] * sum[i] / seeds) / (seeds - 1));
    }
};

View spread_view(int samples)
{
    View view;
    view.width = view.height = kSize;
    view.samples = samples;
    return view;
}

SeedSums sums_over_seeds(const Scene& scene, int samples, int seeds)
{
    Options options;
    options.method = "stochastic";
    SeedSums sums;
    for (int seed = 0; seed < seeds; ++seed) {
        options.seed = static_cast<std::uint64_t>(seed);
        sums.add(render(scene, spread_view(samples), options).image);
    }
    return sums;
}

// Of the mean over the pixels of a block. The variance is estimated from the same pictures, and too
// small where something rare has not happened: a Poisson number k has, at this confidence, a mean
// of up to k + z sqrt(k) + z^2. One sample is 1 / S of a pixel.
testing::AssertionResult block_agrees(const SeedSums& sums, const Image& truth, int samples,
                                      const std::vector<std::size_t>& block)
{
    double difference = 0, variance = 0;
    const auto pixels = static_cast<double>(block.size());
    for (const std::size_t i : block) {
        difference += (sums.mean(i) - static_cast<double>(truth.pixels[i][0])) / pixels;
        variance += sums.variance(i) / sums.seeds / (pixels * pixels);
    }
    const double rare = kZ * kZ / (samples * sums.seeds * pixels);
    return verdict(difference, kZ * std::sqrt(variance) + rare + kPixelRounding, "the mean");
}

std::vector<std::size_t> pixels_of_block(int x0, int y0, int size)
{
    std::vector<std::size_t> pixels;
    for (int y = y0; y < y0 + size; ++y) {
        for (int x = x0; x < x0 + size; ++x)
            pixels.push_back(static_cast<std::size_t>(y * kSize + x));
    }
    return pixels;
}

// Counts the blocks of this size that disagree, each of which a picture has.
int disagreeing_blocks(const SeedSums& sums, const Image& truth, int samples, int size)
{
    int count = 0;
    for (int y = 0; y < kSize; y += size) {
        for (int x = 0; x < kSize; x += size) {
            if (!block_agrees(sums, truth, samples, pixels_of_block(x, y, size))) ++count;
        }
    }
    return count;
}

}  // namespace

class StochasticSpreadSamples : public testing::TestWithParam<int> {};

// Ramps, split quads and stacks of tilted quads that cut one another.
TEST_P(StochasticSpreadSamples, TheMeanOverSeedsIsExact)
{
    const int samples = GetParam();
    Scene scene = load("builtin:quads?split=8");
    const SeedSums sums = sums_over_seeds(scene, samples, 200);
    const Image truth = render(scene, spread_view(samples), {}).image;
    for (int size = 1; size <= kSize; size *= kBlock) {
        EXPECT_EQ(disagreeing_blocks(sums, truth, samples, size), 0) << "blocks of " << size;
    }
    // An opacity of 0.99 of what it should be is found.
    scene.materials[0].opacity = 0.99f;
    const Image fainter = render(scene, spread_view(samples), {}).image;
    EXPECT_EQ(disagreeing_blocks(sums, fainter, samples, kSize), 1);
}

INSTANTIATE_TEST_SUITE_P(SampleCounts, StochasticSpreadSamples, testing::Values(4, 8));

}  // namespace sheer
