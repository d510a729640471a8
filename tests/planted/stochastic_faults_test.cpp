// Faults planted in stochastic transparency: the checks of its tests (methods/statistics.h) must
// find each of them, and must pass what has none.
#include <gtest/gtest.h>

#include <cmath>

#include "methods/statistics.h"
#include "methods/stochastic_fixture.h"

namespace sheer {

namespace {

using reference::Masks;

constexpr int kSamples = 16;
constexpr int kSize = 192;  // 36,864 pixels: an opacity 0.5 % off moves the mean 17 deviations

struct Experiment {
    StochasticLayers layers = red_over_green();
    DrivenTile::Fault fault = {};
    std::string method = "stochastic";
    bool places = true;  // false: every tile is taken for the first
    bool pixels = true;  // false: every pixel is a copy of the first
};

Image perform(const Experiment& experiment)
{
    DrivenTile tile(experiment.method, kSamples);
    Image image = tile.draw_picture(experiment.layers, kSize, experiment.fault, [&](int x, int y) {
        return experiment.places ? TilePlace{x, y, 99} : TilePlace{0, 0, 99};
    });
    if (!experiment.pixels) std::fill(image.pixels.begin(), image.pixels.end(), image.pixels[0]);
    return image;
}

// Which checks hold, in all channels.
struct Verdicts {
    bool mean = true, variance = true, neighbours = true, tiles = true;
};

// Against what stratified masks without a fault give.
Verdicts judge(const Experiment& experiment)
{
    const Image image = perform(experiment);
    const auto expected = moments_of(experiment.layers, Masks::stratified, kSamples);
    Verdicts verdicts;
    for (std::size_t c = 0; c < 3; ++c) {
        const Observed observed = observe(channel_of(image, c));
        verdicts.mean &= bool(mean_agrees(observed, expected[c]));
        verdicts.variance &= bool(variance_agrees(observed, expected[c]));
        if (is_constant(expected[c])) continue;
        for (const Offset offset : {Offset{1, 0}, Offset{0, 1}}) {
            verdicts.neighbours &= bool(pixels_uncorrelated(image, c, offset));
        }
        for (const Offset offset : {Offset{kTileSize, 0}, Offset{0, kTileSize}}) {
            verdicts.tiles &= bool(pixels_uncorrelated(image, c, offset));
        }
    }
    return verdicts;
}

// Each opacity `a` becomes change(a).
DrivenTile::Fault opacities(float (*change)(float))
{
    return [change](FragmentStream& f) {
        for (int i = 0; i < f.size; ++i) f.opacity[i] = change(f.opacity[i]);
    };
}

StochasticLayers coincident()
{
    return {{0.45, {1, 0, 0}, 1}, {0.45, {0, 1, 0}, 1}};
}

}  // namespace

TEST(PlantedInStochastic, NoFault)
{
    for (const StochasticLayers& layers : {red_over_green(), coincident()}) {
        const Verdicts verdicts = judge({layers});
        EXPECT_TRUE(verdicts.mean && verdicts.variance && verdicts.neighbours && verdicts.tiles);
    }
}

TEST(PlantedInStochastic, OpacityInEightBitsRoundedDown)
{
    const auto down = [](float a) { return std::floor(a * 255) / 255; };
    EXPECT_FALSE(judge({red_over_green(), opacities(down)}).mean);
}

TEST(PlantedInStochastic, OpacityHalfAPercentTooLarge)
{
    const auto up = [](float a) { return 1.005f * a; };
    EXPECT_FALSE(judge({red_over_green(), opacities(up)}).mean);
}

TEST(PlantedInStochastic, OneSampleIsNeverCovered)
{
    const DrivenTile::Fault drop = [](FragmentStream& f) {
        for (int i = 0; i < f.size; ++i) f.samples[i] &= ~(1u << 3);
    };
    EXPECT_FALSE(judge({red_over_green(), drop}).mean);
}

TEST(PlantedInStochastic, TheTieGoesToTheLargerId)
{
    const DrivenTile::Fault exchange = [](FragmentStream& f) {
        std::swap(f.runs[0].primitive, f.runs[1].primitive);
    };
    EXPECT_FALSE(judge({coincident(), exchange}).mean);
    EXPECT_TRUE(judge({red_over_green(), exchange}).mean) << "no tie, no fault";
}

TEST(PlantedInStochastic, NaiveMasksAreNotStratified)
{
    const Verdicts verdicts = judge({red_over_green(), {}, "stochastic:masks=naive"});
    EXPECT_TRUE(verdicts.mean);
    EXPECT_FALSE(verdicts.variance);
}

TEST(PlantedInStochastic, OneMaskForAllFragmentsOfAPixel)
{
    const DrivenTile::Fault merge = [](FragmentStream& f) { f.runs[1].object = f.runs[0].object; };
    EXPECT_FALSE(judge({red_over_green(), merge, "stochastic:seed-by=object"}).mean);
}

TEST(PlantedInStochastic, OneSeedForAllPixels)
{
    const Verdicts verdicts = judge({red_over_green(), {}, "stochastic", true, false});
    EXPECT_FALSE(verdicts.variance);
    EXPECT_FALSE(verdicts.neighbours);
}

TEST(PlantedInStochastic, OneSeedForAllTiles)
{
    EXPECT_FALSE(judge({red_over_green(), {}, "stochastic", false}).tiles);
}

}  // namespace sheer
