// The default camera: it shows everything, with a margin, and no more than it must.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "scene/camera_fixture.h"
#include "support/random.h"

namespace sheer {
namespace {

void expect_framed(const Scene& scene, const View& view)
{
    const Projection camera = resolve_camera(scene, view);
    EXPECT_GT(camera.znear, 0);
    EXPECT_EQ(camera.zfar, 0);
    double most = 0;
    for (const Vec3& p : corner_points(scene)) {
        const Projected at = project(camera, p);
        ASSERT_GT(at.depth, camera.znear);
        ASSERT_LE(std::abs(at.x), 0.9 + 1e-6);
        ASSERT_LE(std::abs(at.y), 0.9 + 1e-6);
        most = std::max({most, std::abs(at.x), std::abs(at.y)});
    }
    EXPECT_GT(most, 0.9 - 1e-6);
}

TEST(Framing, ShowsAllOfAnyBoxWithTheMarginAndNoMore)
{
    const CounterRandom random{1};
    std::uint64_t counter = 0;
    for (int i = 0; i < 300; ++i) {
        Float3 low, high;
        const double size = std::exp2(40 * random.uniform(counter++) - 20);
        for (std::size_t k = 0; k < 3; ++k) {
            const double a = random.uniform(counter++), b = random.uniform(counter++);
            low[k] = static_cast<float>(size * a);
            high[k] = static_cast<float>(size * (a + b * b));
        }
        for (const auto& [width, height] : {std::pair{100, 100}, {1600, 100}, {90, 1600}})
            expect_framed(box_scene(low, high), view_of(width, height));
    }
}

TEST(Framing, SeesFlatTinyAndHugeScenes)
{
    const View view = view_of(640, 480);
    expect_framed(box_scene({-1, 0, -2}, {3, 0, 2}), view);
    expect_framed(box_scene({0, -1, 0}, {0, 1, 0}), view);
    expect_framed(box_scene({-1e-6f, -1e-6f, 0}, {1e-6f, 1e-6f, 1e-6f}), view);
    expect_framed(box_scene({-1e7f, 0, -1e7f}, {1e7f, 1e6f, 1e7f}), view);
}

TEST(Framing, CountsEachObjectsPlace)
{
    Scene scene = box_scene({0, 0, 0}, {1, 1, 1});
    scene.objects.push_back({"far", 0, {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 50, -7, 3, 1}, 1});
    EXPECT_EQ(corner_points(scene).size(), 16u);
    expect_framed(scene, view_of(640, 480));
}

TEST(Framing, SurvivesAPointALineAndNothing)
{
    const View view = view_of(640, 480);
    Scene end_on = box_scene({0, 0, 0}, {0, 0, 0});
    // A line along the axis of view: pointing at the default eye, it never fills the picture.
    end_on.meshes[0].positions = {{0, 0, 0}, {0.55f, 0.42f, 0.85f}};
    for (const Scene& scene : {Scene{}, box_scene({5, 5, 5}, {5, 5, 5}),
                               box_scene({1e7f, 0, 0}, {1e7f, 0, 0}), end_on}) {
        const Projection camera = resolve_camera(scene, view);
        for (const double value : camera.world_to_view) EXPECT_TRUE(std::isfinite(value));
        EXPECT_TRUE(std::isfinite(camera.znear) && camera.znear > 0);
        for (const Vec3& p : corner_points(scene)) {
            const Projected at = project(camera, p);
            EXPECT_GT(at.depth, camera.znear);
            EXPECT_LE(std::abs(at.x), 0.91);
            EXPECT_LE(std::abs(at.y), 0.91);
        }
    }
}

TEST(Framing, LooksFromTheFrontRightAbove)
{
    const Projection camera = resolve_camera(box_scene({-1, -1, -1}, {1, 1, 1}), view_of(64, 64));
    EXPECT_GT(camera.eye[0], 1);
    EXPECT_GT(camera.eye[1], 1);
    EXPECT_GT(camera.eye[2], camera.eye[0]);
}

TEST(Framing, LeavesOutWhatIsNotFinite)
{
    Scene scene = box_scene({-1, -1, -1}, {1, 1, 1});
    scene.meshes[0].positions.push_back({std::numeric_limits<float>::infinity(), 0, 0});
    scene.meshes[0].positions.push_back({0, std::numeric_limits<float>::quiet_NaN(), 0});
    expect_framed(scene, view_of(64, 64));
}

}  // namespace
}  // namespace sheer
