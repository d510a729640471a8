// What the depth-based method keeps for a pixel is what it would keep for its samples.
#include <gtest/gtest.h>

#include "methods/tile_fixture.h"

namespace sheer {

namespace {

constexpr int kPlates = 20;

template <int Channels>
double mean(const SampleValues<Channels>& values, std::size_t pixel, std::size_t channel)
{
    double sum = 0;
    for (int s = 0; s < values.samples; ++s) sum += double{values.channel(pixel, channel)[s]};
    return sum / values.samples;
}

struct Pair {
    SampleColors of_samples, of_pixels;
};

Pair resolve_both(const char* method, int samples, std::uint32_t seed)
{
    std::mt19937 random(seed);
    const SampleSet set = make_sample_set(samples, SamplePositions::standard);
    const Plates plates = RandomPlates{set, random}.make(kPlates);
    const Colors backdrop = random_backdrop(set, random);
    const auto resolve = [&](bool filter_mixes_pixels) {
        Setting setting{choose_method(method), &set};
        setting.filter_mixes_pixels = filter_mixes_pixels;
        Tile tile(setting);
        tile.insert(plates);
        return tile.resolve_samples(backdrop);
    };
    return {resolve(true), resolve(false)};
}

// Either sum has at most 2 kPlates additions of numbers that are not negative (two passes of
// samples), a product in each and the mean over 64 samples at most (six additions) after it, and
// one of the two counts its terms together: relative errors of 2 kPlates + 8 halves of an epsilon
// each. A colour is at most kPlates, and its background is added once more.
constexpr double kRelative = 2 * (2 * kPlates + 9) * 0x1p-24;

class StochasticDepthAtSamples : public testing::TestWithParam<int> {};

TEST_P(StochasticDepthAtSamples, ASumOfThePixelIsTheMeanOfItsSamplesSums)
{
    double greatest = 0;
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        const Pair both = resolve_both("stochastic:depth-based=on:correction=on", GetParam(), seed);
        for (std::size_t i = 0; i < kUsedPixels; ++i) {
            for (std::size_t c = 0; c < 5; ++c) {
                const double one = mean(both.of_samples.fraction, tile_pixel(i), c);
                const double other = mean(both.of_pixels.fraction, tile_pixel(i), c);
                EXPECT_LE(std::abs(one - other), kRelative * one) << "channel " << c;
                greatest = std::max(greatest, one);
            }
        }
    }
    EXPECT_GT(greatest, 0.5);
}

TEST_P(StochasticDepthAtSamples, SoIsThePictureOfTheUncorrected)
{
    const char* const method =
        "stochastic:depth-based=on:sample-passes=2:pass-masks=independent:masks=naive";
    for (std::uint32_t seed = 11; seed <= 18; ++seed) {
        const Pair both = resolve_both(method, GetParam(), seed);
        for (std::size_t i = 0; i < kUsedPixels; ++i) {
            for (std::size_t c = 0; c < 4; ++c) {
                const double one = mean(both.of_samples, tile_pixel(i), c);
                const double other = mean(both.of_pixels, tile_pixel(i), c);
                EXPECT_LE(std::abs(one - other), kRelative * (one + 1)) << "channel " << c;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(SampleCounts, StochasticDepthAtSamples,
                         testing::Values(1, 2, 4, 8, 16, 32, 64));

}  // namespace

}  // namespace sheer
