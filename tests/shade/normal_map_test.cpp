// Which way a normal texture bends a surface: red to the right, green up in the image.
#include <gtest/gtest.h>

#include "shade/textured_wall.h"

namespace sheer::test {
namespace {

// A white Lambertian wall under a sun alone; the texture's one normal is (x, y, z).
float radiance(const Float3& to_light, const Rgba8& normal, const Mat4& placed = kIdentity)
{
    Wall wall(image_of(1, 1, {normal}), 0, 0, 1, 1);
    wall.material().shading = Shading::diffuse;
    wall.material().double_sided = true;
    wall.material().normal_texture = wall.material().base_color_texture;
    wall.material().base_color_texture.reset();
    wall.scene.sun = {to_light, {1, 1, 1}};
    wall.scene.sky.up = wall.scene.sky.down = {0, 0, 0};
    wall.scene.objects[0].transform = placed;
    return wall.draw().at(8, 8)[0];
}

constexpr Rgba8 kRight = {255, 128, 128, 255}, kUp = {128, 255, 128, 255};
// 128 is 1/255 beyond the middle: the cosine of two such axes, at most.
constexpr float kOff = 0.01f;

}  // namespace

TEST(NormalMap, RedIsRightAndGreenIsUp)
{
    EXPECT_NEAR(radiance({1, 0, 0}, kRight), 1, kOff);
    EXPECT_NEAR(radiance({-1, 0, 0}, kRight), 0, kOff);
    EXPECT_NEAR(radiance({0, 1, 0}, kRight), 0, kOff);
    EXPECT_NEAR(radiance({0, 1, 0}, kUp), 1, kOff);
    EXPECT_NEAR(radiance({0, -1, 0}, kUp), 0, kOff);
    EXPECT_NEAR(radiance({0, 0, 1}, {128, 128, 255, 255}), 1, kOff);
}

TEST(NormalMap, TurnsAndMirrorsWithTheObject)
{
    // A quarter turn about z takes right to up and up to left.
    const Mat4 turned = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_NEAR(radiance({0, 1, 0}, kRight, turned), 1, kOff);
    EXPECT_NEAR(radiance({-1, 0, 0}, kUp, turned), 1, kOff);
    // In a mirror left is right, and up stays up.
    const Mat4 mirrored = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_NEAR(radiance({-1, 0, 0}, kRight, mirrored), 1, kOff);
    EXPECT_NEAR(radiance({0, 1, 0}, kUp, mirrored), 1, kOff);
}

}  // namespace sheer::test
