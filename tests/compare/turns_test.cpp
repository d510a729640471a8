// Turns: what is drawn in them, and what becomes of their times.
#include <gtest/gtest.h>

#include <cmath>

#include <sheer/sheer.h>

#include "compare/turns.h"

namespace sheer::test {

namespace {

struct Times {
    double geometry, shadow, raster_shade, store, resolve, total;
};

Stats stats_of(const Times& times)
{
    Stats stats;
    stats.fragments = 1000;
    stats.ms_geometry = times.geometry;
    stats.ms_raster_shade = times.raster_shade;
    stats.ms_store = times.store;
    stats.ms_resolve = times.resolve;
    stats.ms_total = times.total;
    stats.ms_passes = {
        {"shadow", times.shadow}, {"fragments", times.raster_shade}, {"store", times.store}};
    return stats;
}

TEST(Turns, BaseIsOneBlendedPassOfWhatIsTransparent)
{
    Turns turns;
    turns.blend = {stats_of({20, 50, 40, 10, 5, 130})};  // 75 but for shadows and resolve
    turns.opaque = {stats_of({5, 45, 15, 0, 4, 74})};    // 25
    turns.methods = {{stats_of({20, 55, 40, 30, 25, 175})}};
    const Timing timing = time_methods(turns).front();
    EXPECT_DOUBLE_EQ(timing.ms_opaque, 25);
    EXPECT_DOUBLE_EQ(timing.ms_base, 50);
    EXPECT_DOUBLE_EQ(timing.ratio_to_base, 3.5);
    EXPECT_DOUBLE_EQ(timing.ratio_to_blend, 175.0 / 130);
    EXPECT_DOUBLE_EQ(timing.ms_fragments, 40);  // 20 + 40 less 5 + 15
    EXPECT_DOUBLE_EQ(timing.ms_raster_store, 40 - 15 + 30);
    // With shadows 55, opaque 25 and the store's 30 it is all of the frame.
    EXPECT_DOUBLE_EQ(timing.ms_other, 175 - 55 - 25 - 40 - 30);
}

TEST(Turns, RatiosAreFormedRoundByRound)
{
    Turns turns;
    for (const double slow : {1.0, 10.0, 3.0}) {
        turns.blend.push_back(stats_of({0, 0, 0, 0, slow, 5 * slow}));
    }
    turns.methods = {{}};
    for (const double slow : {1.0, 10.0, 3.0}) {
        turns.methods.front().push_back(stats_of({0, 0, 0, 0, 0, 12 * slow}));
    }
    const Timing timing = time_methods(turns).front();
    EXPECT_EQ(timing.rounds, 3u);
    EXPECT_DOUBLE_EQ(timing.stats.ms_total, 36);
    EXPECT_DOUBLE_EQ(timing.total_min, 12);
    EXPECT_DOUBLE_EQ(timing.total_max, 120);
    EXPECT_DOUBLE_EQ(timing.ms_base, 12);
    EXPECT_DOUBLE_EQ(timing.ratio_to_blend, 12.0 / 5);
    EXPECT_DOUBLE_EQ(timing.ratio_to_base, 3);
    EXPECT_EQ(timing.ms_opaque, 0);
}

TEST(Turns, WithoutFragmentsThereIsNoBase)
{
    Turns turns;
    turns.blend = {stats_of({0, 0, 0, 0, 0, 10})};
    turns.blend.front().fragments = 0;
    turns.methods = {turns.blend};
    EXPECT_TRUE(std::isnan(time_methods(turns).front().ms_base));
    EXPECT_TRUE(std::isnan(time_methods(turns).front().ratio_to_base));
}

View small_view()
{
    View view;
    view.width = view.height = 8;
    view.samples = 1;
    return view;
}

// Two quads of 2 triangles, the first of them opaque, without a camera.
TEST(Turns, DrawsWhatIsOpaqueAlone)
{
    Scene scene = load("builtin:layers");
    ASSERT_EQ(scene.objects.size(), 2u);
    scene.cameras.clear();
    scene.materials[scene.meshes[scene.objects[0].mesh].material].alpha_mode = AlphaMode::opaque;
    double part = 0;
    const Turns turns =
        take_turns(scene, small_view(), {}, {{"exact", "none"}, 2, [&](double done) {
                                                 EXPECT_GT(done, part);
                                                 part = done;
                                             }});
    EXPECT_DOUBLE_EQ(part, 1);
    EXPECT_EQ(scene.objects.size(), 2u);
    ASSERT_EQ(turns.methods.size(), 2u);
    ASSERT_EQ(turns.opaque.size(), 2u);
    ASSERT_EQ(turns.blend.size(), 2u);
    EXPECT_EQ(turns.methods[0][1].method, "exact");
    EXPECT_EQ(turns.methods[1][1].method, "none");
    EXPECT_EQ(turns.blend[1].method, "blend");
    EXPECT_EQ(turns.blend[1].triangles, 4u);
    EXPECT_EQ(turns.opaque[1].triangles, 2u);
    EXPECT_EQ(turns.opaque[1].fragments, 0u);
}

// One quad of three is tested, one opaque.
TEST(Turns, WhatIsTestedIsNotOpaqueToMethodsThatTest)
{
    Scene scene = load("builtin:layers?n=3");
    const auto material = [&](std::size_t i) -> Material& {
        return scene.materials[scene.meshes[scene.objects[i].mesh].material];
    };
    material(0).alpha_mode = AlphaMode::opaque;
    material(1).alpha_mode = AlphaMode::mask;
    const Turns turns = take_turns(scene, small_view(), {}, {{"screen-door", "exact"}, 1, {}});
    EXPECT_EQ(scene.objects.size(), 3u);
    ASSERT_EQ(turns.opaque.size(), 1u);
    ASSERT_EQ(turns.untested.size(), 1u);
    EXPECT_EQ(turns.opaque[0].triangles, 4u);
    EXPECT_EQ(turns.untested[0].triangles, 2u);

    const Turns others = take_turns(scene, small_view(), {}, {{"exact"}, 1, {}});
    EXPECT_TRUE(others.untested.empty());
}

TEST(Turns, EachMethodIsWithoutWhatIsOpaqueToIt)
{
    Turns turns;
    turns.blend = {stats_of({20, 0, 40, 10, 5, 75})};
    turns.opaque = {stats_of({5, 0, 15, 0, 4, 24})};
    turns.untested = {stats_of({2, 0, 3, 0, 4, 9})};
    turns.methods = {turns.blend, turns.blend};
    turns.methods[0][0].method = "exact";
    turns.methods[1][0].method = "screen-door";
    const std::vector<Timing> timings = time_methods(turns);
    EXPECT_DOUBLE_EQ(timings[0].ms_opaque, 20);
    EXPECT_DOUBLE_EQ(timings[0].ms_fragments, 40);
    EXPECT_DOUBLE_EQ(timings[1].ms_opaque, 5);
    EXPECT_DOUBLE_EQ(timings[1].ms_fragments, 55);
    // Of `blend` either way.
    EXPECT_DOUBLE_EQ(timings[1].ms_base, timings[0].ms_base);
}

TEST(Turns, WithNothingOpaqueNothingElseIsDrawn)
{
    Scene scene = load("builtin:layers");
    const Turns turns = take_turns(scene, small_view(), {}, {{"blend"}, 1, {}});
    EXPECT_TRUE(turns.opaque.empty());
    EXPECT_EQ(turns.methods.size(), 1u);
    EXPECT_EQ(turns.blend.size(), 1u);
}

}  // namespace
}  // namespace sheer::test
