// Stratified stochastic transparency is right on average over frames, in whatever order fragments
// arrive; and what its curve does to pixels that lie side by side.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "methods/statistics.h"
#include "methods/stochastic_fixture.h"
#include "reference/stratified_listing.h"
#include "support/random.h"

namespace sheer {

namespace {

constexpr int kFrames = 100;

// A frame's random key.
std::uint32_t key_of(int frame)
{
    return hash_u32(static_cast<std::uint32_t>(frame) + 0x51ab5u);
}

// The mean colour of a frame's even and of its odd rows: pixels of one frame are not independent,
// frames are.
using FrameMeans = std::array<std::vector<double>, 6>;

void add_frame(FrameMeans& means, const SampleColors& colors)
{
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t odd = 0; odd < 2; ++odd) {
            double sum = 0;
            for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
                if (pixel / kTileSize % 2 != odd) continue;
                for (int s = 0; s < colors.samples; ++s) {
                    sum += static_cast<double>(colors.channel(pixel, c)[s]);
                }
            }
            means[2 * c + odd].push_back(sum / (kTilePixels / 2 * colors.samples));
        }
    }
}

// The variance is estimated from the same frames, and too small where something rare has not
// happened: a Poisson number k has, at this confidence, a mean of up to k + z sqrt(k) + z^2.
testing::AssertionResult frames_agree(const FrameMeans& means, reference::Rgba exact, int samples)
{
    const double truth[] = {exact.r, exact.g, exact.b};
    for (std::size_t i = 0; i < means.size(); ++i) {
        const Observed observed = observe(means[i]);
        const double rare = kZ * kZ / (kTilePixels / 2 * samples * observed.count);
        const auto agrees =
            verdict(observed.mean - truth[i / 2],
                    kZ * std::sqrt(observed.variance / observed.count) + rare + kPixelRounding,
                    i % 2 == 0 ? "the mean of the even rows" : "the mean of the odd rows");
        if (!agrees) return agrees;
    }
    return testing::AssertionSuccess();
}

FrameMeans frames_of(const std::string& method, int samples, const StochasticLayers& layers,
                     const DrivenTile::Fault& fault = {})
{
    DrivenTile tile(method, samples);
    FrameMeans means;
    for (int frame = 0; frame < kFrames; ++frame) {
        add_frame(means, tile.draw(layers, {64, 32, key_of(frame)}, fault));
    }
    return means;
}

reference::Rgba exact_of(const StochasticLayers& layers)
{
    return reference::composite(fragments_of(layers),
                                {static_cast<double>(kBehind[0]), static_cast<double>(kBehind[1]),
                                 static_cast<double>(kBehind[2]), 1});
}

// Near to far; no two of one colour.
StochasticLayers stack_of(std::size_t count)
{
    constexpr double kAlphas[] = {0.3, 0.45, 0.2, 0.61, 0.1, 0.37, 0.25, 0.55};
    StochasticLayers layers;
    for (std::size_t i = 0; i < count; ++i) {
        const auto quarter = [&](std::size_t by) {
            return 0.25f * static_cast<float>((i * by + by) % 5);
        };
        layers.push_back(
            {kAlphas[i], {quarter(1), quarter(2), quarter(3)}, 1 + static_cast<double>(i)});
    }
    return layers;
}

std::vector<StochasticLayers> orders_of(const StochasticLayers& layers)
{
    std::vector<StochasticLayers> orders(3, layers);
    std::reverse(orders[1].begin(), orders[1].end());
    std::mt19937 random(static_cast<unsigned>(layers.size()));
    std::shuffle(orders[2].begin(), orders[2].end(), random);
    return orders;
}

// A surface that is drawn in pieces, which are of one depth.
DrivenTile::Fault piece(std::vector<std::uint32_t> samples)
{
    return [samples = std::move(samples)](FragmentStream& f) {
        for (int r = 0; r < f.run_count; ++r) {
            const FragmentRun& run = f.runs[r];
            for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
                f.samples[i] &= samples[static_cast<std::size_t>(r)];
            }
        }
    };
}

// The values of the frame with a key, which a planted fault may spoil.
using ValuesOf = std::function<reference::AlphaReference(std::uint32_t key)>;

// The oracle's frames of a few pixels, as `frames_agree` wants them.
FrameMeans frames_of_oracle(const ValuesOf& values, reference::StratifiedSwitches switches,
                            int samples, const StochasticLayers& layers)
{
    std::vector<reference::PixelFragment> fragments;
    for (const StochasticLayer& layer : layers) {
        reference::PixelFragment fragment;
        fragment.covered = (1ull << samples) - 1;
        fragment.depth.fill(layer.depth);
        fragment.opacity = static_cast<double>(static_cast<float>(layer.alpha));
        fragment.id = static_cast<std::uint32_t>(fragments.size());
        fragments.push_back(fragment);
    }
    FrameMeans means;
    SampleColors colors(samples);
    for (int frame = 0; frame < kFrames; ++frame) {
        for (std::uint32_t pixel = 0; pixel < kTilePixels; ++pixel) {
            const auto owners = reference::stratified_owners(
                fragments, {samples, pixel % 64, key_of(frame), values(key_of(frame)), switches});
            for (std::size_t s = 0; s < owners.size(); ++s) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const auto owner = static_cast<std::size_t>(owners[s]);
                    colors.channel(pixel, c)[s] =
                        owners[s] < 0 ? kBehind[c] : layers[owner].color[c];
                }
            }
        }
        add_frame(means, colors);
    }
    return means;
}

}  // namespace

class StratifiedBias : public testing::TestWithParam<int> {};

TEST_P(StratifiedBias, TheMeanOverFramesIsExactInEveryOrder)
{
    for (std::size_t count = 2; count <= 8; ++count) {
        const StochasticLayers layers = stack_of(count);
        for (const StochasticLayers& order : orders_of(layers)) {
            const FrameMeans means = frames_of("stratified-stochastic", GetParam(), order);
            EXPECT_TRUE(frames_agree(means, exact_of(layers), GetParam())) << count << " layers";
        }
    }
}

TEST_P(StratifiedBias, TheMeanOverFramesIsExactWithEverySwitch)
{
    const StochasticLayers layers = stack_of(5);
    for (const char* switches :
         {":tracking=off", ":sort=off", ":compaction=off:sort=off", ":dither=none",
          ":dither=morton", ":sequence=vegdahl", ":sequence=random", ":sequence=systematic"}) {
        for (const StochasticLayers& order : orders_of(layers)) {
            const std::string method = std::string("stratified-stochastic") + switches;
            EXPECT_TRUE(
                frames_agree(frames_of(method, GetParam(), order), exact_of(layers), GetParam()))
                << method;
        }
    }
}

// A, B, A: the second piece of A is taken for a third surface, which costs noise alone.
TEST_P(StratifiedBias, ASurfaceThatIsTakenUpAgainIsNotBiased)
{
    const StochasticLayers two = stack_of(2);
    for (const bool near_first : {false, true}) {
        const StochasticLayer &a = two[near_first ? 0 : 1], &b = two[near_first ? 1 : 0];
        const FrameMeans means = frames_of("stratified-stochastic", GetParam(), {a, b, a},
                                           piece({0x5555u, 0xffffu, 0xaaaau}));
        EXPECT_TRUE(frames_agree(means, exact_of(two), GetParam()));
    }
}

// U, of one pass and of several.
TEST_P(StratifiedBias, OfTheDepthBasedMethodTheMeanIsExactToo)
{
    const StochasticLayers layers = stack_of(5);
    for (const char* parameters :
         {"tracked:depth-based=on", "systematic:depth-based=on", "tracked:sample-passes=2",
          "tracked:depth-based=on:sample-passes=3"}) {
        for (const StochasticLayers& order : orders_of(layers)) {
            const std::string method = std::string("stochastic:masks=") + parameters;
            EXPECT_TRUE(
                frames_agree(frames_of(method, GetParam(), order), exact_of(layers), GetParam()))
                << method;
        }
    }
}

// Frames of one picture know of one another, pictures don't.
TEST_P(StratifiedBias, NorAreJointFramesBiased)
{
    constexpr int kFramesOfPicture = 4;
    const StochasticLayers layers = stack_of(4);
    for (const char* method : {"stratified-stochastic", "stochastic:masks=systematic"}) {
        DrivenTile tile(method, GetParam());
        FrameMeans pictures;
        for (int picture = 0; picture < kFrames; ++picture) {
            FrameMeans frames;
            for (int i = 0; i < kFramesOfPicture; ++i) {
                add_frame(frames,
                          tile.draw(layers, {64, 32, 0, {key_of(picture), i, kFramesOfPicture}}));
            }
            for (std::size_t i = 0; i < pictures.size(); ++i) {
                pictures[i].push_back(observe(frames[i]).mean);
            }
        }
        EXPECT_TRUE(frames_agree(pictures, exact_of(layers), GetParam())) << method;
    }
}

INSTANTIATE_TEST_SUITE_P(SampleCounts, StratifiedBias, testing::Values(4, 8, 16));

// The same check finds layers that know of one another.
TEST(PlantedInStratified, LayersThatKnowOfOneAnotherAreFound)
{
    constexpr int kSamples = 8;
    const StochasticLayers layers = stack_of(3);
    const auto value = [](std::uint32_t number, std::uint32_t pixel, std::uint32_t surface) {
        return reference::value_of_bits(reference::paper_bits(number, pixel, surface, kSamples));
    };
    const auto right = [&](std::uint32_t) -> reference::AlphaReference { return value; };
    // The surface's id is never advanced: the layers get the same values.
    const auto stuck = [&](std::uint32_t key) -> reference::AlphaReference {
        return [&value, key](std::uint32_t number, std::uint32_t pixel, std::uint32_t) {
            return value(number, pixel, key);
        };
    };
    // Nor are the samples' numbers mixed.
    constexpr reference::StratifiedSwitches kByIndex = {true, false, false};
    EXPECT_TRUE(frames_agree(frames_of_oracle(right, kByIndex, kSamples, layers), exact_of(layers),
                             kSamples));
    EXPECT_FALSE(frames_agree(frames_of_oracle(stuck, kByIndex, kSamples, layers), exact_of(layers),
                              kSamples));
    // Sobol's sequence, as a user may choose it.
    const StochasticLayers thin(8, {0.1, {1, 1, 1}, 1});
    EXPECT_FALSE(frames_agree(frames_of("stratified-stochastic:sequence=sobol", kSamples, thin),
                              exact_of(thin), kSamples));
    EXPECT_TRUE(
        frames_agree(frames_of("stratified-stochastic", kSamples, thin), exact_of(thin), kSamples));
}

// In the first pass of the depth-based method opacities 5 % too small: more is seen than there is.
TEST(PlantedInStratified, DepthsOfFainterFragmentsAreFound)
{
    const StochasticLayers layers = stack_of(5);
    int pass = 0;
    const DrivenTile::Fault none;
    const DrivenTile::Fault fainter = [&](FragmentStream& f) {
        if (pass++ % 2 != 0) return;
        for (int i = 0; i < f.size; ++i) f.opacity[i] *= 0.95f;
    };
    const char* method = "stochastic:masks=tracked:depth-based=on";
    EXPECT_TRUE(frames_agree(frames_of(method, 8, layers, none), exact_of(layers), 8));
    EXPECT_FALSE(frames_agree(frames_of(method, 8, layers, fainter), exact_of(layers), 8));
}

// However many pieces a surface is drawn in, it covers floor or ceil of opacity times S.
TEST(StratifiedPieces, CoverWhatTheWholeDoes)
{
    std::mt19937 random(17);
    std::uint32_t key = 1;
    for (const int samples : {4, 8, 16}) {
        for (const std::size_t pieces : {1u, 2u, 3u, 5u, 16u}) {
            for (const double alpha : {0.1, 0.3, 0.5, 0.61}) {
                DrivenTile tile("stratified-stochastic", samples);
                std::vector<std::uint32_t> masks(pieces);
                for (int s = 0; s < samples; ++s) masks[random() % pieces] |= 1u << s;
                const StochasticLayers layers(pieces, {alpha, {1, 1, 0}, 1});
                const SampleColors& colors =
                    tile.draw(layers, {0, 0, hash_u32(key++)}, piece(masks));
                for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
                    const float* red = colors.channel(pixel, 0);
                    const auto covered = static_cast<double>(std::count(red, red + samples, 1.0f));
                    ASSERT_LT(std::abs(covered - alpha * samples), 1);
                }
            }
        }
    }
}

// Of one sample and opacity 0.5 one pixel of two that follow on the curve is covered. Morton's
// curve has them side by side in rows, so that rows are all alike; Hilbert's as often one above the
// other.
TEST(StratifiedCurves, MortonsTellsRowsFromColumns)
{
    const auto deviations = [](const std::string& dither) {
        DrivenTile tile("stratified-stochastic:dither=" + dither, 1);
        double of_rows = 0, of_columns = 0;
        for (int frame = 0; frame < kFrames; ++frame) {
            const SampleColors& colors = tile.draw({{0.5, {1, 0, 0}, 1}}, {0, 0, key_of(frame)});
            double rows[kTileSize] = {}, columns[kTileSize] = {};
            for (std::size_t p = 0; p < kTilePixels; ++p) {
                const auto red = static_cast<double>(colors.channel(p, 0)[0]);
                rows[p / kTileSize] += red - 0.5;
                columns[p % kTileSize] += red - 0.5;
            }
            for (int i = 0; i < kTileSize; ++i) {
                of_rows += rows[i] * rows[i];
                of_columns += columns[i] * columns[i];
            }
        }
        return std::pair(of_rows, of_columns);
    };
    const auto [morton_rows, morton_columns] = deviations("morton");
    EXPECT_EQ(morton_rows, 0);
    EXPECT_GT(morton_columns, 0);
    // Sums of 128 x 32 squares of numbers with 32 terms: a ratio's deviation is below
    // sqrt(2 * 2 / 4096) = 0.03 if rows were independent; five of a deviation twice as large.
    const auto [rows, columns] = deviations("hilbert");
    EXPECT_NEAR(rows / columns, 1, 0.3);
}

}  // namespace sheer
