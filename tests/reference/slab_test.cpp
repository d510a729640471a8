// Stochastic layered alpha blending with explicit masks: against the talk's worked example, against
// stochastic transparency with the same masks, sample by sample, and against errors known from
// elsewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "reference/layered.h"
#include "reference/printed.h"
#include "reference/random_fragments.h"
#include "reference/slab.h"

namespace sheer::reference {
namespace {

using Fragments = std::vector<Fragment>;
using SlabMasks = std::vector<SlabMask>;

constexpr Rgba kBackdrop = {0.1, 0.2, 0.3, 0.5};

// Sixteen bits, the first on the left.
SlabMask bits(const std::string& text)
{
    SlabMask mask;
    for (std::size_t i = 0; i < text.size(); ++i) mask[i] = text[i] == '1';
    return mask;
}

// Red, then blue behind it, then green in front, then an opaque yellow behind everything. Red and
// blue choose half of the samples as the talk's pictures show; two of blue's are behind red.
const Fragments kTalk = {{0.5, 0.5, {1, 0, 0}, 1},
                         {0.7, 0.5, {0, 0, 1}, 2},
                         {0.3, 0.5, {0, 1, 0}, 3},
                         {0.9, 1.0, {1, 1, 0}, 4}};
const SlabMasks kTalkMasks = {bits("1001011010110100"), bits("1010110101000011"),
                              bits("0101000101101101"), bits("1111111111111111")};

std::vector<double> depths(const SlabStore& store)
{
    std::vector<double> result;
    for (const SlabLayer& layer : store.layers) result.push_back(layer.depth);
    return result;
}

TEST(ReferenceSlab, TheTalksFourFragments)
{
    const SlabStore store = slab_store(kTalk, kTalkMasks, 16, 16, SlabKeep::purged);
    EXPECT_EQ(depths(store), (std::vector{0.3, 0.5, 0.7}));  // yellow is hidden
    EXPECT_EQ(slab_visible_bits(store, 0.3, 3), 16);
    EXPECT_EQ(slab_visible_bits(store, 0.5, 1), 8);
    EXPECT_EQ(slab_visible_bits(store, 0.7, 2), 3);
    EXPECT_EQ(slab_visible_bits(store, 0.9, 4), 0);
    expect_same(slab(kTalk, store, SlabResolve::color, kBackdrop),
                {5.0 / 16, 8.0 / 16, 3.0 / 16, 1});
    const SlabStore two = slab_store(kTalk, kTalkMasks, 2, 16, SlabKeep::purged);
    EXPECT_EQ(depths(two), (std::vector{0.3, 0.5}));
    EXPECT_EQ(slab_visible_bits(two, 0.9, 4), 3);
}

TEST(ReferenceSlab, WhichHiddenLayersAreKept)
{
    // The second has no bit of its own, and nor has the first behind the third.
    const Fragments fragments = {{2, 0.5, {1, 0, 0}, 1},
                                 {3, 0.5, {0, 0, 1}, 2},
                                 {1, 0.5, {0, 1, 0}, 3},
                                 {4, 0.5, {1, 1, 0}, 4},
                                 {5, 0.5, {1, 1, 1}, 5}};
    const SlabMasks masks = {bits("1100"), bits("0100"), bits("1110"), bits("0000"), bits("0001")};
    const auto kept = [&](SlabKeep keep) {
        return depths(slab_store(fragments, masks, 4, 4, keep));
    };
    EXPECT_EQ(kept(SlabKeep::purged), (std::vector{1.0, 5.0}));
    EXPECT_EQ(kept(SlabKeep::visible), (std::vector{1.0, 2.0, 5.0}));
    EXPECT_EQ(kept(SlabKeep::nearest), (std::vector{1.0, 2.0, 3.0, 5.0}));
}

// E. Enderton et al., "Stochastic transparency", 2010: how many samples' nearest masked fragment is
// not in front of (depth, id).
int samples_that_see(const Fragments& fragments, const SlabMasks& masks, std::size_t i, int b)
{
    int count = 0;
    for (std::size_t s = 0; s < static_cast<std::size_t>(b); ++s) {
        bool hidden = false;
        for (std::size_t j = 0; j < fragments.size(); ++j) {
            const bool in_front =
                fragments[j].depth < fragments[i].depth ||
                (fragments[j].depth == fragments[i].depth && fragments[j].id < fragments[i].id);
            hidden = hidden || (in_front && masks[j][s]);
        }
        count += hidden ? 0 : 1;
    }
    return count;
}

TEST(ReferenceSlab, WithAsManyLayersAsBitsItIsStochasticTransparency)
{
    RandomFragments random(1);
    int with_one_layer_less = 0;
    for (int round = 0; round < 400; ++round) {
        for (const int b : {1, 4, 16, 31}) {
            Fragments fragments = random.list(1 + random.below(20));
            for (Fragment& f : fragments) {
                f.opacity *= 8.0 / b;  // thin enough for every bit to have a layer of its own
                f.opacity = std::min(f.opacity, 1.0);
                if (random.below(3) == 0) f.depth = 0.5;
            }
            const SlabMasks masks = random.masks(fragments, b);
            const SlabStore store = slab_store(fragments, masks, b, b, SlabKeep::purged);
            const SlabStore less = slab_store(fragments, masks, b - 1, b, SlabKeep::purged);
            bool same = true;
            for (std::size_t i = 0; i < fragments.size(); ++i) {
                const Fragment& f = fragments[i];
                const int seen = samples_that_see(fragments, masks, i, b);
                ASSERT_EQ(slab_visible_bits(store, f.depth, f.id), seen);
                same = same && slab_visible_bits(less, f.depth, f.id) == seen;
            }
            with_one_layer_less += same ? 0 : 1;
        }
    }
    EXPECT_GT(with_one_layer_less, 0);  // the comparison sees a store that is too short
}

void expect_near(const std::array<Moments, 4>& actual, const std::array<Moments, 4>& expected)
{
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(actual[c].mean, expected[c].mean, 1e-12) << c;
        EXPECT_NEAR(actual[c].variance, expected[c].variance, 1e-12) << c;
        EXPECT_NEAR(actual[c].fourth, expected[c].fourth, 1e-12) << c;
    }
}

TEST(ReferenceSlab, ItsMomentsAreThoseOfStochasticTransparency)
{
    const struct {
        SlabResolve slab;
        Estimator estimator;
    } pairs[] = {{SlabResolve::depth_corrected, Estimator::depth_corrected},
                 {SlabResolve::depth_based, Estimator::depth_based},
                 {SlabResolve::color_corrected, Estimator::alpha_corrected},
                 {SlabResolve::color, Estimator::basic}};
    const Fragments fragments = {
        {3, 0.7, {0.2, 0.8, 0.5}, 2}, {1, 0.45, {0.9, 0.3, 0.1}, 1}, {2, 0.6, {0.1, 0.4, 0.8}, 3}};
    for (const auto& pair : pairs) {
        SCOPED_TRACE(static_cast<int>(pair.slab));
        const auto moments = slab_moments(fragments, 4, 4, SlabKeep::purged, stratified_chance,
                                          pair.slab, kBackdrop);
        const EstimatedPixel pixel = {fragments, kBackdrop, 4};
        expect_near(moments.channels, estimate(pair.estimator, pixel, Masks::stratified));
        const auto naive =
            slab_moments(fragments, 3, 3, SlabKeep::purged, naive_chance, pair.slab, kBackdrop);
        expect_near(naive.channels,
                    estimate(pair.estimator, {fragments, kBackdrop, 3}, Masks::naive));
    }
}

TEST(ReferenceSlab, ALayerIsKeptAsOftenAsItShows)
{
    const Fragments fragments = {{1, 0.5, {1, 0, 0}, 1}, {2, 0.25, {0, 1, 0}, 2}};
    const auto moments =
        slab_moments(fragments, 2, 8, SlabKeep::purged, stratified_chance, SlabResolve::color, {});
    EXPECT_NEAR(moments.kept[0], 1, 1e-12);
    EXPECT_NEAR(moments.kept[1], slab_stratified_chance(8, 4, 2), 1e-12);
}

TEST(ReferenceSlab, InfinitelyManyBitsAreTheNearestLayers)
{
    RandomFragments random(2);
    for (int round = 0; round < 50; ++round) {
        const Fragments fragments = random.list(9);
        for (const int k : {1, 4, 9}) {
            const SlabStore store = slab_store_of_alpha(fragments, k);
            expect_same(slab(fragments, store, SlabResolve::color, kBackdrop),
                        depth_peeling(fragments, k, kBackdrop));
            expect_same(slab(fragments, store, SlabResolve::color, kBackdrop),
                        hybrid(fragments, k, HybridTail::none, kBackdrop));
            expect_same(slab(fragments, store, SlabResolve::color_corrected, kBackdrop),
                        hybrid(fragments, k, HybridTail::scaled, kBackdrop));
        }
        expect_same(slab(fragments, slab_store_of_alpha(fragments, 9), SlabResolve::depth_corrected,
                         kBackdrop),
                    composite(fragments, kBackdrop));
    }
}

bool same_layers(const SlabStore& a, const SlabStore& b)
{
    return std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(),
                      [](const SlabLayer& l, const SlabLayer& m) {
                          return l.id == m.id && l.depth == m.depth && l.mask == m.mask;
                      });
}

// The store of the fragments whose numbers are listed, in that order.
SlabStore store_of(const Fragments& fragments, const SlabMasks& masks,
                   const std::vector<std::size_t>& which, int k, SlabKeep keep)
{
    Fragments some;
    SlabMasks their_masks;
    for (const std::size_t i : which) {
        some.push_back(fragments[i]);
        their_masks.push_back(masks[i]);
    }
    return slab_store(some, their_masks, k, 16, keep);
}

// How many of 500 lists of six fragments leave another store when they come in another order.
int depend_on_order(int k, SlabKeep keep)
{
    RandomFragments random(3);
    int count = 0;
    for (int round = 0; round < 500; ++round) {
        const Fragments fragments = random.list(6);
        const SlabMasks masks = random.masks(fragments, 16);
        std::vector<std::size_t> order(6);
        std::iota(order.begin(), order.end(), std::size_t{0});
        const SlabStore first = store_of(fragments, masks, order, k, keep);
        bool same = true;
        for (int turn = 0; turn < 20; ++turn) {
            random.shuffle(order);
            same = same && same_layers(first, store_of(fragments, masks, order, k, keep));
        }
        count += same ? 0 : 1;
    }
    return count;
}

TEST(ReferenceSlab, TheOrderOfArrivalShowsOnlyWhereLayersAreDiscarded)
{
    for (const int k : {1, 6, 8}) EXPECT_EQ(depend_on_order(k, SlabKeep::purged), 0) << k;
    for (const int k : {1, 3, 6}) EXPECT_EQ(depend_on_order(k, SlabKeep::nearest), 0) << k;
    EXPECT_GT(depend_on_order(3, SlabKeep::purged), 0);
}

// How many of 1000 lists have another store when three parts of it are merged.
int depend_on_partition(std::size_t fragments_each, int k, SlabKeep keep)
{
    RandomFragments random(4);
    int count = 0;
    for (int round = 0; round < 1000; ++round) {
        const Fragments fragments = random.list(fragments_each);
        const SlabMasks masks = random.masks(fragments, 16);
        std::vector<std::size_t> parts[3], all;
        for (std::size_t i = 0; i < fragments_each; ++i) {
            parts[random.below(3)].push_back(i);
            all.push_back(i);
        }
        const SlabStore whole = store_of(fragments, masks, all, k, keep);
        const SlabStore a = store_of(fragments, masks, parts[0], k, keep);
        const SlabStore b = store_of(fragments, masks, parts[1], k, keep);
        const SlabStore c = store_of(fragments, masks, parts[2], k, keep);
        const SlabStore merged = slab_merge(slab_merge(a, b, k, keep), c, k, keep);
        const SlabStore other = slab_merge(c, slab_merge(b, a, k, keep), k, keep);
        EXPECT_TRUE(same_layers(merged, slab_merge(merged, merged, k, keep)));
        count += same_layers(whole, merged) && same_layers(whole, other) ? 0 : 1;
    }
    return count;
}

TEST(ReferenceSlab, TheNearestMergeExactly)
{
    EXPECT_EQ(depend_on_partition(8, 3, SlabKeep::nearest), 0);
    EXPECT_EQ(depend_on_partition(5, 5, SlabKeep::purged), 0);  // nothing is discarded
    EXPECT_GT(depend_on_partition(8, 3, SlabKeep::purged), 0);
}

// Root mean square error of D on n layers of alpha 0.5 with colours uniform in [0, 1]. The weights
// of D and of the truth have the same sum, so that the colours' mean drops out and their variance,
// 1/12, remains: only masks are random here.
struct ErrorOfD {
    double rms, deviation;  // of rms, by the masks
};

ErrorOfD error_of_d(int n, int k, int b, SlabKeep keep, int trials)
{
    RandomFragments random(5);
    Fragments fragments;
    for (int i = 0; i < n; ++i) {
        fragments.push_back({double(i), 0.5, {0, 0, 0}, static_cast<std::uint32_t>(i)});
    }
    double sum = 0, squares = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const SlabStore store = slab_store(fragments, random.masks(fragments, b), k, b, keep);
        const auto weights = slab_weights(fragments, store, SlabResolve::depth_corrected);
        double error = 0, weight = 0.5;
        for (int i = 0; i < n; ++i, weight /= 2) {
            error += std::pow(weights[static_cast<std::size_t>(i)] - weight, 2) / 12;
        }
        sum += error / trials;
        squares += error * error / trials;
    }
    const double rms = std::sqrt(sum);
    return {rms, std::sqrt((squares - sum * sum) / trials) / (2 * rms)};
}

// The known errors come from trials themselves, and where one was made twice its two values are 2 %
// apart: they get 4 %, ours four standard deviations.
bool is_near(const ErrorOfD& error, double known)
{
    return std::abs(error.rms - known) < 0.04 * known + 4 * error.deviation;
}

TEST(ReferenceSlab, ErrorsOfDOnLayersOfOneHalf)
{
    const struct {
        int n, k, b;
        SlabKeep keep;
        double error;
    } rows[] = {{4, 4, 4, SlabKeep::purged, .0335},    {8, 8, 8, SlabKeep::purged, .0309},
                {16, 8, 8, SlabKeep::purged, .0314},   {8, 8, 32, SlabKeep::purged, .0152},
                {8, 8, 63, SlabKeep::purged, .0106},   {8, 4, 32, SlabKeep::purged, .0221},
                {16, 4, 32, SlabKeep::purged, .0460},  {16, 8, 32, SlabKeep::nearest, .0177},
                {16, 4, 32, SlabKeep::nearest, .0484}, {16, 8, 32, SlabKeep::purged, .0159}};
    for (const auto& row : rows) {
        SCOPED_TRACE(testing::Message() << row.n << " " << row.k << " " << row.b);
        const ErrorOfD error = error_of_d(row.n, row.k, row.b, row.keep, 1000);
        EXPECT_TRUE(is_near(error, row.error)) << error.rms;
        // Twice the bits or eight times as many layers: one of them matters, and is told apart.
        EXPECT_FALSE(is_near(error_of_d(row.n, row.k, 2 * row.b, row.keep, 500), row.error) &&
                     is_near(error_of_d(row.n, 8 * row.k, row.b, row.keep, 500), row.error));
    }
}

}  // namespace
}  // namespace sheer::reference
