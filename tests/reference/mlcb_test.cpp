// Multi-layer coverage blending: where nothing is joined it is stochastic layered alpha blending,
// and what joining leaves as it was.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "reference/mlcb.h"
#include "reference/printed.h"
#include "reference/random_fragments.h"

namespace sheer::reference {
namespace {

constexpr Rgba kBackdrop = {0.1, 0.2, 0.3, 0.5};
constexpr SlabKeep kKeeps[] = {SlabKeep::purged, SlabKeep::visible, SlabKeep::nearest};

double alpha_of(const std::vector<Fragment>& fragments)
{
    return composite(fragments, {}).a;
}

TEST(ReferenceMlcb, WithEnoughLayersItIsSlab)
{
    RandomFragments random(1);
    for (int round = 0; round < 50; ++round) {
        const auto fragments = random.list(7);
        const auto masks = random.masks(fragments, 16);
        for (const SlabKeep keep : kKeeps) {
            const auto layers = mlcb_layers(fragments, masks, 7, keep);
            const SlabStore store = slab_store(fragments, masks, 7, 16, keep);
            expect_same(mlcb_resolve_uncorrected(layers, 16, kBackdrop),
                        slab(fragments, store, SlabResolve::color, kBackdrop));
            expect_same(mlcb_resolve(layers, 16, alpha_of(fragments), kBackdrop),
                        slab(fragments, store, SlabResolve::color_corrected, kBackdrop));
        }
    }
}

TEST(ReferenceMlcb, JoiningKeepsTheBitsThatAreCovered)
{
    RandomFragments random(2);
    for (int round = 0; round < 50; ++round) {
        const auto fragments = random.list(9);
        const auto masks = random.masks(fragments, 16);
        SlabMask covered;
        for (const SlabMask& mask : masks) covered |= mask;
        for (const int k : {1, 2, 4}) {
            for (const SlabKeep keep : kKeeps) {
                const auto layers = mlcb_layers(fragments, masks, k, keep);
                EXPECT_LE(layers.size(), static_cast<std::size_t>(k));
                EXPECT_NEAR(mlcb_resolve_uncorrected(layers, 16, {}).a,
                            static_cast<double>(covered.count()) / 16, 1e-12);
            }
        }
    }
}

TEST(ReferenceMlcb, TwoLayersByHand)
{
    // Red has two bits of four, blue the second of them and one more.
    const std::vector<Fragment> fragments = {{1, 0.5, {1, 0, 0}, 1}, {2, 0.5, {0, 0, 1}, 2}};
    const std::vector<SlabMask> masks = {0b0011, 0b0110};
    const auto layers = mlcb_layers(fragments, masks, 1, SlabKeep::visible);
    ASSERT_EQ(layers.size(), 1u);
    EXPECT_EQ(layers[0].mask, SlabMask(0b0111));
    EXPECT_EQ(layers[0].depth, 1);
    expect_same(mlcb_resolve_uncorrected(layers, 4, {}), {0.5, 0, 0.25, 0.75});
    expect_same(mlcb_resolve(layers, 4, 0.75, {0, 1, 0, 1}), {0.5, 0.25, 0.25, 1});
    expect_same(mlcb_resolve(layers, 4, 0.6, {}), {0.4, 0, 0.2, 0.6});
}

TEST(ReferenceMlcb, FromNearToFarOneLayerIsEnough)
{
    RandomFragments random(3);
    int off = 0;
    for (int round = 0; round < 50; ++round) {
        auto fragments = random.list(7);
        std::sort(fragments.begin(), fragments.end(),
                  [](const Fragment& a, const Fragment& b) { return a.depth < b.depth; });
        auto masks = random.masks(fragments, 16);
        const Rgba all = mlcb_resolve_uncorrected(
            mlcb_layers(fragments, masks, 7, SlabKeep::nearest), 16, kBackdrop);
        const auto one = [&] {
            return mlcb_resolve_uncorrected(mlcb_layers(fragments, masks, 1, SlabKeep::nearest), 16,
                                            kBackdrop);
        };
        expect_same(one(), all);
        std::reverse(fragments.begin(), fragments.end());
        std::reverse(masks.begin(), masks.end());
        off += std::abs(one().r - all.r) > 1e-3 ? 1 : 0;
    }
    EXPECT_GT(off, 0);  // the other way round it is not
}

}  // namespace
}  // namespace sheer::reference
