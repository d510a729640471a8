// Stratified stochastic transparency: the store against the oracle, and what the paper promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "methods/make_lists.h"
#include "methods/statistics.h"
#include "methods/stochastic_fixture.h"
#include "methods/stratified_oracle.h"
#include "simd_levels.h"

namespace sheer::test {
namespace {

// The picture that the oracle's owners make, in the layout of SampleColors.
Words resolved_by_oracle(const FragmentLists& lists, const ChosenMethod& method)
{
    const StratifiedSettings settings = stratified_settings(method);
    SampleColors colors = make_backdrop(lists.set.count);
    for (std::uint32_t pixel = 0; pixel < kTilePixels; ++pixel) {
        const std::vector<int> owners = owners_by_oracle(lists, settings, pixel, lists.place.key);
        for (std::size_t s = 0; s < lists.samples(); ++s) {
            if (owners[s] < 0) continue;
            const ListedFragment& f =
                lists.fragments[lists.first[pixel] + static_cast<std::uint32_t>(owners[s])];
            const float color[] = {f.red, f.green, f.blue, 1};
            for (std::size_t c = 0; c < 4; ++c) colors.channel(pixel, c)[s] = color[c];
        }
    }
    return words_of(colors.values);
}

void expect_oracles_samples(const FragmentLists& lists, const std::string& text)
{
    const Words expected = resolved_by_oracle(lists, choose_method(text));
    for (const Simd level : simd_levels()) {
        EXPECT_EQ(difference(expected, resolved_by_store(lists, text, targets_of(level))), "")
            << text << " on " << lists.name << ", " << name_of_targets(targets_of(level));
    }
}

constexpr const char* kSwitches[] = {
    "",
    ":tracking=off",
    ":sort=off",
    ":compaction=off:sort=off",
    ":tracking=off:sort=off",
    ":tracking=off:compaction=off:sort=off",
    ":dither=none",
    ":dither=morton",
    ":sequence=vegdahl",
    ":sequence=sobol",
    ":sequence=random",
    ":sequence=systematic",
    ":sequence=systematic:compaction=off:sort=off",
};

TEST(StratifiedStore, TakesTheOraclesSamples)
{
    for (const int samples : {1, 2, 4, 8, 16, 32, 64}) {
        for (const FragmentLists& lists : random_lists(samples)) {
            for (const char* switches : kSwitches) {
                expect_oracles_samples(lists, std::string("stratified-stochastic") + switches);
            }
        }
    }
}

TEST(StratifiedStore, TakesTheOraclesSamplesOnARealTile)
{
    expect_oracles_samples(lists_of_fullest_tile(load("builtin:motor"), "motor", 16),
                           "stratified-stochastic");
}

// How many samples of a pixel have this colour in this channel.
int count_of(const SampleColors& colors, std::size_t pixel, std::size_t channel)
{
    const float* values = colors.channel(pixel, channel);
    return static_cast<int>(std::count(values, values + colors.samples, 1.0f));
}

// Red over green over blue, each opaque where it is.
const StochasticLayers kNear = {{0.5, {1, 0, 0}, 1}}, kFar = {{0.5, {0, 1, 0}, 2}};

StochasticLayers in_order(bool far_first)
{
    return {far_first ? kFar[0] : kNear[0], far_first ? kNear[0] : kFar[0]};
}

// Figure 5: how often the far layer has other than a quarter of the samples.
int unequal_pixels(const std::string& switches, bool far_first)
{
    DrivenTile tile("stratified-stochastic" + switches, 16);
    const SampleColors& colors = tile.draw(in_order(far_first), {64, 32, 77});
    int unequal = 0;
    for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
        unequal += count_of(colors, pixel, 1) != 4;
        EXPECT_TRUE(count_of(colors, pixel, 0) == 8);
    }
    return unequal;
}

TEST(StratifiedStore, FigureFive)
{
    EXPECT_EQ(unequal_pixels("", false), 0);
    EXPECT_EQ(unequal_pixels("", true), 0);
    EXPECT_EQ(unequal_pixels(":sort=off", false), 0);
    // 8 of 16 samples, of which the other layer has 8 at random, are 4 in 38 % of the pixels.
    EXPECT_GT(unequal_pixels(":sort=off", true), kTilePixels / 2);
    EXPECT_GT(unequal_pixels(":compaction=off:sort=off", false), kTilePixels / 2);
    EXPECT_GT(unequal_pixels(":compaction=off:sort=off", true), kTilePixels / 2);
}

TEST(StratifiedStore, OpaqueAlwaysCovers)
{
    for (const int samples : {1, 4, 64}) {
        DrivenTile tile("stratified-stochastic", samples);
        for (std::uint32_t key = 0; key < 8; ++key) {
            const SampleColors& colors = tile.draw({{1, {1, 0, 0}, 1}}, {0, 0, key});
            for (std::size_t p = 0; p < kTilePixels; ++p) {
                EXPECT_EQ(count_of(colors, p, 0), samples);
            }
        }
    }
}

// The tile at (32, 64) is a part of the picture, whatever else is drawn.
TEST(StratifiedStore, PixelsAreThoseOfThePictureInEveryTile)
{
    DrivenTile tile("stratified-stochastic", 8);
    int other = 0;
    for (const int x : {0, 32, 64}) {
        for (const int y : {0, 32, 64}) {
            const SampleColors& colors = tile.draw({{0.3, {1, 0, 0}, 1}}, {x, y, 5});
            for (std::uint32_t p = 0; p < kTilePixels; ++p) {
                const std::uint32_t index =
                    reference::hilbert_index(static_cast<std::uint32_t>(x) + p % kTileSize,
                                             static_cast<std::uint32_t>(y) + p / kTileSize, 16384);
                int expected = 0;
                for (std::uint32_t n = 0; n < 8; ++n) {
                    expected +=
                        reference::value_of_bits(reference::paper_bits(n, index, 5, 8)) < 0.3;
                }
                other += count_of(colors, p, 0) != expected;
            }
        }
    }
    EXPECT_EQ(other, 0);
}

// Threads and vectors do not show, although the order of the fragments does.
TEST(StratifiedStore, OneSeedOnePicture)
{
    const Scene scene = load("builtin:quads");
    View view;
    view.width = 80;
    view.height = 70;
    for (const int samples : {1, 8, 64}) {
        view.samples = samples;
        Options options;
        options.method = "stratified-stochastic";
        options.accumulate = 2;
        options.threads = 1;
        options.simd = Simd::scalar;
        const Image expected = render(scene, view, options).image;
        for (const Simd level : simd_levels()) {
            for (const int threads : {1, 2, 7}) {
                options.simd = level;
                options.threads = threads;
                EXPECT_EQ(render(scene, view, options).image.pixels, expected.pixels) << threads;
            }
        }
    }
}

}  // namespace
}  // namespace sheer::test
