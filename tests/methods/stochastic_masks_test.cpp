// The masks of stochastic transparency: every choice of samples alike, and nothing in common
// between pixels, seeds and layers. Confidence: statistics.h.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <map>

#include <sheer/sheer.h>

#include "cpu/frame.h"
#include "methods/statistics.h"
#include "methods/stochastic_fixture.h"

namespace sheer {

namespace {

using reference::Masks;

constexpr int kTiles = 16;
constexpr double kTrials = kTiles * kTilePixels;

// Of one red layer, pixel after pixel.
std::vector<std::uint64_t> masks_of(DrivenTile& tile, int samples, const StochasticLayer& layer,
                                    std::uint32_t id)
{
    const auto with_id = [id](FragmentStream& f) { f.runs[0].primitive = f.runs[0].object = id; };
    std::vector<std::uint64_t> masks;
    for (int i = 0; i < kTiles; ++i) {
        const SampleColors& colors = tile.draw({layer}, {32 * i, 0, 0xabcdefu}, with_id);
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            std::uint64_t mask = 0;
            for (int s = 0; s < samples; ++s) {
                if (colors.channel(pixel, 0)[s] > 0) mask |= std::uint64_t{1} << s;
            }
            masks.push_back(mask);
        }
    }
    return masks;
}

double choose(int n, int k)
{
    if (k < 0 || k > n) return 0;
    double result = 1;
    for (int i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
    return result;
}

// Probabilities of a mask's number of samples.
std::vector<double> count_chances(Masks masks, int samples, double alpha)
{
    std::vector<double> chances(static_cast<std::size_t>(samples) + 1);
    const double expected = alpha * samples;
    for (int r = 0; r <= samples; ++r) {
        double& chance = chances[static_cast<std::size_t>(r)];
        if (masks == Masks::naive) {
            chance = choose(samples, r) * std::pow(alpha, r) * std::pow(1 - alpha, samples - r);
        } else {
            chance = std::max(0.0, 1 - std::abs(expected - r));
        }
    }
    return chances;
}

// Of the number of samples that the masks of two layers share: hypergeometric for each pair of
// sizes, whatever these are.
std::vector<double> overlap_chances(const std::vector<double>& first,
                                    const std::vector<double>& second)
{
    const int samples = static_cast<int>(first.size()) - 1;
    std::vector<double> chances(first.size());
    for (int a = 0; a <= samples; ++a) {
        for (int b = 0; b <= samples; ++b) {
            const double both =
                first[static_cast<std::size_t>(a)] * second[static_cast<std::size_t>(b)];
            for (int h = 0; h <= a; ++h) {
                chances[static_cast<std::size_t>(h)] +=
                    both * choose(a, h) * choose(samples - a, b - h) / choose(samples, b);
            }
        }
    }
    return chances;
}

Image red_over_green_picture(std::uint32_t key)
{
    const Take take{choose_method("stochastic"), {key}};
    return render_takes(scene_of(red_over_green()), centered_view(256, 8), {}, {{&take, 1}})
        .frames.front()
        .image;
}

}  // namespace

// 70 choices of 4 of 8.
TEST(StochasticMasks, EveryChoiceOfHalfOfTheSamplesIsAlike)
{
    DrivenTile tile("stochastic", 8);
    std::map<std::uint64_t, double> counts;
    for (const std::uint64_t mask : masks_of(tile, 8, {0.5, {1, 0, 0}, 1}, 0)) counts[mask] += 1;
    EXPECT_EQ(counts.size(), 70u);
    for (const auto& [mask, count] : counts) {
        EXPECT_EQ(std::popcount(mask), 4);
        EXPECT_TRUE(count_agrees(count, kTrials, 1.0 / 70)) << mask;
    }
}

TEST(StochasticMasks, EverySampleIsTakenWithTheOpacitysProbability)
{
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        for (const int samples : {1, 2, 4, 8, 16, 32, 64}) {
            DrivenTile tile(method_with(masks), samples);
            for (const double alpha : {0.003, 0.45, 0.9}) {
                SCOPED_TRACE(std::string(name_of(masks)) + ", S = " + std::to_string(samples) +
                             ", opacity " + std::to_string(alpha));
                std::vector<double> counts(static_cast<std::size_t>(samples));
                std::vector<int> sizes;
                for (const std::uint64_t mask : masks_of(tile, samples, {alpha, {1, 0, 0}, 1}, 5)) {
                    sizes.push_back(std::popcount(mask));
                    for (std::size_t s = 0; s < counts.size(); ++s) {
                        counts[s] += static_cast<double>(mask >> s & 1);
                    }
                }
                for (std::size_t s = 0; s < counts.size(); ++s) {
                    EXPECT_TRUE(count_agrees(counts[s], kTrials, alpha)) << "sample " << s;
                }
                expect_counts(sizes, count_chances(masks, samples, alpha));
            }
        }
    }
}

TEST(StochasticMasks, TwoLayersOverlapAsChanceWillHaveIt)
{
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        DrivenTile tile(method_with(masks), 8);
        for (const auto& [first, second] :
             {std::pair(0.5, 0.5), std::pair(0.45, 0.45), std::pair(0.3, 0.8)}) {
            SCOPED_TRACE(std::string(name_of(masks)) + ", opacities " + std::to_string(first) +
                         " and " + std::to_string(second));
            const auto one = masks_of(tile, 8, {first, {1, 0, 0}, 1}, 10);
            // Two ids are one triangle's and its neighbour's, the next object's, a far one's.
            for (const std::uint32_t id : {11u, 12u, 1000003u}) {
                const auto other = masks_of(tile, 8, {second, {1, 0, 0}, 2}, id);
                std::vector<int> overlaps;
                for (std::size_t i = 0; i < one.size(); ++i) {
                    overlaps.push_back(std::popcount(one[i] & other[i]));
                }
                expect_counts(overlaps, overlap_chances(count_chances(masks, 8, first),
                                                        count_chances(masks, 8, second)));
            }
        }
    }
}

// The example of the paper: half of 8 samples and half of 8 samples.
TEST(StochasticMasks, OverlapsOfTwoHalvesAreHypergeometric)
{
    const auto half = count_chances(Masks::stratified, 8, 0.5);
    const auto chances = overlap_chances(half, half);
    for (int h = 0; h <= 4; ++h) {
        EXPECT_NEAR(chances[static_cast<std::size_t>(h)], choose(4, h) * choose(4, h) / 70, 1e-15);
    }
}

TEST(StochasticMasks, NeighbouringPixelsHaveNothingInCommon)
{
    const Image image = red_over_green_picture(frame_key(1, 0));
    for (const Offset offset :
         {Offset{1, 0}, Offset{0, 1}, Offset{1, 1}, Offset{2, 0}, Offset{0, 2}, Offset{32, 0},
          Offset{0, 32}, Offset{32, 32}, Offset{128, 64}}) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_TRUE(pixels_uncorrelated(image, c, offset))
                << offset.x << ", " << offset.y << ", channel " << c;
        }
    }
}

TEST(StochasticMasks, SeedsHaveNothingInCommon)
{
    const Image image = red_over_green_picture(frame_key(1, 0));
    // Neighbours, a neighbouring picture of the same seed, seeds alike in their lower halves; and
    // neighbouring keys, for those who choose them.
    for (const std::uint32_t key : {frame_key(0, 0), frame_key(2, 0), frame_key(1, 1),
                                    frame_key(1ull << 32 | 1, 0), frame_key(1, 0) + 1}) {
        const Image other = red_over_green_picture(key);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_TRUE(uncorrelated(channel_of(image, c), channel_of(other, c)))
                << "channel " << c;
        }
    }
}

}  // namespace sheer
