// The frames of one picture, and the passes of one frame, take their numbers from one sequence.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "methods/stochastic_fixture.h"
#include "support/random.h"

namespace sheer {

namespace {

constexpr std::uint32_t kKey = 0x0ddba11u;

// How many samples of each pixel one layer covers in these frames, of `count`.
std::vector<int> covered_in(const std::string& method, int samples, double alpha, int first,
                            int last, int count)
{
    DrivenTile tile(method, samples);
    std::vector<int> covered(kTilePixels);
    for (int number = first; number < last; ++number) {
        const TilePlace place{
            64, 32, hash_u32(static_cast<std::uint32_t>(number)), {kKey, number, count}};
        const SampleColors& colors = tile.draw({{alpha, {1, 0, 0}, 1}}, place);
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            const float* red = colors.channel(pixel, 0);
            covered[pixel] += static_cast<int>(std::count(red, red + samples, 1.0f));
        }
    }
    return covered;
}

// How far a pixel is from its share of the samples at most.
double worst(const std::vector<int>& covered, double share)
{
    double most = 0;
    for (const int count : covered) most = std::max(most, std::abs(count - share));
    return most;
}

const std::vector<std::string> kJoint = {
    "stratified-stochastic",
    "stratified-stochastic:sequence=vegdahl",
    "stratified-stochastic:sequence=systematic",
    "stochastic:masks=tracked",
    "stochastic:masks=systematic",
};

}  // namespace

// Floor or ceil of opacity times all their samples: over all frames, over the first 2^k of them,
// and over any 2^k that begin at a multiple of 2^k.
TEST(TrackedFrames, CoverWhatAsManySamplesInOneFrameDo)
{
    for (const std::string& method : kJoint) {
        for (const int samples : {1, 4, 8}) {
            for (const int frames : {2, 4, 16}) {
                for (const double alpha : {0.05, 0.3, 0.5, 0.61}) {
                    const double share = alpha * samples * frames;
                    EXPECT_LT(worst(covered_in(method, samples, alpha, 0, frames, frames), share),
                              1)
                        << method;
                    // The first of a picture of one more: 3, 5 or 17.
                    EXPECT_LT(
                        worst(covered_in(method, samples, alpha, 0, frames, frames + 1), share), 1);
                    EXPECT_LT(
                        worst(covered_in(method, samples, alpha, frames, 2 * frames, 4 * frames),
                              share),
                        1);
                }
            }
        }
    }
}

// A pixel has 1024 numbers; what comes after is a sequence of its own.
TEST(TrackedFrames, BeginAnewAfterManyNumbers)
{
    const double share = 0.3 * 64 * 16;
    for (const int first : {0, 16, 32}) {
        EXPECT_LT(worst(covered_in("stratified-stochastic", 64, 0.3, first, first + 16, 48), share),
                  1);
    }
}

// The same check finds frames that know nothing of one another: of 16 frames the number that round
// up has a deviation of 4 sqrt(f (1 - f)), f = 0.4, about 2.
TEST(TrackedFrames, IndependentOnesDoNot)
{
    for (const char* method : {"stratified-stochastic:frames=independent",
                               "stochastic:masks=tracked:pass-masks=independent"}) {
        EXPECT_GT(worst(covered_in(method, 8, 0.3, 0, 16, 16), 0.3 * 8 * 16), 3) << method;
    }
}

TEST(TrackedPasses, CoverWhatAsManySamplesInOnePassDo)
{
    const auto worst_of = [](const std::string& method, int passes) {
        DrivenTile tile(method + ":sample-passes=" + std::to_string(passes), 4);
        const SampleColors& colors = tile.draw({{0.3, {1, 0, 0}, 1}}, {64, 32, kKey});
        double most = 0;
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            double covered = 0;
            for (int s = 0; s < 4; ++s) {
                covered += static_cast<double>(colors.channel(pixel, 0)[s]) * passes;
            }
            most = std::max(most, std::abs(covered - 0.3 * 4 * passes));
        }
        return most;
    };
    for (const int passes : {2, 4, 8, 16}) {
        EXPECT_LT(worst_of("stochastic:masks=tracked", passes), 1);
        EXPECT_LT(worst_of("stochastic:masks=systematic", passes), 1);
    }
    EXPECT_GT(worst_of("stochastic:masks=tracked:pass-masks=independent", 16), 3);
}

// With random shadows frames are drawn one by one, which a layer that is unlit must not show, and
// so does every picture: floor or ceil of its samples.
TEST(TrackedFrames, ArePartsOfOneSequenceInEveryPicture)
{
    constexpr int kFrames = 8, kSamples = 4;
    const StochasticLayers layer = {{0.3, {1, 0, 0}, 1}};
    Image first;
    for (const ShadowKind shadows : {ShadowKind::none, ShadowKind::stochastic}) {
        View view = centered_view(64, kSamples);
        view.shadows.kind = shadows;
        view.shadows.size = 16;
        view.shadows.samples = 1;
        Options options;
        options.method = "stratified-stochastic";
        options.accumulate = kFrames;
        const Image image = render(scene_of(layer), view, options).image;
        for (const Float4& pixel : image.pixels) {
            const double covered = static_cast<double>(pixel[0]) * kFrames * kSamples;
            EXPECT_LT(std::abs(covered - 0.3 * kFrames * kSamples), 1 - 1e-4);
        }
        if (first.pixels.empty()) first = image;
        EXPECT_EQ(image.pixels, first.pixels);
    }
}

}  // namespace sheer
