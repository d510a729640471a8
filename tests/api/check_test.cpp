// What a program may hand over, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include <sheer/sheer.h>

namespace sheer {

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Scene one_triangle()
{
    Scene scene;
    scene.materials.emplace_back();
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = {0, 1, 2};
    scene.meshes = {mesh};
    scene.objects.emplace_back();
    return scene;
}

std::string error_of(const std::function<void(Scene&, View&)>& spoil)
{
    Scene scene = one_triangle();
    View view;
    view.width = view.height = 4;
    spoil(scene, view);
    try {
        render(scene, view, {});
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "";
}

}  // namespace

TEST(Check, ASoundSceneIsDrawn)
{
    EXPECT_EQ(error_of([](Scene&, View&) {}), "");
    EXPECT_EQ(error_of([](Scene& s, View&) { s.meshes[0].positions[1] = {2e38f, 2e38f, 0}; }), "");
}

TEST(Check, ShadingIsInRange)
{
    const auto refused = [](auto&& spoil) {
        return error_of([&](Scene&, View& view) { spoil(view); });
    };
    EXPECT_EQ(refused([](View& v) { v.ambient_occlusion.rays = 65; }),
              "ambient-occlusion: 65 is not between 0 and 64");
    EXPECT_EQ(refused([](View& v) { v.ambient_occlusion.radius = kNan; }),
              "ambient-occlusion: radius: it is not between 0 and 1000000");
    EXPECT_EQ(refused([](View& v) {
                  v.foveation = Foveation{kNan, 0, 1};
              }),
              "foveate: X: it is not between -1000000 and 1000000");
    EXPECT_EQ(refused([](View& v) {
                  v.foveation = Foveation{0, 0, -1};
              }),
              "foveate: R: it is not between 0 and 1000000");
    EXPECT_EQ(refused([](View& v) { v.foveation = Foveation{0, -9, 0}; }), "");
}

TEST(Check, WhatIsNoNumberIsRefused)
{
    EXPECT_EQ(error_of([](Scene& s, View&) { s.meshes[0].positions[1][2] = kNan; }),
              "mesh 0: a position is not finite");
    EXPECT_EQ(error_of([](Scene& s, View&) {
                  s.meshes[0].normals.assign(3, {0, kInfinity, 0});
              }),
              "mesh 0: a normal is not between -1,000,000 and 1,000,000");
    EXPECT_EQ(error_of([](Scene& s, View&) {
                  s.meshes[0].colors.assign(3, {0, -1, 0, 1});
              }),
              "mesh 0: a colour is not between 0 and 1,000,000");
    EXPECT_EQ(error_of([](Scene& s, View&) { s.materials[0].base_color[0] = kNan; }),
              "material 0: its colour is not between 0 and 1,000,000");
    EXPECT_EQ(error_of([](Scene& s, View&) { s.materials[0].opacity = 1.5f; }),
              "material 0: its opacity is not between 0 and 1");
    EXPECT_EQ(error_of([](Scene& s, View&) { s.objects[0].transform[12] = kInfinity; }),
              "object 0: its transform is not finite");
    EXPECT_EQ(error_of([](Scene& s, View&) {
                  s.background = Float4{kNan, 0, 0, 1};
              }),
              "the scene's background is not between 0 and 1,000,000");
    EXPECT_NE(error_of([](Scene& s, View&) { s.sun.to_light[1] = kNan; }), "");
}

TEST(Check, WhatDoesNotExistIsRefused)
{
    EXPECT_EQ(error_of([](Scene& s, View&) { s.meshes[0].indices[2] = 3; }),
              "mesh 0: an index is beyond its positions");
    EXPECT_EQ(error_of([](Scene& s, View&) { s.meshes[0].material = 1; }),
              "mesh 0: its material does not exist");
    EXPECT_EQ(error_of([](Scene& s, View&) { s.objects[0].material = 1; }),
              "object 0: its material does not exist");
    EXPECT_EQ(error_of([](Scene& s, View&) { s.objects.push_back(s.objects[0]); }),
              "object 1: its id 0 is taken");
    EXPECT_EQ(error_of([](Scene&, View& v) { v.samples = 3; }),
              "samples: 3 is not one of 1, 2, 4, 8, 16, 32, 64");
    EXPECT_EQ(error_of([](Scene&, View& v) { v.width = 200000; }),
              "size: 200000x4 is not between 1x1 and 16384x16384");
}

// Many thin triangles far outside of what floats bear, transparent and opaque: nothing is read out
// of bounds, every thread count gives the same picture, and no pixel is other than a number.
TEST(Check, HugeScalesKeepThePictureSound)
{
    for (const AlphaMode mode : {AlphaMode::blend, AlphaMode::opaque}) {
        for (const float scale : {1e10f, 1e17f, 1e25f, 1e38f}) {
            Scene scene = one_triangle();
            scene.materials[0].alpha_mode = mode;
            scene.materials[0].opacity = 0.5f;
            scene.materials[0].double_sided = true;
            Mesh& mesh = scene.meshes[0];
            mesh.positions.clear();
            mesh.indices.clear();
            for (std::uint32_t i = 0; i < 300; ++i) {
                const float x = static_cast<float>(i) * 0.01f - 1.5f;
                mesh.positions.push_back({x, -1, 0.1f});
                mesh.positions.push_back({x + 0.02f, -1, 0.2f});
                mesh.positions.push_back({x, 1, -0.9f});
                for (std::uint32_t k = 0; k < 3; ++k) mesh.indices.push_back(3 * i + k);
            }
            scene.objects[0].transform[10] = scale;
            Camera camera;
            camera.orthographic = true;
            camera.znear = 0;
            camera.transform[14] = 1;
            scene.cameras = {camera};
            View view;
            view.width = 100;
            view.height = 70;
            view.samples = 4;
            Options options;
            options.threads = 1;
            const Image one = render(scene, view, options).image;
            options.threads = 3;
            EXPECT_EQ(render(scene, view, options).image.pixels, one.pixels) << scale;
            for (const auto& pixel : one.pixels) {
                for (const float c : pixel) ASSERT_TRUE(std::isfinite(c)) << scale;
            }
        }
    }
}

}  // namespace sheer
