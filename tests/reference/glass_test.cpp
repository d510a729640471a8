// Coloured glass, seen in pictures of one wall or two: by hand from docs/numerics.md,
// "Transmission".
#include <gtest/gtest.h>

#include <cmath>

#include "near.h"
#include "small_images.h"
#include "small_scenes.h"

namespace sheer::reference {
namespace {

Material glass(Float3 color, float transmission, Float3 emission = {0, 0, 0})
{
    Material material = glossy(color, 0, 1);
    material.transmission = transmission;
    material.emission = emission;
    return material;
}

TEST(ReferenceGlass, TwoColoredPanes)
{
    // T1 = 0.96 / 2 (1, 1/2, 0), T2 = 0.96 (1/2, 1, 1): emission 1, then T1 times emission 2, then
    // T1 T2 times the background; alpha by the mean of T1 T2.
    SmallScene small = dark_scene();
    small.add_papered_wall(glass({0.5f, 1, 1}, 1, {0.5f, 0.5f, 0.5f}), 0, 2);
    small.add_papered_wall(glass({1, 0.5f, 0}, 0.5f, {0.125f, 0.25f, 0}), 1, 1);
    const double t1[3] = {0.48, 0.24, 0}, t2[3] = {0.48, 0.96, 0.96};
    const double mean = (t1[0] * t2[0] + t1[1] * t2[1]) / 3;
    expect_near(pixel_of(small, {1, 0.5f, 0.25f, 0.5f}),
                {0.125 + 0.48 * 0.5 + 0.48 * 0.48, 0.25 + 0.24 * 0.5 + 0.24 * 0.96 * 0.5, 0,
                 1 - 0.5 * mean});
}

TEST(ReferenceGlass, GlassInEveryAlphaMode)
{
    SmallScene small = dark_scene();
    Material material = glass({1, 0.5f, 0}, 0.5f, {1, 1, 1});
    material.opacity = 0.5f;
    small.add_papered_wall(material, 0, 1);
    Material& used = small.scene.materials[0];
    const Float4 white = {1, 1, 1, 1};
    expect_near(pixel_of(small, white), {1.48, 1.24, 1, 1});
    used.alpha_mode = AlphaMode::blend;  // T = 1/2 + 1/2 (0.48, 0.24, 0), and half of the emission
    expect_near(pixel_of(small, white), {1.24, 1.12, 1, 1});
    used.alpha_mode = AlphaMode::mask;
    expect_near(pixel_of(small, white), {1.48, 1.24, 1, 1});
    used.alpha_cutoff = 0.75f;
    expect_near(pixel_of(small, white), {1, 1, 1, 1});
    used.alpha_mode = AlphaMode::opaque;
    small.scene.objects[0].opacity = 0.5f;
    expect_near(pixel_of(small, white), {1.24, 1.12, 1, 1});
    small.scene.objects[0].opacity = 1;
    // Only metallic-roughness transmits; a metal does not.
    used.metallic = 1;
    expect_near(pixel_of(small, white), {1, 1, 1, 1});
    used.shading = Shading::unlit;
    expect_near(pixel_of(small, white), {1, 0.5, 0, 1});
    used.shading = Shading::diffuse;
    expect_near(pixel_of(small, white), {1, 1, 1, 1});
}

TEST(ReferenceGlass, TransmissionTextureIsRead)
{
    SmallScene small = dark_scene();
    small.scene.images = {image_of(1, 1, {{51, 255, 255, 255}})};
    Material material = glass({1, 1, 1}, 0.5f);
    material.transmission_texture = plain_paper(0);
    small.add_papered_wall(material, 0, 1);
    expect_near(pixel_of(small, {1, 1, 1, 0}), {0.096, 0.096, 0.096, 1 - 0.096});
}

TEST(ReferenceGlass, GlassTakesItsPartFromTheDiffuseLight)
{
    // No reflection of the sky but R's: nv = 1, R = F0 = 0.04, everything else from within.
    SmallScene small = dark_scene();
    small.scene.sky.up = small.scene.sky.down = {1, 1, 1};
    small.add_papered_wall(glass({0.5f, 0.5f, 0.5f}, 0.25f), 0, 1);
    const double added = 0.96 * 0.5 * 0.75 + 0.04;
    const double through = 0.96 * 0.5 * 0.25;
    expect_near(pixel_of(small), {added, added, added, 1 - through});
}

TEST(ReferenceGlass, ClearGlassIsDropped)
{
    // 1 - mean T = opacity 0.04: below 1e-6 for an opacity of 2^-16, 1.5e-5, above it for 2^-15.
    SmallScene small = dark_scene();
    Material material = glass({1, 1, 1}, 1, {1, 1, 1});
    material.alpha_mode = AlphaMode::blend;
    small.add_papered_wall(material, 0, 1);
    small.scene.materials[0].opacity = std::ldexp(1.0f, -16);
    expect_near(pixel_of(small), {0, 0, 0, 0});
    small.scene.materials[0].opacity = std::ldexp(1.0f, -15);
    const double opacity = std::ldexp(1.0, -15);
    expect_near(pixel_of(small), {opacity, opacity, opacity, 0.04 * opacity});
}

}  // namespace
}  // namespace sheer::reference
