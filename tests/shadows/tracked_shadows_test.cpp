// Shadow maps whose masks are stratified over texels, layers and frames: what that promises
// exactly, and that it is right on average (methods/statistics.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "methods/statistics.h"
#include "shadows/maps.h"
#include "shadows/sheets.h"

namespace sheer {

namespace {

using test::lit_parts, test::suns_map;

const std::vector<float> kOpacities = {0.3f, 0.5f, 0.2f, 0.6f};
constexpr ShadowMasks kTracked[] = {ShadowMasks::tracked, ShadowMasks::systematic};

Shadows shadows_with(ShadowMasks masks, int samples)
{
    Shadows shadows = test::stochastic_shadows(samples, 1);
    shadows.masks = masks;
    return shadows;
}

// Between the sheets; 0: above the highest.
double height_behind(std::size_t sheets)
{
    return static_cast<double>(kOpacities.size() - sheets) + 0.75;
}

// The farthest of `values` from `middle`.
double farthest_from(double middle, const std::vector<double>& values)
{
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value - middle));
    return most;
}

// Samples that one sheet took of each texel.
std::vector<double> taken_of_texels(const ShadowMap& map)
{
    std::vector<double> taken = lit_parts(map, 0.5);
    for (double& part : taken) part = (1 - part) * map.samples;
    return taken;
}

constexpr int kBlock = 8;  // texels, of which there are an even number in the map

// Samples that one sheet took of each block of 8x8 texels, but for those at the map's edge.
std::vector<double> taken_of_blocks(const ShadowMap& map)
{
    const std::vector<double> lit = lit_parts(map, 0.5, kBlock);
    const int side = map.size - 2 * kBlock;
    const auto blocks = static_cast<std::size_t>(side / kBlock);
    std::vector<double> taken(blocks * blocks);
    for (std::size_t i = 0; i < lit.size(); ++i) {
        const std::size_t x = i % static_cast<std::size_t>(side) / kBlock;
        const std::size_t y = i / static_cast<std::size_t>(side) / kBlock;
        taken[y * blocks + x] += (1 - lit[i]) * map.samples;
    }
    return taken;
}

}  // namespace

// 64 texels that lie together on the curve have all numbers of a span: of 4 samples each and an
// opacity of 0.3, 76.8 to within one.
TEST(TrackedShadows, ASheetTakesItsShareOfEveryBlockOfTexels)
{
    const Scene scene = test::sheets_over_floor({0.3f});
    const double share = 64 * 4 * 0.3;
    for (const ShadowMasks masks : kTracked) {
        for (std::uint32_t key = 0; key < 4; ++key) {
            const auto map = suns_map(scene, shadows_with(masks, 4), key);
            EXPECT_LT(farthest_from(1.2, taken_of_texels(*map)), 1);
            EXPECT_LT(farthest_from(share, taken_of_blocks(*map)), 1);
        }
    }
    // Of independent texels blocks have a deviation of 8 sqrt(0.2 0.8), 3.2.
    const auto map = suns_map(scene, shadows_with(ShadowMasks::stratified, 4), 0);
    EXPECT_GT(farthest_from(share, taken_of_blocks(*map)), 3);
}

// All numbers of a texel in 16 frames are one span, of which one sheet takes 19.2 to within one.
TEST(TrackedShadows, FramesOfOnePictureShareASheet)
{
    const Scene scene = test::sheets_over_floor({0.3f});
    const auto taken_of_frames = [&](ShadowMasks masks, bool together) {
        std::vector<double> sums;
        for (int i = 0; i < 16; ++i) {
            const FrameOfPicture frame{7, together ? i : 0, together ? 16 : 1};
            const auto key = static_cast<std::uint32_t>(i);
            const auto taken =
                taken_of_texels(*suns_map(scene, shadows_with(masks, 4), key, frame));
            sums.resize(taken.size());
            for (std::size_t t = 0; t < taken.size(); ++t) sums[t] += taken[t];
        }
        return sums;
    };
    for (const ShadowMasks masks : kTracked) {
        EXPECT_LT(farthest_from(16 * 1.2, taken_of_frames(masks, true)), 1);
        // Each 1 or 2: a deviation of 4 sqrt(0.2 0.8), 1.6.
        EXPECT_GT(farthest_from(16 * 1.2, taken_of_frames(masks, false)), 1.6);
    }
}

// Texels are not independent, maps of other keys are: the mean of a map is a trial.
TEST(TrackedShadows, MapsAreRightOnAverageInEveryOrder)
{
    Scene scene = test::sheets_over_floor(kOpacities);
    for (const bool far_to_near : {false, true}) {
        if (far_to_near) std::reverse(scene.objects.begin(), scene.objects.end());
        for (const ShadowMasks masks : kTracked) {
            std::vector<std::vector<double>> means(kOpacities.size());
            for (std::uint32_t key = 0; key < 100; ++key) {
                const auto map = suns_map(scene, shadows_with(masks, 8), key);
                for (std::size_t i = 0; i < kOpacities.size(); ++i) {
                    means[i].push_back(observe(lit_parts(*map, height_behind(i + 1))).mean);
                }
            }
            double through = 1;
            for (std::size_t i = 0; i < kOpacities.size(); ++i) {
                through *= 1 - static_cast<double>(kOpacities[i]);
                const Observed o = observe(means[i]);
                EXPECT_TRUE(
                    verdict(o.mean - through, kZ * std::sqrt(o.variance / o.count), "the light"))
                    << "behind sheet " << i << (far_to_near ? ", far to near" : "");
            }
        }
    }
}

// Each sheet from near to far takes floor or ceil of its share of what light is left, n samples of
// S, and is right on average: Var(n') <= (1 - a)^2 Var(n) + 1/4.
TEST(TrackedShadows, SystematicSheetsVaryByRoundingAlone)
{
    constexpr int kSamples = 16;
    const Scene scene = test::sheets_over_floor(kOpacities);
    const auto variance = [&](ShadowMasks masks, std::size_t sheets) {
        std::vector<double> lit;
        for (std::uint32_t key = 0; key < 4; ++key) {
            const auto map = suns_map(scene, shadows_with(masks, kSamples), key);
            const auto parts = lit_parts(*map, height_behind(sheets));
            lit.insert(lit.end(), parts.begin(), parts.end());
        }
        return observe(lit).variance * kSamples * kSamples;
    };
    double bound = 0;
    for (std::size_t i = 0; i < kOpacities.size(); ++i) {
        const double rest = 1 - static_cast<double>(kOpacities[i]);
        bound = rest * rest * bound + 0.25;
        // 12,544 texels, of which those side by side vary less together than apart.
        EXPECT_LT(variance(ShadowMasks::systematic, i + 1), 1.1 * bound) << "behind sheet " << i;
    }
    EXPECT_GT(variance(ShadowMasks::stratified, kOpacities.size()), 2 * bound);
}

}  // namespace sheer
