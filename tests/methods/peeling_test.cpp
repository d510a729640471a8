// Peeling knows which of two surfaces is nearer where floats do not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "methods/tile_fixture.h"
#include "simd_levels.h"

namespace sheer {
namespace {

constexpr const char* kExactMethods[] = {"exact", "depth-peeling", "dual-depth-peeling",
                                         "bucket-peeling:peels=4096",
                                         "bucket-peeling:borders=adaptive:peels=4096"};
constexpr double kRounding = 1e-6;  // of four layers, far more than a float's

// Over all samples of all used pixels; tilted, so that depths are not clamped to their plane's
// ends, which are floats.
Plate tilted_plate(std::uint32_t number, double depth, Float4 color)
{
    Plate plate{make_plane(depth, 0x1p-10, 0), number, 0, {}, color};
    plate.samples.fill(~0ull);
    return plate;
}

// The first two are as deep as one another in floats, and so are the last two; of those the second
// is nearer, by `gap`, and of these the first.
Plates close_plates(double depth, double gap)
{
    const double behind = depth + 0.25;
    return {tilted_plate(1, depth, {1, 0, 0, 0.5f}), tilted_plate(2, depth - gap, {0, 1, 0, 0.5f}),
            tilted_plate(3, behind - gap, {0, 0, 1, 0.5f}),
            tilted_plate(4, behind, {1, 1, 1, 0.5f})};
}

// The store's answer, put together from those for `parts`, is that of the precise order.
void expect_exact(Setting setting, const std::vector<Plates>& parts)
{
    const SampleSet& set = *setting.set;
    Plates all;
    Tile tile(setting);
    for (const Plates& part : parts) {
        Tile one(setting);
        one.insert(part);
        tile.merge(one);
        all.insert(all.end(), part.begin(), part.end());
    }
    const auto samples = static_cast<std::size_t>(set.count);
    const Colors result = tile.resolve(Colors(4 * kTilePixels * samples));
    double most = 0;
    for (std::size_t used = 0; used < kUsedPixels; ++used) {
        for (std::size_t s = 0; s < samples; ++s) {
            const auto expected = reference::composite(fragments_at(all, set, used, s), {});
            const double channels[] = {expected.r, expected.g, expected.b};
            for (std::size_t c = 0; c < 3; ++c) {
                const float got = result[color_index(set, tile_pixel(used), s, c)];
                most = std::max(most, std::abs(static_cast<double>(got) - channels[c]));
            }
        }
    }
    EXPECT_LE(most, kRounding);
}

void expect_exact_at_every_level(const Plates& plates)
{
    for (const SampleSet& set : sample_sets()) {
        for (const Simd level : simd_levels()) {
            for (const char* method : kExactMethods) {
                SCOPED_TRACE(std::string(method) + ", S = " + std::to_string(set.count) + ", " +
                             name_of_targets(targets_of(level)));
                Setting setting{choose_method(method), &set};
                setting.level = level;
                expect_exact(setting, {plates});
                expect_exact(setting, {{plates[1], plates[3]}, {plates[2], plates[0]}});
            }
        }
    }
}

TEST(Peeling, KnowsTheOrderThatFloatsDoNot)
{
    for (const double depth : {1.0, -1.0}) {
        const Plates plates = close_plates(depth, 0x1p-28);
        for (const std::size_t pair : {0u, 2u}) {
            ASSERT_EQ(depth_at_center(plates[pair].depth, 0),
                      depth_at_center(plates[pair + 1].depth, 0));
        }
        expect_exact_at_every_level(plates);
    }
}

// What is one depth in 32 bits is a tie, which ids decide.
TEST(Peeling, HasTheTiesOfExact)
{
    for (const double depth : {1.0, -1.0}) {
        const Plates plates = close_plates(depth, 0x1p-40);
        ASSERT_EQ(precise_depth(plates[0].depth, sample_sets()[0], 0, 0),
                  precise_depth(plates[1].depth, sample_sets()[0], 0, 0));
        expect_exact_at_every_level(plates);
    }
}

}  // namespace
}  // namespace sheer
