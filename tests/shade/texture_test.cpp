// Textures as pictures show them: what filtering must keep, whatever the footprint.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <sheer/sheer.h>

#include "image/color.h"
#include "shade/textured_wall.h"

namespace sheer::test {
namespace {

// Of a colour: half a step of the levels' 16 bits, and some roundings of floats.
constexpr float kStep = 0.5f / 65535 + 1e-6f;

void expect_all(const Image& image, const Float4& expected, float tolerance)
{
    for (const auto& pixel : image.pixels) {
        for (std::size_t c = 0; c < 4; ++c) ASSERT_NEAR(pixel[c], expected[c], tolerance);
    }
}

float linear(int encoded)
{
    return static_cast<float>(linear_from_srgb(encoded / 255.0));
}

// From a texel over many pixels to many over one, stretched, and mirrored.
constexpr float kScales[] = {0.01f, 0.3f, 1, 7.3f, 60, 5000};

}  // namespace

// Khronos' test of interpolation (glTF-Sample-Assets, TextureLinearInterpolationTest): two discs,
// one of a colour, the other halfway between two texels, are the same green, and would not be if
// encoded texels were mixed: half the light against .214 of it.
TEST(Texture, KhronosDiscsAreOfOneGreen)
{
    const char* folder = std::getenv("SHEER_SCENES");
    const std::string path =
        std::string(folder == nullptr ? "" : folder) +
        "/gltf/TextureLinearInterpolationTest/TextureLinearInterpolationTest.glb";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "SHEER_SCENES names no folder with it";
    View view;
    view.width = view.height = 256;
    view.samples = 1;
    Options options;
    options.method = "exact";
    const Image image = render(load(path), view, options).image;
    const auto& by_factor = image.pixels[152 * 256 + 73];
    const auto& by_texture = image.pixels[179 * 256 + 161];
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(by_factor[c], by_texture[c], 2 * kStep);
    EXPECT_NEAR(by_factor[1], 0.5f, 2 * kStep);
}

TEST(Texture, ConstantStaysConstant)
{
    for (const TexelFilter filter : {TexelFilter::nearest, TexelFilter::linear}) {
        for (const MipFilter mip : {MipFilter::none, MipFilter::nearest, MipFilter::linear}) {
            for (const float scale : kScales) {
                Wall wall(image_of(5, 3, std::vector<Rgba8>(15, {30, 200, 255, 51})), 0, 0, scale,
                          -3 * scale);
                wall.material().alpha_mode = AlphaMode::blend;
                wall.sampler() = {Wrap::repeat, Wrap::mirrored_repeat, filter, filter, mip};
                // Straight colour is the rounded premultiplied one divided by the opacity.
                const float a = 51 / 255.0f;
                expect_all(wall.draw(), {a * linear(30), a * linear(200), a * linear(255), a},
                           kStep);
            }
        }
    }
}

TEST(Texture, CheckersFadeToTheirMean)
{
    // One pixel over 2, 4, ... 64 texels. A square footprint's level of two texels or more is grey.
    for (const float texels : {2.0f, 3.0f, 5.7f, 64.0f}) {
        const float repeats = 16 * texels / 8;
        Wall wall(checkers(8), 0.1f, 0.3f, 0.1f + repeats, 0.3f + repeats);
        expect_all(wall.draw(), {0.5f, 0.5f, 0.5f, 1}, kStep);
    }
}

TEST(Texture, CheckersShowNoMoireTowardsTheHorizon)
{
    // A floor: rows of pixels farther and farther away. Where a pixel sees many checks along both
    // axes it is grey; half of one texel's difference is what trilinear filtering may leave where
    // it sees two.
    Wall wall(checkers(64), 0, 0, 40, 40);
    wall.scene.meshes[0].positions = {{-50, 0, -100}, {-50, 0, 0}, {50, 0, 0}, {50, 0, -100}};
    wall.scene.meshes[0].normals.clear();
    Camera camera;
    camera.transform[13] = 1.5f;
    camera.transform[14] = 1;
    camera.znear = 0.01f;
    wall.scene.cameras = {camera};
    wall.view.width = 64;
    wall.view.height = 64;
    const Image image = wall.draw();
    // Below the horizon the floor is at the distance h / tan(angle); 25.6 texels a metre.
    int rows = 0;
    for (int y = 34; y < 64; ++y) {
        const double slope = (y + 0.5 - 32) / 32 * std::tan(0.4);
        const double distance = 1.5 / slope, pixel = distance * std::tan(0.4) / 32;
        if (distance > 95 || pixel * 25.6 < 4) continue;
        ++rows;
        for (int x = 20; x < 44; ++x) EXPECT_NEAR(image.at(x, y)[0], 0.5f, 0.01f) << x << ' ' << y;
    }
    EXPECT_GT(rows, 3);
}

TEST(Texture, IsDecodedBeforeItIsFiltered)
{
    // Halfway between black and white lies half of the light.
    Wall wall(image_of(2, 1, {{0, 0, 0, 255}, {255, 255, 255, 255}}), 0.5f, 0, 0.5f, 1);
    expect_all(wall.draw(), {0.5f, 0.5f, 0.5f, 1}, kStep);
    // And far away the mean of 188, which is about half of the light, and 0 is a quarter.
    Wall far(image_of(2, 1, {{0, 0, 0, 255}, {188, 188, 188, 255}}), 0, 0, 320, 320);
    expect_all(far.draw(), {linear(188) / 2, linear(188) / 2, linear(188) / 2, 1}, kStep);
}

TEST(Texture, WrapsAsItsSamplerSays)
{
    // Red, green, blue from left to right; a pixel a texel, over three times the image's width.
    const std::vector<Rgba8> row = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}};
    const struct {
        Wrap wrap;
        const char* texels;
    } cases[] = {{Wrap::repeat, "rgbrgbrgb"},
                 {Wrap::mirrored_repeat, "bgrrgbbgr"},
                 {Wrap::clamp_to_edge, "rrrrgbbbb"}};
    for (const auto& [wrap, texels] : cases) {
        Wall wall(image_of(3, 1, row), -1, 0, 2, 0);
        wall.view.width = 9;
        wall.view.height = 1;
        wall.scene.cameras[0].ymag = 1.0f / 9;
        wall.sampler() = {wrap, Wrap::clamp_to_edge, TexelFilter::nearest, TexelFilter::nearest,
                          MipFilter::none};
        const Image image = wall.draw();
        for (int x = 0; x < 9; ++x) {
            const Float4 pixel = image.at(x, 0);
            EXPECT_EQ(pixel[0], texels[x] == 'r') << texels << x;
            EXPECT_EQ(pixel[1], texels[x] == 'g') << texels << x;
            EXPECT_EQ(pixel[2], texels[x] == 'b') << texels << x;
        }
    }
}

TEST(Texture, ClearTexelsLeaveNoHalo)
{
    // White leaves among texels that are clear, and black underneath or green: neither may show.
    for (const Rgba8 clear : {Rgba8{0, 0, 0, 0}, Rgba8{0, 255, 0, 0}}) {
        std::vector<Rgba8> texels;
        for (int i = 0; i < 64; ++i) {
            texels.push_back(i * 7 % 5 < 2 ? Rgba8{255, 255, 255, 255} : clear);
        }
        for (const float scale : kScales) {
            Wall wall(image_of(8, 8, texels), 0.2f, 0.1f, 0.2f + scale, 0.1f + 2 * scale);
            wall.material().alpha_mode = AlphaMode::blend;
            const Image image = wall.draw();
            for (const auto& pixel : image.pixels) {
                for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(pixel[c], pixel[3], 2 * kStep);
            }
        }
    }
}

TEST(Texture, TransformTurnsCoordinates)
{
    // The right half of the image, turned by a quarter: what was down is to the left.
    Wall wall(image_of(2, 2, {{1, 0, 0, 255}, {2, 0, 0, 255}, {3, 0, 0, 255}, {4, 0, 0, 255}}), 0,
              0, 1, 1);
    wall.material().base_color_texture->transform = {0, 1, 0, -1, 0, 1};
    wall.sampler().magnify = TexelFilter::nearest;
    const Image image = wall.draw();
    const auto texel = [&](int x, int y) { return std::lround(image.at(x, y)[0] * 12.92 * 255); };
    EXPECT_EQ(texel(2, 2), 3);    // (u, v) = (small, 1 - small)
    EXPECT_EQ(texel(13, 2), 1);   // (small, small)
    EXPECT_EQ(texel(2, 13), 4);   // (large, large)
    EXPECT_EQ(texel(13, 13), 2);  // (large, small)
}

TEST(Texture, HugeCoordinatesStayInsideOfTheImage)
{
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
        for (const MipFilter mip : {MipFilter::none, MipFilter::linear}) {
            for (const float scale : {5e9f, 1e30f, 3e38f}) {
                Wall wall(checkers(4), -scale, scale, scale, 1);
                wall.material().base_color_texture->transform = {scale, 0, scale, 0, scale, 5e9f};
                wall.sampler() = {wrap, wrap, TexelFilter::linear, TexelFilter::linear, mip};
                for (const auto& pixel : wall.draw().pixels) {
                    ASSERT_GE(pixel[0], 0);
                    ASSERT_LE(pixel[0], 1);
                }
            }
        }
    }
}

}  // namespace sheer::test
