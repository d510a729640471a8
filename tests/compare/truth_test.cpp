// The truth: where its samples are, and that more of them come closer to what is known.
#include "compare/truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include <sheer/sheer.h>

#include "compare/metrics.h"

namespace sheer {

namespace {

View view_of(int size)
{
    View view;
    view.width = view.height = size;
    return view;
}

// A white, opaque rectangle from the left edge of the picture to `edge`, in pixels, before black,
// in a picture of one pixel.
Scene half_plane(float edge, bool vertical)
{
    Scene scene;
    scene.background = Float4{0, 0, 0, 1};
    Material white;
    white.shading = Shading::unlit;
    white.double_sided = true;
    white.alpha_mode = AlphaMode::blend;
    scene.materials.push_back(white);
    Mesh mesh;
    const float right = 2 * edge - 1;  // -1 to 1 over the picture
    if (vertical) {
        mesh.positions = {{-4, -4, -1}, {right, -4, -1}, {right, 4, -1}, {-4, 4, -1}};
    } else {
        mesh.positions = {{-4, -4, -1}, {4, -4, -1}, {4, right, -1}, {-4, right, -1}};
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
    scene.objects.push_back({});
    Camera camera;
    camera.orthographic = true;
    scene.cameras.push_back(camera);
    return scene;
}

}  // namespace

// With a sample in each of the 256 columns and rows of the pixel, an upright or level edge, which
// lies on the same grid, is off by half a sample at most.
TEST(Truth, EdgesAreExactToHalfASample)
{
    for (const bool vertical : {false, true}) {
        for (int i = 0; i <= 64; ++i) {
            const float edge = static_cast<float>(i) / 64.0f;
            const Image image = render_truth(half_plane(edge, vertical), view_of(1), {});
            EXPECT_NEAR(image.at(0, 0)[0], edge, 0.5 / 256 + 1e-6) << edge;
        }
    }
}

TEST(Truth, NumbersOfSamples)
{
    View view = view_of(8);
    EXPECT_EQ(truth_samples(view), 256);
    EXPECT_EQ(truth_samples(view, 16), 1024);
    view.positions = SamplePositions::center;
    EXPECT_EQ(truth_samples(view), 64);
}

// At the centre every sample is the same: one is as good as all.
TEST(Truth, OfSamplesAtTheCentre)
{
    View view = view_of(48);
    view.positions = SamplePositions::center;
    const Scene scene = load("builtin:quads");
    const Image truth = render_truth(scene, view, {});
    view.samples = 1;
    const Image one = render(scene, view, {}).image;
    // The mean of 64 equal numbers is rounded six times.
    EXPECT_LT(compare_images(truth, one).largest, 255 * 6 * 0x1p-23);
}

// 64, 256 and 1,024 samples: the error against the last falls, and as that of stratified samples
// at edges does or better: to less than a half for four times as many (independent samples: a
// half).
TEST(Truth, Converges)
{
    for (const char* name : {"builtin:motor", "builtin:quads"}) {
        const Scene scene = load(name);
        const View view = view_of(64);
        const Image most = render_truth(scene, view, {}, 16);
        const double of_64 = compare_images(render_truth(scene, view, {}, 1), most).rmse;
        const double of_256 = compare_images(render_truth(scene, view, {}, 4), most).rmse;
        EXPECT_GT(of_64, 0) << name;
        EXPECT_LT(of_256, 0.5 * of_64) << name;
        RecordProperty(std::string(name) + " 64", std::to_string(of_64));
        RecordProperty(std::string(name) + " 256", std::to_string(of_256));
    }
}

}  // namespace sheer
