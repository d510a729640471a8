// The geometry stage by what it makes seen: flat normals, mirrored objects, culling, clipping.
#include <gtest/gtest.h>

#include <cmath>

#include <sheer/sheer.h>

namespace sheer {

namespace {

// A pyramid of four faces and no base, its tip towards +z, wound counter-clockwise from outside.
Mesh pyramid()
{
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}};
    mesh.indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
    return mesh;
}

// The same with the faces' normals written out.
Mesh pyramid_with_normals()
{
    const Mesh welded = pyramid();
    const float s = std::sqrt(0.5f);
    const Float3 normals[4] = {{0, -s, s}, {s, 0, s}, {0, s, s}, {-s, 0, s}};
    Mesh mesh;
    for (std::uint32_t i = 0; i < 12; ++i) {
        mesh.positions.push_back(welded.positions[welded.indices[i]]);
        mesh.normals.push_back(normals[i / 3]);
        mesh.indices.push_back(i);
    }
    return mesh;
}

Scene one_object(const Mesh& mesh, const Mat4& transform, bool double_sided)
{
    Scene scene;
    scene.materials.emplace_back();
    scene.materials[0].double_sided = double_sided;
    scene.meshes = {mesh};
    Object object;
    object.transform = transform;
    scene.objects = {object};
    scene.background = Float4{0, 0, 0, 0};
    return scene;
}

View from_the_front()
{
    View view;
    view.width = view.height = 64;
    view.eye = Float3{0.3f, 0.2f, 4};
    view.target = Float3{0, 0, 0};
    return view;
}

double largest_difference(const Image& a, const Image& b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
            const double d =
                static_cast<double>(a.pixels[i][c]) - static_cast<double>(b.pixels[i][c]);
            largest = std::max(largest, std::abs(d));
        }
    }
    return largest;
}

double mean_alpha(const Image& image)
{
    double sum = 0;
    for (const auto& p : image.pixels) sum += static_cast<double>(p[3]);
    return sum / static_cast<double>(image.pixels.size());
}

constexpr Mat4 kMirrored = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
constexpr Mat4 kTiny = {1e-6f, 0, 0, 0, 0, 1e-6f, 0, 0, 0, 0, 1e-6f, 0, 0, 0, 0, 1};

}  // namespace

TEST(Geometry, WithoutNormalsTrianglesAreFlat)
{
    for (const Mat4& transform : {kIdentity, kMirrored}) {
        const Image flat =
            render(one_object(pyramid(), transform, false), from_the_front(), {}).image;
        const Image expected =
            render(one_object(pyramid_with_normals(), transform, false), from_the_front(), {})
                .image;
        EXPECT_GT(mean_alpha(flat), 0.1);
        // Normals of length 1 in floats, then a few roundings of terms below 1.
        EXPECT_LE(largest_difference(flat, expected), 16 * 0x1p-24);
    }
}

TEST(Geometry, FlatNormalsSurviveTinyObjects)
{
    View view = from_the_front();
    view.eye = Float3{0.3e-6f, 0.2e-6f, 4e-6f};
    const Image tiny = render(one_object(pyramid(), kTiny, false), view, {}).image;
    const Image normal =
        render(one_object(pyramid(), kIdentity, false), from_the_front(), {}).image;
    // The camera's own rounding moves an edge by less than a sample now and then.
    EXPECT_LE(std::abs(mean_alpha(tiny) - mean_alpha(normal)), 0.01);
    EXPECT_NEAR(static_cast<double>(tiny.at(32, 40)[0]), static_cast<double>(normal.at(32, 40)[0]),
                1e-4);
}

TEST(Geometry, BackFacesShowOnlyWhereDoubleSided)
{
    View behind = from_the_front();
    behind.eye = Float3{0.3f, 0.2f, -4};
    EXPECT_EQ(mean_alpha(render(one_object(pyramid(), kIdentity, false), behind, {}).image), 0);
    EXPECT_GT(mean_alpha(render(one_object(pyramid(), kIdentity, true), behind, {}).image), 0.1);
    EXPECT_EQ(mean_alpha(render(one_object(pyramid(), kMirrored, false), behind, {}).image), 0);
}

// Products that leave the floats, or are no numbers at all, draw nothing.
TEST(Geometry, TrianglesOutOfReachAreDropped)
{
    for (const float scale : {1e20f, 1e30f, 3e38f}) {
        const Mat4 huge = {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, 0, scale, 1};
        Scene scene = one_object(pyramid(), huge, true);
        scene.meshes[0].positions[4] = {1e3f, -1e3f, 1e10f};
        const Image image = render(scene, from_the_front(), {}).image;
        for (const auto& pixel : image.pixels) {
            for (const float c : pixel) EXPECT_TRUE(std::isfinite(c));
        }
    }
}

// A floor that runs behind the eye: clipped at the near plane, its lower half fills the picture.
TEST(Geometry, ClippingKeepsWhatIsInFront)
{
    Mesh floor;
    floor.positions = {{-1e4f, -1, 1e4f}, {1e4f, -1, 1e4f}, {1e4f, -1, -1e4f}, {-1e4f, -1, -1e4f}};
    floor.indices = {0, 1, 2, 0, 2, 3};
    View view = from_the_front();
    view.eye = Float3{0, 0, 0};
    view.target = Float3{0, 0, -1};
    const Image image = render(one_object(floor, kIdentity, true), view, {}).image;
    for (int x = 0; x < 64; ++x) {
        EXPECT_EQ(image.at(x, 63)[3], 1.0f);
        EXPECT_EQ(image.at(x, 34)[3], 1.0f);
        EXPECT_EQ(image.at(x, 30)[3], 0.0f);
    }
}

}  // namespace sheer
