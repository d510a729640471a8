// Methods that leave of a fragment something opaque or nothing: how often, and what layers share.
// Confidence: statistics.h.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "methods/every_method.h"
#include "methods/statistics.h"
#include "methods/stochastic_fixture.h"
#include "reference/alpha_to_coverage.h"

namespace sheer {
namespace {

using reference::CoverageMasks;

const std::vector<const char*> kAlphaTests = {
    "alpha-test",        "stochastic-alpha-test",    "hashed-alpha-test",
    "alpha-to-coverage", "hashed-alpha-to-coverage", "screen-door"};

// A layer whose cells are pixels, exactly: 0.707 is the paper's factor for sizes of cells that
// differ by axis, and those of one size for all are one pixel then.
struct SurfaceLayer {
    double alpha;
    std::uint32_t id = 0;
    float z = 0.5f;
    float pixel = 0.707f;  // what the place changes by in a pixel
    float level = 3;       // of the texture
};

void put_places(FragmentStream& f, const SurfaceLayer& layer, int tile)
{
    for (int i = 0; i < f.size; ++i) {
        const auto x = static_cast<float>(f.pixel[i] % kTileSize);
        const auto y = static_cast<float>(f.pixel[i] / kTileSize);
        const float place[] = {x + 0.5f + static_cast<float>(tile * kTileSize),
                               y + 0.5f,
                               layer.z,
                               layer.pixel,
                               0,
                               0,
                               0,
                               layer.pixel,
                               0};
        for (std::size_t c = 0; c < 9; ++c) f.place[c][i] = place[c];
        f.level[i] = layer.level;
    }
}

// Of each pixel.
std::vector<std::uint64_t> masks_of(DrivenTile& tile, int samples, const SurfaceLayer& layer,
                                    int tiles = 8)
{
    std::vector<std::uint64_t> masks;
    for (int i = 0; i < tiles; ++i) {
        const auto as_layer = [&](FragmentStream& f) {
            f.runs[0].primitive = f.runs[0].object = layer.id;
            put_places(f, layer, i);
        };
        const SampleColors& colors =
            tile.draw({{layer.alpha, {1, 0, 0}, 1}}, {kTileSize * i, 0, 0xabcdefu}, as_layer);
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

std::vector<int> sizes_of(const std::vector<std::uint64_t>& masks)
{
    std::vector<int> sizes;
    for (const std::uint64_t mask : masks) sizes.push_back(std::popcount(mask));
    return sizes;
}

std::vector<int> overlaps_of(const std::vector<std::uint64_t>& a,
                             const std::vector<std::uint64_t>& b)
{
    std::vector<int> sizes;
    for (std::size_t i = 0; i < a.size(); ++i) sizes.push_back(std::popcount(a[i] & b[i]));
    return sizes;
}

double count_of(const std::vector<int>& sizes)
{
    double count = 0;
    for (const int size : sizes) count += size;
    return count;
}

TEST(AlphaTests, WithoutOpacityNothingOpaqueEverything)
{
    for (const char* id : kAlphaTests) {
        for (const ChosenMethod& method : every_choice(*choose_method(id).row)) {
            const std::string name = name_of(method);
            // A cutoff of 0 passes everything; the renderer hands on nothing without opacity.
            if (id == std::string("alpha-test") && method.real("cutoff") == 0) continue;
            for (const int samples : {1, 8, 64}) {
                DrivenTile tile(name, samples);
                for (const float pixel : {0.707f, 0.3f, 0.0f}) {
                    for (const auto mask : masks_of(tile, samples, {0, 3, 0.5f, pixel}, 1)) {
                        ASSERT_EQ(mask, 0u) << name;
                    }
                    for (const auto mask : masks_of(tile, samples, {1, 3, 0.5f, pixel}, 1)) {
                        ASSERT_EQ(std::popcount(mask), samples) << name;
                    }
                }
            }
        }
    }
}

TEST(AlphaTests, FixedThresholdTakesAllOrNothing)
{
    DrivenTile tile("alpha-test:cutoff=0.25", 4);
    for (const double alpha : {0.2499, 0.25, 0.7}) {
        const auto masks = masks_of(tile, 4, {alpha}, 1);
        for (const auto mask : masks) EXPECT_EQ(mask, alpha < 0.25 ? 0u : 15u);
    }
}

TEST(AlphaTests, RandomThresholdsPassWithTheOpacitysChance)
{
    for (const double alpha : {0.003, 0.45, 0.9}) {
        SCOPED_TRACE(alpha);
        DrivenTile whole("stochastic-alpha-test", 4);
        const auto masks = masks_of(whole, 4, {alpha, 5});
        const auto trials = static_cast<double>(masks.size());
        for (const auto mask : masks) EXPECT_TRUE(mask == 0 || mask == 15);
        EXPECT_TRUE(count_agrees(count_of(sizes_of(masks)) / 4, trials, alpha));
        const auto other = masks_of(whole, 4, {alpha, 6});
        EXPECT_TRUE(count_agrees(count_of(overlaps_of(masks, other)) / 4, trials, alpha * alpha));
        DrivenTile each("stochastic-alpha-test:threshold=sample", 4);
        std::vector<double> chances;
        for (int k = 0; k <= 4; ++k) {
            const double choices[] = {1, 4, 6, 4, 1};
            chances.push_back(choices[k] * std::pow(alpha, k) * std::pow(1 - alpha, 4 - k));
        }
        expect_counts(sizes_of(masks_of(each, 4, {alpha, 5})), chances);
    }
}

// Over pixels whose cells are all others; and layers that only the third coordinate tells apart.
TEST(AlphaTests, HashedThresholdsPassWithTheOpacitysChance)
{
    for (const char* name :
         {"hashed-alpha-test", "hashed-alpha-test:hash=paper", "hashed-alpha-test:hash=lowbias",
          "hashed-alpha-test:hash=xxhash", "hashed-alpha-test:variant=eight-corners"}) {
        DrivenTile tile(name, 2);
        DrivenTile flat(std::string(name) + ":without=third", 2);
        for (const double alpha : {0.05, 0.45, 0.9}) {
            SCOPED_TRACE(std::string(name) + ", " + std::to_string(alpha));
            const auto near = masks_of(tile, 2, {alpha, 0, 0.5f});
            const auto far = masks_of(tile, 2, {alpha, 0, 3.5f});
            const auto trials = static_cast<double>(near.size());
            for (const auto mask : near) EXPECT_TRUE(mask == 0 || mask == 3);
            EXPECT_TRUE(count_agrees(count_of(sizes_of(near)) / 2, trials, alpha));
            EXPECT_TRUE(count_agrees(count_of(sizes_of(far)) / 2, trials, alpha));
            EXPECT_TRUE(count_agrees(count_of(overlaps_of(near, far)) / 2, trials, alpha * alpha));
            EXPECT_EQ(masks_of(flat, 2, {alpha, 0, 0.5f}), masks_of(flat, 2, {alpha, 0, 3.5f}));
        }
    }
}

TEST(AlphaTests, FixedCoverageRoundsAndLayersAgree)
{
    for (const int samples : {1, 8, 64}) {
        DrivenTile tile("alpha-to-coverage", samples);
        for (int step = 0; step <= 16; ++step) {
            const double alpha = step / 16.0;
            const int count = static_cast<int>(std::floor(samples * alpha + 0.5));
            const std::uint64_t first =
                count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
            for (const auto mask : masks_of(tile, samples, {alpha}, 1)) ASSERT_EQ(mask, first);
        }
    }
}

TEST(AlphaTests, HashedCoverageHasTheCountsAndOverlapsOfEquation9)
{
    for (const char* name : {"hashed-alpha-to-coverage", "hashed-alpha-to-coverage:jitter=sample",
                             "hashed-alpha-to-coverage:hash=paper"}) {
        for (const int samples : {4, 8, 16}) {
            DrivenTile tile(name, samples);
            DrivenTile together(std::string(name) + ":decorrelate=off", samples);
            for (const double alpha : {0.1, 0.5, 0.7}) {
                SCOPED_TRACE(std::string(name) + ", S = " + std::to_string(samples) + ", " +
                             std::to_string(alpha));
                const SurfaceLayer near{alpha, 0, 0.5f}, far{alpha, 0, 3.5f};
                const auto masks = masks_of(tile, samples, near);
                const auto counts =
                    reference::count_chances(samples, alpha, CoverageMasks::decorrelated);
                expect_counts(sizes_of(masks), counts);
                const auto overlaps =
                    reference::overlap_chances(samples, alpha, alpha, CoverageMasks::decorrelated);
                expect_counts(overlaps_of(masks, masks_of(tile, samples, far)), overlaps);
                // Without the offset and the increment one layer's samples are among the other's.
                const auto a = masks_of(together, samples, near);
                const auto b = masks_of(together, samples, far);
                expect_counts(sizes_of(a), counts);
                if (std::string(name).find("sample") != std::string::npos) continue;
                for (std::size_t i = 0; i < a.size(); ++i) {
                    ASSERT_EQ(std::popcount(a[i] & b[i]),
                              std::min(std::popcount(a[i]), std::popcount(b[i])));
                }
            }
        }
    }
}

// Sets of pixels of the tile's first square; the others are like it.
std::uint64_t square_of(DrivenTile& tile, int side, const SurfaceLayer& layer)
{
    const auto masks = masks_of(tile, 1, layer, 1);
    std::uint64_t square = 0;
    for (int i = 0; i < kTilePixels; ++i) {
        const int x = i % kTileSize, y = i / kTileSize;
        const auto kept = masks[static_cast<std::size_t>(i)];
        const int bit = y % side * side + x % side;
        if (x < side && y < side) square |= kept << bit;
        EXPECT_EQ(kept, square >> bit & 1);
    }
    return square;
}

TEST(AlphaTests, ScreenDoorsHaveTheCountsAndOverlapsOfEquation9)
{
    constexpr std::uint32_t kLayers = 600;
    for (const int side : {2, 4}) {
        const int n = side * side;
        const std::string name = "screen-door:square=" + std::to_string(side);
        DrivenTile tile(name, 1);
        for (const double alpha : {0.3, 0.5}) {
            SCOPED_TRACE(name + ", " + std::to_string(alpha));
            std::vector<std::uint64_t> squares;
            for (std::uint32_t id = 0; id < kLayers; ++id) {
                squares.push_back(square_of(tile, side, {alpha, id}));
            }
            expect_counts(sizes_of(squares),
                          reference::count_chances(n, alpha, CoverageMasks::decorrelated));
            // Each layer once in a pair.
            std::vector<int> overlaps;
            for (std::size_t i = 0; i < kLayers; i += 2) {
                overlaps.push_back(std::popcount(squares[i] & squares[i + 1]));
            }
            expect_counts(overlaps,
                          reference::overlap_chances(n, alpha, alpha, CoverageMasks::decorrelated));
        }
        DrivenTile plain(name + ":decorrelate=off:jitter=off", 1);
        for (int step = 0; step <= 10; ++step) {
            const double alpha = static_cast<double>(static_cast<float>(step / 10.0));
            const auto square = square_of(plain, side, {alpha, 1});
            EXPECT_EQ(std::popcount(square), static_cast<int>(std::floor(n * alpha + 0.5)));
            EXPECT_EQ(square, square_of(plain, side, {alpha, 2}));
        }
    }
}

}  // namespace
}  // namespace sheer
