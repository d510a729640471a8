// sorted-blend: right where objects, or triangles, can be sorted, and the same for every order of
// submission.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "geometry/object_distances.h"

namespace sheer {

namespace {

View small_view()
{
    View view;
    view.width = 96;
    view.height = 64;
    view.samples = 4;
    return view;
}

Image picture(const Scene& scene, const std::string& method)
{
    Options options;
    options.method = method;
    return render(scene, small_view(), options).image;
}

// Panes of glass one behind the other, each a mesh of its own around its object's origin.
Scene panes(int count, bool in_one_mesh)
{
    Scene scene;
    scene.background = Float4{0.2f, 0.2f, 0.2f, 1};
    for (int i = 0; i < count; ++i) {
        Material glass;
        glass.base_color = {i % 2 == 0 ? 1.0f : 0.1f, 0.3f, i % 3 == 0 ? 0.9f : 0.2f};
        glass.opacity = 0.4f;
        glass.alpha_mode = AlphaMode::blend;
        glass.double_sided = true;
        glass.shading = Shading::unlit;
        const float z = -2.0f - 0.5f * static_cast<float>(i);
        Mesh pane;
        pane.positions = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
        pane.indices = {0, 1, 2, 0, 2, 3};
        pane.material = in_one_mesh ? 0 : static_cast<std::uint32_t>(i);
        scene.materials.push_back(glass);
        if (in_one_mesh && i > 0) {
            Mesh& all = scene.meshes.front();
            const auto first = static_cast<std::uint32_t>(all.positions.size());
            all.positions.insert(all.positions.end(), pane.positions.begin(), pane.positions.end());
            for (const std::uint32_t index : pane.indices) all.indices.push_back(first + index);
            // Colours differ by vertex instead of by material.
            continue;
        }
        scene.meshes.push_back(pane);
        Object object;
        object.mesh = static_cast<std::uint32_t>(scene.meshes.size() - 1);
        object.id = static_cast<std::uint32_t>(i);
        scene.objects.push_back(object);
    }
    if (in_one_mesh) {
        Mesh& all = scene.meshes.front();
        for (std::size_t v = 0; v < all.positions.size(); ++v) {
            const float shade = static_cast<float>(v / 4) / static_cast<float>(count);
            all.colors.push_back({shade, 1 - shade, 0.5f, 1});
        }
    }
    Camera camera;
    camera.znear = 0.1f;
    scene.cameras.push_back(camera);
    return scene;
}

// Composites of ten layers, each of a few roundings, in two different orders of summation.
constexpr double kRounding = 255 * 10 * 8 * 0x1p-24;

}  // namespace

TEST(SortedBlend, ObjectsThatDoNotInterlockAreRight)
{
    const Scene scene = panes(10, false);  // the nearest is submitted first
    const Image exact = picture(scene, "exact");
    EXPECT_LT(compare_images(picture(scene, "sorted-blend:by=object"), exact).largest, kRounding);
    EXPECT_LT(compare_images(picture(scene, "sorted-blend:by=triangle"), exact).largest, kRounding);
    EXPECT_GT(compare_images(picture(scene, "blend"), exact).rmse, 1);
}

// Within one object, by=object draws the triangles as they come.
TEST(SortedBlend, TrianglesOfOneObjectAreSortedByTriangleOnly)
{
    const Scene scene = panes(10, true);
    const Image exact = picture(scene, "exact");
    EXPECT_LT(compare_images(picture(scene, "sorted-blend:by=triangle"), exact).largest, kRounding);
    EXPECT_EQ(picture(scene, "sorted-blend:by=object").pixels, picture(scene, "blend").pixels);
}

// Panes at equal distance: the greater id counts as the farther, as it does for every method.
TEST(SortedBlend, TiesGoById)
{
    Scene scene = panes(2, false);
    scene.meshes[1].positions = scene.meshes[0].positions;
    const Image exact = picture(scene, "exact");
    for (int round = 0; round < 2; ++round) {
        EXPECT_LT(compare_images(picture(scene, "sorted-blend"), exact).largest, kRounding);
        EXPECT_LT(compare_images(picture(scene, "sorted-blend:by=triangle"), exact).largest,
                  kRounding);
        std::swap(scene.objects[0], scene.objects[1]);
    }
}

TEST(SortedBlend, AnyOrderOfSubmissionGivesTheSameBits)
{
    std::mt19937 random(4);
    for (const char* name : {"builtin:quads", "builtin:motor"}) {
        Scene scene = load(name);
        const Image by_object = picture(scene, "sorted-blend:by=object");
        const Image by_triangle = picture(scene, "sorted-blend:by=triangle");
        for (int round = 0; round < 3; ++round) {
            std::shuffle(scene.objects.begin(), scene.objects.end(), random);
            EXPECT_EQ(picture(scene, "sorted-blend:by=object").pixels, by_object.pixels);
            EXPECT_EQ(picture(scene, "sorted-blend:by=triangle").pixels, by_triangle.pixels);
        }
    }
}

TEST(ObjectDistances, AreThoseOfTheCentresOfBounds)
{
    const Scene scene = panes(3, false);
    const Projection projection = resolve_camera(scene, small_view());
    const std::vector<float> distances = object_distances(scene, projection);
    ASSERT_EQ(distances.size(), 3u);
    EXPECT_FLOAT_EQ(distances[0], 2.0f);
    EXPECT_FLOAT_EQ(distances[1], 2.5f);
    EXPECT_FLOAT_EQ(distances[2], 3.0f);
}

TEST(ObjectDistances, FollowTheObjectAndTheCamera)
{
    Scene scene = panes(1, false);
    scene.objects[0].transform = {0,  0, 2, 0, 0, 1, 0, 0,
                                  -2, 0, 0, 0, 1, 0, 5, 1};  // turned, moved
    View view = small_view();
    view.eye = Float3{10, 0, 5};
    view.target = Float3{0, 0, 5};
    const auto distances = object_distances(scene, resolve_camera(scene, view));
    // The centre (0, 0, -2) goes to (4 + 1, 0, 5).
    EXPECT_FLOAT_EQ(distances[0], 5.0f);
}

}  // namespace sheer
