// Cameras: which one a view means, and how it projects.
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <sheer/error.h>

#include "scene/camera.h"
#include "scene/camera_fixture.h"

namespace sheer {
namespace {

std::string error_of(const Scene& scene, const View& view)
{
    try {
        resolve_camera(scene, view);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "no error";
}

Scene with_cameras()
{
    Scene scene = box_scene({-1, -1, -1}, {1, 1, 1});
    scene.cameras.resize(3);
    scene.cameras[0].name = "front";
    scene.cameras[1].name = "top";
    scene.cameras[2].name = "1";
    for (std::size_t i = 0; i < 3; ++i) scene.cameras[i].transform[12] = static_cast<float>(i + 1);
    return scene;
}

TEST(Camera, IsTheOneNamedElseNumberedElseTheFirst)
{
    const Scene scene = with_cameras();
    View view = view_of(64, 64);
    const auto eye_x = [&](const char* name) {
        view.camera = name;
        return resolve_camera(scene, view).eye[0];
    };
    EXPECT_EQ(eye_x(""), 1);
    EXPECT_EQ(eye_x("top"), 2);
    EXPECT_EQ(eye_x("0"), 1);
    EXPECT_EQ(eye_x("2"), 3);
    EXPECT_EQ(eye_x("1"), 3) << "a name goes before a number";
    view.eye = Float3{7, 0, 0};
    view.target = Float3{0, 0, 0};
    EXPECT_EQ(eye_x("top"), 7) << "the view's own goes before all";
}

TEST(Camera, SaysWhichThereAre)
{
    View view = view_of(64, 64);
    view.camera = "side";
    EXPECT_EQ(error_of(with_cameras(), view),
              "camera 'side': no such camera; there are 0 'front', 1 'top', 2 '1'");
    EXPECT_EQ(error_of(Scene{}, view), "camera 'side': no such camera; the scene has none");
    view.camera = "3";
    EXPECT_EQ(error_of(with_cameras(), view).substr(0, 10), "camera '3'");
    view.camera = "-1";
    EXPECT_EQ(error_of(with_cameras(), view).substr(0, 11), "camera '-1'");
    Scene many;
    many.cameras.resize(30);
    EXPECT_TRUE(error_of(many, view).ends_with("19 '' and 10 more"));
}

TEST(Camera, RefusesEyesThatCannotSee)
{
    const Scene scene = box_scene({-1, -1, -1}, {1, 1, 1});
    View view = view_of(64, 64);
    view.fov = 40.0f;
    EXPECT_EQ(error_of(scene, view), "fov: an eye and a target are needed with it");
    view.target = Float3{1, 2, 3};
    EXPECT_EQ(error_of(scene, view), "target: an eye is needed with it");
    view.eye = view.target;
    EXPECT_EQ(error_of(scene, view), "eye: the same point as the target");
    view.target.reset();
    EXPECT_EQ(error_of(scene, view), "eye: a target is needed with it");
    view.target = Float3{0, 0, 0};
    for (const float fov : {0.0f, -1.0f, 180.0f, std::numeric_limits<float>::quiet_NaN()}) {
        view.fov = fov;
        EXPECT_EQ(error_of(scene, view), "fov: not between 0.001 and 180 degrees");
    }
    view.eye = Float3{std::numeric_limits<float>::infinity(), 0, 0};
    view.fov = 40.0f;
    EXPECT_EQ(error_of(scene, view), "eye: not finite");
}

TEST(Camera, RefusesCamerasThatCannotSee)
{
    const auto expect_refused = [](auto change, const std::string& fault) {
        Scene scene;
        scene.cameras.resize(1);
        change(scene.cameras[0]);
        EXPECT_EQ(error_of(scene, view_of(64, 64)), "camera 0 '': " + fault);
    };
    expect_refused([](Camera& c) { c.yfov = 0; }, "yfov must be between 0 and pi");
    expect_refused([](Camera& c) { c.yfov = 3.2f; }, "yfov must be between 0 and pi");
    expect_refused([](Camera& c) { c.aspect = -1; }, "its aspect is negative");
    expect_refused([](Camera& c) { c.znear = 0; }, "znear must be positive");
    expect_refused([](Camera& c) { c.zfar = c.znear; }, "zfar must exceed znear");
    expect_refused([](Camera& c) { c.orthographic = true, c.xmag = 0; },
                   "xmag and ymag must be finite and not 0");
    expect_refused([](Camera& c) { c.transform[12] = NAN; }, "its transform is not finite");
    expect_refused([](Camera& c) { c.transform[10] = 0; }, "its transform flattens space");
}

TEST(Camera, OwnEyeLooksAtItsTarget)
{
    const Scene scene = box_scene({-1, -1, -1}, {1, 1, 1});
    View view = view_of(200, 100);
    // Up and down too, where y can't be the picture's up.
    for (const Float3& eye : {Float3{3, 4, 5}, {0, 9, 0}, {0, -9, 0}, {1e-9f, 5, 0}}) {
        view.eye = eye;
        view.target = Float3{0, 0, 0};
        const Projection camera = resolve_camera(scene, view);
        const Projected at = project(camera, {0, 0, 0});
        EXPECT_NEAR(at.x, 0, 1e-12);
        EXPECT_NEAR(at.y, 0, 1e-12);
        EXPECT_NEAR(at.depth, std::hypot(eye[0], eye[1], eye[2]), 1e-6);
        EXPECT_NEAR(camera.scale_y, 1 / std::tan(20 * 3.14159265358979 / 180), 1e-12);
        EXPECT_NEAR(camera.scale_x, camera.scale_y / 2, 1e-12);
    }
    view.eye = Float3{0, 9, 0};
    const Projection down = resolve_camera(scene, view);
    EXPECT_GT(project(down, {0, 0, -1}).y, 0);
    EXPECT_GT(project(down, {1, 0, 0}).x, 0);
}

TEST(Camera, OwnEyeInsideTheSceneHasANearPlane)
{
    View view = view_of(64, 64);
    view.eye = Float3{0, 0, 0.5f};
    view.target = Float3{0, 0, 0};
    const Projection camera = resolve_camera(box_scene({-1, -1, -1}, {1, 1, 1}), view);
    EXPECT_GT(camera.znear, 0);
    EXPECT_LT(camera.znear, 1e-4);
}

TEST(Camera, PictureShowsAllThatThePerspectiveCameraWould)
{
    Scene scene;
    scene.cameras.resize(1);
    scene.cameras[0].yfov = 1;
    scene.cameras[0].aspect = 2;
    const double half = std::tan(0.5);
    const Projection wide = resolve_camera(scene, view_of(400, 100));
    EXPECT_NEAR(wide.scale_y * half, 1, 1e-7);
    EXPECT_NEAR(wide.scale_x * half * 4, 1, 1e-7);
    const Projection tall = resolve_camera(scene, view_of(100, 200));
    EXPECT_NEAR(tall.scale_x * half * 2, 1, 1e-7);
    EXPECT_NEAR(tall.scale_y * half * 4, 1, 1e-7);
    scene.cameras[0].aspect = 0;
    EXPECT_NEAR(resolve_camera(scene, view_of(100, 200)).scale_y * half, 1, 1e-7);
}

TEST(Camera, PictureShowsAllThatTheOrthographicCameraWould)
{
    Scene scene;
    scene.cameras.resize(1);
    Camera& camera = scene.cameras[0];
    camera.orthographic = true;
    camera.xmag = 4;
    camera.ymag = -2;  // glTF advises against it and allows it
    camera.zfar = 9;
    const Projection wide = resolve_camera(scene, view_of(400, 100));
    EXPECT_TRUE(wide.orthographic);
    EXPECT_DOUBLE_EQ(wide.scale_x, 1.0 / 8);
    EXPECT_DOUBLE_EQ(wide.scale_y, 1.0 / 2);
    EXPECT_EQ(wide.zfar, 9);
    const Projection tall = resolve_camera(scene, view_of(100, 100));
    EXPECT_DOUBLE_EQ(tall.scale_x, 1.0 / 4);
    EXPECT_DOUBLE_EQ(tall.scale_y, 1.0 / 4);
}

TEST(Camera, TransformPosesIt)
{
    Scene scene;
    scene.cameras.resize(1);
    // At (1, 2, 3), turned to look along -x, and scaled, which glTF's nodes may do.
    scene.cameras[0].transform = {0, 0, -3, 0, 0, 3, 0, 0, 3, 0, 0, 0, 1, 2, 3, 1};
    const Projection camera = resolve_camera(scene, view_of(64, 64));
    EXPECT_EQ(camera.eye[0], 1);
    EXPECT_EQ(camera.eye[1], 2);
    EXPECT_EQ(camera.eye[2], 3);
    const Projected ahead = project(camera, {-4, 2, 3});
    EXPECT_NEAR(ahead.x, 0, 1e-12);
    EXPECT_NEAR(ahead.y, 0, 1e-12);
    EXPECT_NEAR(ahead.depth, 5, 1e-12);
    EXPECT_GT(project(camera, {-4, 3, 3}).y, 0);
    EXPECT_GT(project(camera, {-4, 2, 2}).x, 0);
}

}  // namespace
}  // namespace sheer
