// MASK surfaces that are rasterised conservatively: what whole pictures add up to.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <sheer/error.h>
#include <sheer/sheer.h>

namespace sheer::test {
namespace {

// Corners in pixels of a picture 80 pixels wide and high, x to the right and y down; unlit, square
// on, with an opacity of 0.8 and of another red at each corner.
struct OneTriangle {
    Scene scene;
    View view;
    double area;

    OneTriangle(const std::vector<Float3>& corners, int samples)
    {
        Material material;
        material.shading = Shading::unlit;
        material.alpha_mode = AlphaMode::mask;
        material.alpha_cutoff = 0.5f;
        material.opacity = 0.8f;
        material.double_sided = true;
        scene.materials = {material};
        Mesh mesh;
        for (const Float3& c : corners) {
            mesh.positions.push_back({c[0] / 40 - 1, 1 - c[1] / 40, 0});
            mesh.colors.push_back({c[2], 0, 0, 1});
        }
        mesh.indices = {0, 1, 2};
        scene.meshes = {mesh};
        scene.objects = {Object{}};
        Camera camera;
        camera.orthographic = true;
        camera.transform[14] = 1;
        scene.cameras = {camera};
        view.width = view.height = 80;
        view.samples = samples;
        view.background = Float4{0, 0, 0, 0};
        const auto along = [&](std::size_t i, std::size_t c) {
            return static_cast<double>(corners[i][c] - corners[0][c]);
        };
        area = std::abs(along(1, 0) * along(2, 1) - along(1, 1) * along(2, 0)) / 2;
    }
    // Nothing is opaque: all of it is blended.
    Image draw(Conservative how)
    {
        view.conservative = how;
        Options options;
        options.method = "alpha-test-then-blend:cutoff=1.0";
        return render(scene, view, options).image;
    }
};

double sum_of(const Image& image, std::size_t channel)
{
    double sum = 0;
    for (const Float4& pixel : image.pixels) sum += static_cast<double>(pixel[channel]);
    return sum;
}

// Corners on multiples of 1/8 pixel, which the 1/256 pixel grid holds.
const std::vector<std::vector<Float3>> kTriangles = {
    {{10.125f, 20.25f, 0.2f}, {10.5f, 20.375f, 0.6f}, {10.25f, 20.75f, 1.0f}},   // in one pixel
    {{31.75f, 31.875f, 0.1f}, {32.25f, 31.75f, 0.5f}, {32.125f, 32.5f, 0.9f}},   // on four tiles
    {{3.125f, 5.5f, 0.3f}, {76.5f, 9.25f, 0.1f}, {40.75f, 74.125f, 0.8f}},       // large
    {{1.125f, 40.125f, 1.0f}, {79.0f, 40.25f, 0.0f}, {79.125f, 40.375f, 0.5f}},  // a sliver
};

// Red is linear over the triangle, so that what pixels have of it adds up to the triangle's mean
// red times its area if each is shaded at the centroid of its part. A pixel's opacity is rounded in
// a few operations, its red in ten more: weights reach some hundreds outside of small triangles,
// before they are moved back to the centroid.
TEST(Conservative, AreasAndColorsAddUp)
{
    for (const int samples : {1, 4, 64}) {
        for (const auto& corners : kTriangles) {
            OneTriangle one(corners, samples);
            const Image image = one.draw(Conservative::area);
            const double red = static_cast<double>(corners[0][2] + corners[1][2] + corners[2][2]);
            EXPECT_NEAR(sum_of(image, 3) / (0.8 * one.area), 1, 1e-4);
            EXPECT_NEAR(sum_of(image, 0) / (0.8 * one.area * red / 3), 1, 1e-3);
        }
    }
}

TEST(Conservative, TouchedPixelsAreCoveredAsAWhole)
{
    for (const auto& corners : kTriangles) {
        OneTriangle one(corners, 1);
        const Image parts = one.draw(Conservative::area);
        const Image touched = one.draw(Conservative::touched);
        std::size_t count = 0;
        for (std::size_t i = 0; i < touched.pixels.size(); ++i) {
            EXPECT_EQ(touched.pixels[i][3] > 0, parts.pixels[i][3] > 0);
            if (!(touched.pixels[i][3] > 0)) continue;
            EXPECT_FLOAT_EQ(touched.pixels[i][3], 0.8f);
            ++count;
        }
        EXPECT_GE(static_cast<double>(count), one.area);
    }
    // No pixel's centre is in it.
    OneTriangle small(kTriangles[0], 1);
    EXPECT_EQ(sum_of(small.draw(Conservative::off), 3), 0);
    EXPECT_NEAR(sum_of(small.draw(Conservative::touched), 3), 0.8, 1e-6);
}

// An alpha test by the opacity that is left: 0.8 times the part reaches 0.5 from 5/8 on.
TEST(Conservative, AlphaTestsSeeTheOpacityThatIsLeft)
{
    OneTriangle one(kTriangles[2], 1);
    const Image parts = one.draw(Conservative::area);
    Options options;
    options.method = "alpha-test";
    const Image tested = render(one.scene, one.view, options).image;
    for (std::size_t i = 0; i < tested.pixels.size(); ++i) {
        EXPECT_EQ(tested.pixels[i][3], parts.pixels[i][3] >= 0.5f ? 1 : 0);
    }
}

TEST(Conservative, OtherSurfacesStayAsTheyAre)
{
    for (const char* name : {"builtin:quads", "builtin:hair?strands=400"}) {
        const Scene scene = load(name);
        View view;
        view.width = view.height = 100;
        view.samples = 4;
        const Image expected = render(scene, view, {}).image;
        view.conservative = Conservative::area;
        EXPECT_EQ(render(scene, view, {}).image.pixels, expected.pixels) << name;
    }
}

TEST(Conservative, IsRefusedWithShadingAtSamples)
{
    OneTriangle one(kTriangles[0], 4);
    one.view.shade_at = ShadeAt::sample;
    EXPECT_THROW(one.draw(Conservative::area), Error);
}

}  // namespace
}  // namespace sheer::test
