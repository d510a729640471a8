// Coloured glass, x-ray views, lines and points, by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "shade/textured_wall.h"

namespace sheer::test {
namespace {

// A wall without a texture, under no light at all but for its own emission.
Wall plain_wall()
{
    Wall wall(image_of(1, 1, {{255, 255, 255, 255}}), 0, 0, 1, 1);
    wall.material().base_color_texture.reset();
    wall.scene.sun.color = {0, 0, 0};
    wall.scene.sky.up = wall.scene.sky.down = {0, 0, 0};
    wall.view.background = Float4{1, 1, 1, 1};
    return wall;
}

void expect_pixel(const Image& image, const Float4& expected)
{
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(image.at(8, 8)[c], expected[c], 1e-6f) << c;
}

}  // namespace

TEST(Glass, LetsEachChannelThroughByItself)
{
    Wall wall = plain_wall();
    wall.material().shading = Shading::metallic_roughness;
    wall.material().transmission = 1;
    wall.material().base_color = {0.5f, 0.25f, 1};
    wall.material().emission = {0.125f, 0, 0};
    expect_pixel(wall.draw(), {0.96f * 0.5f + 0.125f, 0.96f * 0.25f, 0.96f, 1});
    // A second pane behind it, blue: the products.
    wall.scene.materials.push_back(wall.material());
    wall.scene.materials[1].base_color = {0.1f, 0.2f, 1};
    wall.scene.materials[1].emission = {0, 0, 0};
    wall.scene.meshes.push_back(wall.scene.meshes[0]);
    wall.scene.meshes[1].material = 1;
    for (Float3& p : wall.scene.meshes[1].positions) p[2] = -1;
    wall.scene.objects.push_back(Object{"", 1, kIdentity, 1});
    const float t = 0.96f * 0.96f;
    expect_pixel(wall.draw(), {t * 0.05f + 0.125f, t * 0.05f, t, 1});
}

TEST(Glass, MethodsThatAreScalarTakeTheMean)
{
    Wall wall = plain_wall();
    wall.material().shading = Shading::metallic_roughness;
    wall.material().transmission = 0.5f;
    wall.material().base_color = {1, 0.5f, 0};
    Options options;
    options.method = "blend";
    const Image image = render(wall.scene, wall.view, options).image;
    expect_pixel(image, {0.24f, 0.24f, 0.24f, 1});  // 0.96 x 0.5 x the mean of 1, 0.5 and 0
}

TEST(Glass, ObjectsOpacityShowsWhatIsBehindOpaqueOnes)
{
    Wall wall = plain_wall();
    wall.material().shading = Shading::unlit;
    wall.material().base_color = {0.5f, 0, 0};
    expect_pixel(wall.draw(), {0.5f, 0, 0, 1});
    wall.scene.objects[0].opacity = 0.25f;
    expect_pixel(wall.draw(), {0.875f, 0.75f, 0.75f, 1});
    wall.scene.objects[0].opacity = 0;
    expect_pixel(wall.draw(), {1, 1, 1, 1});
}

TEST(Lines, AreAsWideAsTheySay)
{
    // Across the picture, a quarter of it wide in the object's own space, which is half as large.
    Wall wall = plain_wall();
    wall.material().shading = Shading::unlit;
    wall.view.background = Float4{0, 0, 0, 0};
    Mesh& mesh = wall.scene.meshes[0];
    mesh.topology = Topology::lines;
    mesh.positions = {{-4, 0, 0}, {0, 0, 0}, {4, 0, 0}};
    mesh.texcoords[0].clear();
    mesh.indices = {0, 1, 1, 2};
    mesh.width = 1;
    wall.scene.objects[0].transform = {0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 1};
    const auto alpha_sum = [&] {
        double sum = 0;
        for (const auto& pixel : wall.draw().pixels) sum += static_cast<double>(pixel[3]);
        return sum;
    };
    EXPECT_NEAR(alpha_sum(), 16 * 4, 1e-3);
    // Whole pixels, whatever the scale, where no width is said: 1.5 of 16, sampled four times.
    mesh.width = 0;
    EXPECT_NEAR(alpha_sum(), 16 * 1.5, 16 * 0.5);
    // Squares of half a metre.
    mesh.topology = Topology::points;
    mesh.indices = {1};
    mesh.width = 1;
    EXPECT_NEAR(alpha_sum(), 4 * 4, 1e-3);
}

TEST(Lines, RepeatedPointsChangeNothing)
{
    Wall wall = plain_wall();
    wall.material().shading = Shading::unlit;
    Mesh& mesh = wall.scene.meshes[0];
    mesh.topology = Topology::lines;
    mesh.texcoords[0].clear();
    mesh.width = 0.5f;
    mesh.positions = {{-0.5f, 0, 0}, {0.1f, 0.2f, 0}, {0.5f, 0, 0}};
    mesh.indices = {0, 1, 1, 2};
    const Image once = wall.draw();
    mesh.positions = {{-0.5f, 0, 0}, {0.1f, 0.2f, 0}, {0.1f, 0.2f, 0}, {0.5f, 0, 0}, {0.5f, 0, 0}};
    mesh.indices = {0, 1, 1, 2, 2, 3, 3, 4};
    EXPECT_EQ(wall.draw().pixels, once.pixels);
    mesh.indices = {3, 4};  // a piece without length
    for (const auto& pixel : wall.draw().pixels) EXPECT_EQ(pixel[0], 1);
}

TEST(Glass, NothingLetsMoreThroughThanThereIs)
{
    Wall wall = plain_wall();
    wall.material().shading = Shading::metallic_roughness;
    wall.material().transmission = 1;
    wall.material().base_color = {2.9f, 0, 0};
    for (std::uint32_t i = 1; i < 120; ++i) wall.scene.objects.push_back({"", 0, kIdentity, i});
    for (const auto& pixel : wall.draw().pixels) {
        EXPECT_EQ(pixel[0], 1);
        EXPECT_NEAR(pixel[1], 0, 1e-6f);
    }
}

TEST(Glass, MasksThatEverythingPassesAreSeenThrough)
{
    Wall wall = plain_wall();
    wall.material().shading = Shading::unlit;
    wall.material().base_color = {1, 0, 0};
    wall.material().alpha_mode = AlphaMode::mask;
    wall.material().alpha_cutoff = 0;
    wall.material().opacity = 0;
    wall.scene.objects[0].opacity = 0.5f;
    expect_pixel(wall.draw(), {1, 0.5f, 0.5f, 1});
}

TEST(Shading, LightAlongTheLineOfSightFromBehindIsFinite)
{
    // Normals that look away from the eye, and the sun where they look: no half vector.
    Wall wall = plain_wall();
    wall.material().shading = Shading::metallic_roughness;
    wall.material().base_color = {10, 10, 10};
    wall.material().metallic = 0.5f;
    wall.scene.meshes[0].normals = std::vector<Float3>(4, {0, 0, -1});
    wall.scene.sun = {{0, 0, -1}, {1, 1, 1}};
    for (const auto& pixel : wall.draw().pixels) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_TRUE(std::isfinite(pixel[c]));
            EXPECT_GE(pixel[c], 0);
        }
    }
}

TEST(Lines, PiecesOfOneLineCoverEachSampleOnce)
{
    // A bent ribbon of opacity 1/2: were pieces to overlap at the bend, it would be denser there.
    Wall wall = plain_wall();
    wall.material().shading = Shading::unlit;
    wall.material().alpha_mode = AlphaMode::blend;
    wall.material().opacity = 0.5f;
    wall.view.background = Float4{0, 0, 0, 0};
    Mesh& mesh = wall.scene.meshes[0];
    mesh.topology = Topology::lines;
    mesh.positions = {{-0.8f, -0.3f, 0}, {0, 0.2f, 0}, {0.7f, -0.5f, 0}};
    mesh.texcoords[0].clear();
    mesh.indices = {0, 1, 1, 2};
    mesh.width = 0.3f;
    float most = 0;
    for (const auto& pixel : wall.draw().pixels) most = std::max(most, pixel[3]);
    EXPECT_FLOAT_EQ(most, 0.5f);
}

}  // namespace sheer::test
