// What materials make of a fragment, seen in pictures of one wall: by hand from docs/numerics.md.
#include <gtest/gtest.h>

#include <cmath>

#include "near.h"
#include "small_images.h"
#include "small_scenes.h"

namespace sheer::reference {
namespace {

TEST(ReferenceShading, EachPixelReadsItsTexel)
{
    // Four texels on four pixels; then from the right to the left, and by the second set.
    SmallScene small;
    small.scene.images = {row_of({0, 255, 0, 0})};
    Material material = unlit(AlphaMode::opaque, {0.5f, 1, 2}, 1);
    material.base_color_texture = paper(0, 4, 1);
    small.add_papered_wall(material, 0, 1);
    Texture& texture = *small.scene.materials[0].base_color_texture;
    const auto lit_pixel = [&] {
        const Picture picture = small.render(small_view(4, 4, 1));
        int lit = -1;
        for (int i = 0; i < 16; ++i) {
            const Rgba& pixel = picture.pixels[static_cast<std::size_t>(i)];
            if (pixel.r > 0) {
                expect_near(pixel, {0.5, 1, 2, 1});
                lit = lit < 0 ? i : lit;
            }
        }
        return lit;
    };
    EXPECT_EQ(lit_pixel(), 1);
    texture.transform = {-0.25f, 0, 1, 0, 1, 0};
    EXPECT_EQ(lit_pixel(), 2);
    texture.transform = {0.25f, 0, 0, 0, 1, 0};
    texture.set = 1;
    EXPECT_EQ(lit_pixel(), 4);
}

TEST(ReferenceShading, VertexColorsAndDecodedTexelsMultiply)
{
    SmallScene small;
    small.scene.images = {image_of(1, 1, {{255, 10, 0, 255}})};
    Material material = unlit(AlphaMode::opaque, {0.5f, 0.5f, 0.5f}, 1);
    material.base_color_texture = plain_paper(0);
    small.add_papered_wall(material, 0, 1);
    for (Attributes& attributes : small.geometry.attributes) {
        attributes.color = {0.25f, 4, 1, 0.5f};
    }
    View view = small_view(1, 1, 1);
    view.exposure = 3;
    expect_near(small.render(view).pixels[0],
                {8 * 0.125, 8 * 2 * in_16_bits(10 / 255.0 / 12.92), 0, 1});
}

TEST(ReferenceShading, MeshesWithoutCoordinatesAreAtTheOrigin)
{
    SmallScene small;
    small.scene.images = {row_of({255, 0, 0, 0})};
    Material material = unlit(AlphaMode::opaque, {1, 1, 1}, 1);
    material.base_color_texture = paper(0, 1, 1);
    small.add_papered_wall(material, 0, 1);
    small.geometry.texture_attributes.clear();
    for (const Rgba& pixel : small.render(small_view(3, 3, 1)).pixels) {
        expect_near(pixel, {1, 1, 1, 1});
    }
}

TEST(ReferenceShading, TexturesAlphaIsTheAlphaModes)
{
    // A factor of 1/2 times 51 / 255.
    SmallScene small;
    small.scene.images = {image_of(1, 1, {{255, 0, 0, 51}})};
    Material material = unlit(AlphaMode::opaque, {1, 1, 1}, 0.5f);
    material.base_color_texture = plain_paper(0);
    small.add_papered_wall(material, 0, 1);
    Material& used = small.scene.materials[0];
    expect_near(pixel_of(small), {1, 0, 0, 1});
    used.alpha_mode = AlphaMode::blend;
    expect_near(pixel_of(small), {0.1, 0, 0, 0.1});
    used.alpha_mode = AlphaMode::mask;
    expect_near(pixel_of(small), {0, 0, 0, 0});
    used.alpha_cutoff = 0.0625f;
    expect_near(pixel_of(small), {1, 0, 0, 1});
}

TEST(ReferenceShading, MinifiedTexturesMix)
{
    // Black and white texels by turns, two on each pixel: grey in each.
    SmallScene small;
    small.scene.images = {image_of(
        2, 2, {{0, 0, 0, 255}, {255, 255, 255, 255}, {255, 255, 255, 255}, {0, 0, 0, 255}})};
    Material material = unlit(AlphaMode::opaque, {1, 1, 1}, 1);
    material.base_color_texture = plain_paper(0);
    material.base_color_texture->sampler = {};
    small.add_papered_wall(material, 0, 1);
    for (const Rgba& pixel : small.render(small_view(3, 3, 4)).pixels) {
        const double gray = in_16_bits(0.5);
        expect_near(pixel, {gray, gray, gray, 1});
    }
}

TEST(ReferenceShading, ObjectsOpacityMakesTransparent)
{
    SmallScene small;
    small.scene.images = {image_of(1, 1, {{255, 255, 255, 51}})};
    Material material = unlit(AlphaMode::opaque, {1, 0, 0}, 0.5f);
    small.add_papered_wall(material, 0, 1);
    small.scene.objects[0].opacity = 0.25f;
    Material& used = small.scene.materials[0];
    const Float4 green = {0, 1, 0, 1};
    expect_near(pixel_of(small, green), {0.25, 0.75, 0, 1});
    used.alpha_mode = AlphaMode::blend;
    expect_near(pixel_of(small, green), {0.125, 0.875, 0, 1});
    used.alpha_mode = AlphaMode::mask;  // what passes is opaque before
    used.alpha_cutoff = 0.25f;
    expect_near(pixel_of(small, green), {0.25, 0.75, 0, 1});
    used.alpha_cutoff = 0.75f;
    expect_near(pixel_of(small, green), {0, 1, 0, 1});
    used.alpha_mode = AlphaMode::opaque;
    small.scene.objects[0].opacity = 0;
    expect_near(pixel_of(small, green), {0, 1, 0, 1});
    // Something opaque in front hides it, something transparent is sorted with it.
    small.scene.objects[0].opacity = 0.5f;
    small.add_wall(unlit(AlphaMode::blend, {0, 0, 1}, 0.5f), 1, 0.5f);
    expect_near(pixel_of(small, green), {0.25, 0.25, 0.5, 1});
}

TEST(ReferenceShading, LightsReachDiffuseSurfaces)
{
    // The point of pixel 0's centre is (0, 0, -2): a light two metres from it along the normal and
    // one along the surface.
    SmallScene small = dark_scene();
    Material material;
    material.base_color = {0.5f, 0.5f, 1};
    material.emission = {0.25f, 0, 0};
    small.add_papered_wall(material, 0, 2);
    Light light;
    light.kind = LightKind::point;
    light.position = {1, 0, 0};
    light.intensity = {1, 2, 3};
    small.scene.lights = {light};
    const double pi = std::acos(-1.0);
    // d^2 = 5, cosine = 2 / sqrt(5).
    const double e = 2 / std::sqrt(5.0) / 5 / pi;
    expect_near(pixel_of(small), {0.25 + 0.5 * e, 0.5 * 2 * e, 3 * e, 1});
    small.scene.materials[0].shading = Shading::unlit;
    expect_near(pixel_of(small), {0.5, 0.5, 1, 1});
}

TEST(ReferenceShading, PlacesAreThoseOfThePerspective)
{
    // A picture of 2x2 pixels, 90 degrees wide, at a wall four metres off: pixel 0 sees (-2, 2) of
    // its own -4..4. A light 1 metre in front of that point.
    SmallScene small = dark_scene();
    small.geometry.orthographic = false;
    small.geometry.eye = {false, {10, 20, 30}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 1, 2, 2};
    Material material;
    small.add_papered_wall(material, 0, -0.25f);
    Light light;
    light.position = {8, 22, 27};
    light.intensity = {1, 1, 1};
    small.scene.lights = {light};
    const double pi = std::acos(-1.0);
    const Picture picture = small.render(small_view(2, 2, 1));
    EXPECT_NEAR(picture.pixels[0].r, 1 / pi, kExact);
    // The neighbour is 4 metres to the right: d^2 = 17, cosine = 1 / sqrt(17).
    EXPECT_NEAR(picture.pixels[1].r, 1 / pi / 17 / std::sqrt(17.0), kExact);
}

TEST(ReferenceShading, NormalTextureBendsTheNormal)
{
    // n = (0, 0, 1), t = (1, 0, 0), b = (0, 1, 0); the sky is black below and white above: radiance
    // 0.5 + 0.5 n_y.
    SmallScene small = dark_scene();
    small.scene.sky.up = {1, 1, 1};
    small.scene.images = {image_of(1, 1, {{128, 255, 204, 0}})};
    Material material;
    material.normal_texture = plain_paper(0);
    Triangle& triangle = small.add_papered_wall(material, 0, 1);
    const double x = 1 / 255.0, y = 1, z = 0.6;
    const double ny = y / std::sqrt(x * x + y * y + z * z);
    EXPECT_NEAR(pixel_of(small).r, 0.5 + 0.5 * ny, kExact);
    // Seen from behind it is turned as a whole.
    triangle.back_facing = 1;
    EXPECT_NEAR(pixel_of(small).r, 0.5 - 0.5 * ny, kExact);
    triangle.back_facing = 0;
    // The scale is that of x and y.
    small.scene.materials[0].normal_scale = 0.5f;
    EXPECT_NEAR(pixel_of(small).r, 0.5 + 0.25 / std::sqrt(0.25 * x * x + 0.25 + z * z), kExact);
    small.scene.materials[0].normal_scale = 1;
    // The other side of the bitangent, of vertex 0.
    small.geometry.texture_attributes[0].tangent[3] = -1;
    EXPECT_NEAR(pixel_of(small).r, 0.5 - 0.5 * ny, kExact);
    small.geometry.texture_attributes[0].tangent[3] = 1;
    // Of a tangent that leans and is long, its part along the surface counts.
    for (TextureAttributes& attributes : small.geometry.texture_attributes) {
        attributes.tangent = {0, 7, 9, 1};  // b = (-1, 0, 0)
    }
    EXPECT_NEAR(pixel_of(small).r, 0.5 + 0.5 * x / std::sqrt(x * x + y * y + z * z), kExact);
    // Without one there is no texture.
    for (TextureAttributes& attributes : small.geometry.texture_attributes) {
        attributes.tangent = {0, 0, 9, 1};
    }
    EXPECT_NEAR(pixel_of(small).r, 0.5, kExact);
}

TEST(ReferenceShading, MetallicRoughnessByHand)
{
    // Sun and eye along the normal: D = 1 / (pi a^2), V = 1/4, F = F0. r = 1/2 and m = 1/2 51/255;
    // the image's red and alpha count for nothing.
    SmallScene small = dark_scene();
    small.scene.sun.to_light = {0, 0, 1};
    small.scene.sun.color = {1, 0.5f, 2};
    small.scene.images = {image_of(1, 1, {{77, 255, 51, 0}}), image_of(1, 1, {{10, 255, 0, 0}})};
    Material material = glossy({1, 0.5f, 0}, 0.5f, 0.5f);
    material.metallic_roughness_texture = plain_paper(0);
    material.emission = {1, 0.5f, 1};
    material.emission_texture = plain_paper(1);
    small.add_papered_wall(material, 0, 1);
    const double m = 0.1, a2 = 0.0625;
    const auto radiance = [&](double c, double sun, double emission) {
        const double f0 = 0.04 * (1 - m) + c * m;
        return sun * ((1 - f0) * c * (1 - m) + f0 / (4 * a2)) + emission;
    };
    expect_near(pixel_of(small), {radiance(1, 1, in_16_bits(10 / 255.0 / 12.92)),
                                  radiance(0.5, 0.5, 0.5), radiance(0, 2, 0), 1});
    // Smoother than 0.1 nothing is: a^2 = 1e-4.
    small.scene.materials[0] = glossy({1, 1, 1}, 1, 0);
    EXPECT_NEAR(pixel_of(small).r, 1 / (4 * 1e-4), kExact / 1e-4);
}

TEST(ReferenceShading, HighlightsMoveWithTheEye)
{
    // Under a perspective camera the eye is a place: the sun's mirror image is where it would be
    // seen in a mirror. 90 degrees wide, one metre off, sun at 45 degrees to the left.
    SmallScene small = dark_scene();
    small.geometry.orthographic = false;
    small.geometry.eye = {false, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 1, 64, 1};
    small.scene.sun.to_light = {-0.6f, 0, 0.8f};
    small.scene.sun.color = {1, 1, 1};
    small.add_papered_wall(glossy({1, 1, 1}, 1, 0.2f), 0, -1);
    const Picture picture = small.render(small_view(64, 1, 1));
    std::size_t brightest = 0;
    for (std::size_t x = 0; x < 64; ++x) {
        if (picture.pixels[x].r > picture.pixels[brightest].r) {
            brightest = x;
        }
    }
    // v = (0.6, 0, 0.8) looks from the place at x = -0.75: 8 pixels from the left.
    EXPECT_NEAR(static_cast<double>(brightest) + 0.5, 8, 1);
    small.geometry.orthographic = small.geometry.eye.orthographic = true;
    const Picture flat = small.render(small_view(64, 1, 1));
    EXPECT_EQ(flat.pixels[0].r, flat.pixels[63].r);
}

TEST(ReferenceShading, ZeroNormalsSeeTheMeanSky)
{
    SmallScene small;
    small.scene.sky.up = {1, 1, 1};
    small.scene.sky.down = {0.5f, 0, 1};
    Material material = glossy({0.5f, 1, 1}, 0.25f, 0.5f);
    material.emission = {0, 0, 0.5f};
    small.add_papered_wall(material, 0, 1);
    for (Attributes& attributes : small.geometry.attributes) {
        attributes.normal = {0, 0, 1e-12f};
    }
    Light light;
    small.scene.lights = {light};
    expect_near(pixel_of(small), {0.75 * 0.5 * 0.75, 0.75 * 0.5, 0.75 + 0.5, 1});
}

TEST(ReferenceShading, NearestTexelsAreDiscontinuitiesWhereTheyAreSeen)
{
    // Texels end at whole pixels, samples lie in their middles; then shifted to the edge.
    SmallScene small;
    small.scene.images = {image_of(2, 1, {{255, 0, 0, 255}, {0, 255, 0, 0}})};
    Material material = unlit(AlphaMode::blend, {1, 1, 1}, 1);
    material.base_color_texture = paper(0, 2, 1);
    small.add_papered_wall(material, 0, 2);
    const auto flags = [&] { return small.render(small_view(2, 1, 1)).discontinuities; };
    EXPECT_EQ(flags(), (std::vector<std::uint8_t>{0, 0}));
    small.scene.materials[0].base_color_texture->transform[2] = 0.25f;
    // What is not there at all may be there, too.
    EXPECT_EQ(flags(), (std::vector<std::uint8_t>{kNearestTexel, kNearestTexel}));
    small.add_wall(unlit(AlphaMode::opaque, {1, 1, 1}, 1), 1, 1);
    EXPECT_EQ(flags(), (std::vector<std::uint8_t>{0, 0}));
}

TEST(ReferenceShading, TexturedCutoffsAreUncertainByMore)
{
    // 51 / 255 less the cutoff is 5e-5.
    SmallScene small;
    small.scene.images = {image_of(1, 1, {{255, 0, 0, 51}})};
    Material material = unlit(AlphaMode::mask, {1, 1, 1}, 1);
    material.alpha_cutoff = 0.19995f;
    material.base_color_texture = plain_paper(0);
    small.add_papered_wall(material, 0, 1);
    const auto flags = [&] { return small.render(small_view(1, 1, 1)).discontinuities[0]; };
    EXPECT_EQ(flags(), kOpacityAtCutoff);
    small.scene.materials[0].alpha_cutoff = 0.1998f;
    EXPECT_EQ(flags(), 0);
    small.scene.materials[0].base_color_texture.reset();
    small.scene.materials[0].opacity = 0.2f;
    small.scene.materials[0].alpha_cutoff = 0.19995f;
    EXPECT_EQ(flags(), 0);
}

}  // namespace
}  // namespace sheer::reference
