// The oracles of the methods that keep a few layers, against numbers worked out elsewhere: five
// layers in every order of arrival. What was printed holds to half a unit of its last digit.
#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <vector>

#include "reference/five_layers.h"
#include "reference/layered.h"
#include "reference/printed.h"

namespace sheer::reference {
namespace {

using Fragments = std::vector<Fragment>;
using Method = std::function<Rgba(const Fragments&)>;

const Rgba kBackdrop = {0.1, 0.2, 0.3, 0.5};

Fragments far_to_near()
{
    return {kFiveLayers.rbegin(), kFiveLayers.rend()};
}

void expect_exact_in_every_order(const Method& method)
{
    for_every_order([&](const Fragments& fragments) {
        expect_same(method(fragments), composite(fragments, kBackdrop));
    });
}

Method mlab_of(int layers, Rgba backdrop = {})
{
    return [=](const Fragments& f) { return mlab(f, layers, backdrop); };
}

Method k_buffer_of(int layers, KBufferMerge merge, Rgba backdrop = {})
{
    return [=](const Fragments& f) { return k_buffer(f, layers, merge, backdrop); };
}

Method hybrid_of(int layers, HybridTail tail, Rgba backdrop = {})
{
    return [=](const Fragments& f) { return hybrid(f, layers, tail, backdrop); };
}

Method adaptive_of(int nodes, Rgba backdrop = {})
{
    return [=](const Fragments& f) { return adaptive(f, nodes, backdrop); };
}

}  // namespace

TEST(ReferenceMlab, FiveLayersInEveryOrder)
{
    const struct {
        int layers;
        const char *mean, *most;
        std::size_t results;
    } rows[] = {
        {1, ".056459", ".121212", 24}, {2, ".018758", ".058898", 6}, {3, ".002910", ".014549", 2}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.layers);
        const Spread spread = spread_of(mlab_of(row.layers));
        expect_printed(spread.mean, row.mean);
        expect_printed(spread.most, row.most);
        EXPECT_EQ(spread.results.size(), row.results);
    }
    for (const int layers : {4, 5, 9}) expect_exact_in_every_order(mlab_of(layers, kBackdrop));
}

TEST(ReferenceMlab, FromFarToNearEvenOneLayerIsExact)
{
    expect_same(mlab(far_to_near(), 1, kBackdrop), composite(kFiveLayers, kBackdrop));
}

TEST(ReferenceMlab, WhatPassesIsAlwaysExact)
{
    for_every_order([](const Fragments& f) { EXPECT_NEAR(mlab(f, 2, {}).a, 1 - 0.0672, 1e-12); });
}

TEST(ReferenceKBuffer, FiveLayersInEveryOrder)
{
    const struct {
        int layers;
        const char *mean, *most;
        Printed far_to_near;
    } rows[] = {{1, ".143113", ".271909", {".7008", ".7288", ".1368"}},
                {2, ".081571", ".211818", {".3528", ".4228", ".3168"}},
                {3, ".032660", ".163299", {".4428", ".5428", ".1068"}}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.layers);
        const Method method = k_buffer_of(row.layers, KBufferMerge::front);
        const Spread spread = spread_of(method);
        expect_printed(spread.mean, row.mean);
        expect_printed(spread.most, row.most);
        expect_printed(method(far_to_near()), row.far_to_near);
        expect_same(method(kFiveLayers), composite(kFiveLayers, {}));
    }
    expect_exact_in_every_order(k_buffer_of(4, KBufferMerge::front, kBackdrop));
}

TEST(ReferenceKBuffer, OneLayerOfTheTwoNearestIsMlab)
{
    for_every_order([](const Fragments& f) {
        expect_same(k_buffer(f, 1, KBufferMerge::nearest_two, kBackdrop), mlab(f, 1, kBackdrop));
    });
    expect_exact_in_every_order(k_buffer_of(4, KBufferMerge::nearest_two, kBackdrop));
}

TEST(ReferenceKBuffer, DiscardKeepsTheNearest)
{
    for (const int layers : {1, 2, 3, 4}) {
        const Fragments nearest(kFiveLayers.begin(), kFiveLayers.begin() + layers);
        for_every_order([&](const Fragments& f) {
            expect_same(k_buffer(f, layers, KBufferMerge::discard, kBackdrop),
                        composite(nearest, kBackdrop));
            expect_same(depth_peeling(f, layers, kBackdrop), composite(nearest, kBackdrop));
        });
    }
    expect_exact_in_every_order(k_buffer_of(5, KBufferMerge::discard, kBackdrop));
}

TEST(ReferenceHybrid, FiveLayersInEveryOrder)
{
    const struct {
        int layers;
        HybridTail tail;
        Printed printed;
    } rows[] = {{1, HybridTail::maule, {".725977", ".338965", ".141235"}},
                {2, HybridTail::maule, {".662756", ".362756", ".101722"}},
                {3, HybridTail::maule, {".634400", ".334400", ".123600"}},
                {1, HybridTail::total, {".730827", ".346240", ".144267"}},
                {2, HybridTail::total, {".669309", ".369309", ".105818"}},
                {3, HybridTail::total, {".642800", ".342800", ".125700"}}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.layers);
        const Method method = hybrid_of(row.layers, row.tail);
        expect_printed(method(kFiveLayers), row.printed);
        EXPECT_EQ(spread_of(method).results.size(), 1u);
    }
    for (const HybridTail tail : {HybridTail::maule, HybridTail::total}) {
        expect_exact_in_every_order(hybrid_of(4, tail, kBackdrop));
    }
    expect_exact_in_every_order(hybrid_of(5, HybridTail::none, kBackdrop));
    expect_exact_in_every_order(hybrid_of(5, HybridTail::scaled, kBackdrop));
}

TEST(ReferenceHybrid, WithoutATailTheCoreCoversWhatAllDo)
{
    // The nearest alone is pure red.
    expect_same(hybrid(kFiveLayers, 1, HybridTail::none, {}), {0.5, 0, 0, 0.5});
    expect_same(hybrid(kFiveLayers, 1, HybridTail::scaled, {}), {0.9328, 0, 0, 0.9328});
}

TEST(ReferenceAdaptive, FiveLayersFromNearToFar)
{
    expect_printed(adaptive(kFiveLayers, 2, {}), {".553760", ".253760", ".033600"});
    EXPECT_EQ(spread_of(adaptive_of(2)).results.size(), 3u);
    const Printed printed[] = {{".639440", ".339440", ".076440"},
                               {".639440", ".339440", ".103440"}};
    for (const int nodes : {3, 4}) {
        const Method method = adaptive_of(nodes);
        expect_printed(method(kFiveLayers), printed[nodes - 3]);
        EXPECT_EQ(spread_of(method).results.size(), 1u);
    }
    expect_exact_in_every_order(adaptive_of(5, kBackdrop));
}

TEST(ReferenceAdaptive, IsNeverBrighterThanTheExactAnswer)
{
    for (const int nodes : {1, 2, 3, 4}) {
        for_every_order([&](const Fragments& f) {
            const Rgba got = adaptive(f, nodes, {}), exact = composite(f, {});
            EXPECT_LE(got.r, exact.r + 1e-12);
            EXPECT_LE(got.g, exact.g + 1e-12);
            EXPECT_LE(got.b, exact.b + 1e-12);
            EXPECT_NEAR(got.a, exact.a, 1e-12);
        });
    }
}

TEST(ReferenceDualDepthPeeling, TakesFromBothEnds)
{
    const Fragments ends = {kFiveLayers[0], kFiveLayers[1], kFiveLayers[3], kFiveLayers[4]};
    for_every_order([&](const Fragments& f) {
        expect_same(dual_depth_peeling(f, 2, kBackdrop), composite(ends, kBackdrop));
        expect_same(dual_depth_peeling(f, 3, kBackdrop), composite(kFiveLayers, kBackdrop));
    });
}

}  // namespace sheer::reference
