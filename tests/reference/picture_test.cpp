// What the reference makes of whole pictures: visibility, alpha modes, filters, discontinuities.
//
// Expected values are derived by hand from docs/numerics.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "near.h"
#include "small_scenes.h"

namespace sheer::reference {
namespace {

constexpr Float3 kRed = {1, 0, 0};
constexpr Float3 kGreen = {0, 1, 0};
constexpr Float3 kBlue = {0, 0, 1};

TEST(Picture, NothingIsTheBackground)
{
    const SmallScene small;
    View view = small_view(3, 2, 4);
    view.exposure = 2;
    for (const Filter filter : {Filter::box, Filter::gaussian}) {
        view.filter = filter;
        const Picture picture = small.render(view, {0.25f, 0.5f, 0.125f, 0.5f});
        ASSERT_EQ(picture.pixels.size(), 6u);
        ASSERT_EQ(picture.discontinuities.size(), 6u);
        for (const Rgba& pixel : picture.pixels) {
            expect_near(pixel, {0.25, 0.5, 0.125, 0.5});
        }
    }
}

TEST(Picture, LayersOverTheBackground)
{
    // Red in front of blue, both 0.5: 0.5 red + 0.25 blue, a quarter of the background.
    SmallScene small;
    small.add_wall(unlit(AlphaMode::blend, kBlue, 0.5f), 0, 2);
    small.add_wall(unlit(AlphaMode::blend, kRed, 0.5f), 1, 1);
    const Picture picture = small.render(small_view(2, 2, 8), {0, 0.5f, 0, 0.5f});
    expect_near(picture.pixels[3], {0.5, 0.125, 0.25, 1 - 0.25 * 0.5});
    EXPECT_EQ(picture.discontinuities[3], 0);
}

TEST(Picture, TheSmallerPrimitiveIsInFrontOfItsEqual)
{
    for (const std::uint32_t red_primitive : {0u, 2u}) {
        SmallScene small;
        small.add_wall(unlit(AlphaMode::blend, kBlue, 0.5f), 1, 1);
        small.add_wall(unlit(AlphaMode::blend, kRed, 0.5f), red_primitive, 1);
        const Picture picture = small.render(small_view(1, 1, 1));
        const double red = red_primitive == 0 ? 0.5 : 0.25;
        expect_near(picture.pixels[0], {red, 0, 0.75 - red, 0.75});
        EXPECT_EQ(picture.discontinuities[0], 0);
    }
}

TEST(Picture, OpaqueHidesWhatIsNotInFrontOfIt)
{
    SmallScene small;
    small.add_wall(unlit(AlphaMode::opaque, kGreen, 0.5f), 5, 2);  // its opacity is ignored
    small.add_wall(unlit(AlphaMode::opaque, kBlue, 1), 6, 2);      // the larger id loses
    small.add_wall(unlit(AlphaMode::blend, kRed, 0.5f), 0, 2);     // equal depth is not in front
    small.add_wall(unlit(AlphaMode::blend, kRed, 0.25f), 1, 1);
    small.add_wall(unlit(AlphaMode::blend, kRed, 0.5f), 2, 3);
    const Picture picture = small.render(small_view(1, 1, 4), {1, 1, 1, 1});
    expect_near(picture.pixels[0], {0.25, 0.75, 0, 1});
}

TEST(Picture, MaskIsDecidedAtTheCentroid)
{
    // Alpha is x / 8 and the cutoff 0.5: it is passed from x = 4 on, so by all the samples of pixel
    // 4, whose centre is at 4.5, and by no sample of pixel 3.
    SmallScene small;
    Material material = unlit(AlphaMode::mask, kRed, 1);
    material.alpha_cutoff = 0.5f;
    small.add_triangle(
        small.add_object(material), 0,
        {{{0, 0, 1, {1, 1, 1, 0}}, {32, 0, 1, {1, 1, 1, 4}}, {0, 32, 1, {1, 1, 1, 0}}}});
    const Picture picture = small.render(small_view(8, 1, 8));
    for (std::size_t x = 0; x < 8; ++x) {
        expect_near(picture.pixels[x], x < 4 ? Rgba{} : Rgba{1, 0, 0, 1});
        EXPECT_EQ(picture.discontinuities[x], 0);
    }
}

TEST(Picture, EqualToTheCutoffIsOpaqueAndADiscontinuity)
{
    SmallScene small;
    Material material = unlit(AlphaMode::mask, kRed, 0.5f);
    material.alpha_cutoff = 0.5f;
    small.add_wall(material, 0, 1);
    const Picture picture = small.render(small_view(1, 1, 1));
    expect_near(picture.pixels[0], {1, 0, 0, 1});
    EXPECT_EQ(picture.discontinuities[0], kOpacityAtCutoff);
    small.add_wall(unlit(AlphaMode::opaque, kBlue, 1), 1, 0.5f);
    EXPECT_EQ(small.render(small_view(1, 1, 1)).discontinuities[0], 0);
}

TEST(Picture, BoxIsTheMeanOfThePixelsOwnSamples)
{
    // Left of x = 0.5 lie two of the four standard samples, at 0.375 and 0.125; above y = 0.25 of
    // those the first, at (0.375, 0.125).
    SmallScene small;
    const auto object = small.add_object(unlit(AlphaMode::opaque, kRed, 1));
    small.add_triangle(object, 0, {{{0, 0}, {0.5, 0}, {0.5, 0.25}}});
    small.add_triangle(object, 1, {{{0, 0}, {0.5, 0.25}, {0, 0.25}}});
    expect_near(small.render(small_view(1, 1, 4)).pixels[0], {0.25, 0, 0, 0.25});
}

TEST(Picture, GaussianOfOneWhitePixel)
{
    // A sample in each centre: weights g(0)^2, g(0) g(1), g(1)^2, those inside the picture.
    SmallScene small;
    const auto object = small.add_object(unlit(AlphaMode::opaque, {1, 1, 1}, 1));
    small.add_triangle(object, 0, {{{1, 1}, {2, 1}, {2, 2}}});
    small.add_triangle(object, 1, {{{1, 1}, {2, 2}, {1, 2}}});
    View view = small_view(3, 3, 1);
    view.filter = Filter::gaussian;
    const Picture picture = small.render(view);
    const double g0 = 1 - std::exp(-4.5);
    const double g1 = std::exp(-2.0) - std::exp(-4.5);
    const double inner = g0 / (g0 + 2 * g1);
    const double outer = g1 / (g0 + g1);
    EXPECT_NEAR(picture.pixels[4].a, inner * inner, kExact);
    EXPECT_NEAR(picture.pixels[1].a, inner * outer, kExact);
    EXPECT_NEAR(picture.pixels[3].a, inner * outer, kExact);
    EXPECT_NEAR(picture.pixels[8].a, outer * outer, kExact);
}

TEST(Picture, GaussianWeighsSamplesByTheirOwnPlace)
{
    // In a row of two pixels, the samples are, from the centre of pixel 0, at x = 0.25, -0.25, 1.25
    // and 0.75; in y all at 0.25 or -0.25, which weigh the same. Only that at 1.25 is lit.
    SmallScene small;
    const auto object = small.add_object(unlit(AlphaMode::opaque, {1, 1, 1}, 1));
    small.add_triangle(object, 0, {{{1.5, 0}, {9, 0}, {1.5, 9}}});
    View view = small_view(2, 1, 2);
    view.filter = Filter::gaussian;
    const auto g = [](double d) { return std::exp(-2 * d * d) - std::exp(-4.5); };
    const double total = 2 * g(0.25) + g(1.25) + g(0.75);
    EXPECT_NEAR(small.render(view).pixels[0].a, g(1.25) / total, kExact);
}

TEST(Picture, BandsOfRowsJoin)
{
    // Alpha grows with y only: a Gaussian of a linear ramp is the ramp, away from the picture's
    // ends.
    SmallScene small;
    small.add_triangle(
        small.add_object(unlit(AlphaMode::blend, {1, 1, 1}, 1)), 0,
        {{{-64, 0, 1, {1, 1, 1, 0}}, {64, 0, 1, {1, 1, 1, 0}}, {0, 64, 1, {1, 1, 1, 1}}}});
    View view = small_view(3, 30, 1);
    view.filter = Filter::gaussian;
    const Picture picture = small.render(view);
    for (std::size_t y = 1; y + 1 < 30; ++y) {
        EXPECT_NEAR(picture.pixels[y * 3 + 1].a, (static_cast<double>(y) + 0.5) / 64, kExact) << y;
    }
}

std::uint8_t flags_of(const SmallScene& small)
{
    return small.render(small_view(1, 1, 4)).discontinuities[0];
}

TEST(Discontinuities, CloseDepthsOfSlopedSurfaces)
{
    const Material red = unlit(AlphaMode::blend, kRed, 0.5f);
    const Material blue = unlit(AlphaMode::blend, kBlue, 0.5f);
    SmallScene crossing;
    crossing.add_wall(red, 0, 1, 1e-6f);
    crossing.add_wall(blue, 1, 1, -1e-6f);
    EXPECT_EQ(flags_of(crossing), kDepthsWithinRounding);
    SmallScene same_color;
    same_color.add_wall(red, 0, 1, 1e-6f);
    same_color.add_wall(red, 1, 1, -1e-6f);
    EXPECT_EQ(flags_of(same_color), 0);
    SmallScene same_corners;
    same_corners.add_wall(red, 0, 1, 1e-6f);
    same_corners.add_wall(blue, 1, 1, 1e-6f);
    EXPECT_EQ(flags_of(same_corners), 0);
    SmallScene apart;
    apart.add_wall(red, 0, 1, 1e-6f);
    apart.add_wall(blue, 1, 1.0001f, -1e-6f);
    EXPECT_EQ(flags_of(apart), 0);
    crossing.add_wall(unlit(AlphaMode::blend, kGreen, 1), 2, 0.5f);  // hides both
    EXPECT_EQ(flags_of(crossing), 0);
}

TEST(Discontinuities, ConstantDepthsAreCertain)
{
    SmallScene small;
    small.add_wall(unlit(AlphaMode::blend, kRed, 0.5f), 0, 1);
    small.add_wall(unlit(AlphaMode::blend, kBlue, 0.5f), 1, std::nextafter(1.0f, 2.0f));
    EXPECT_EQ(flags_of(small), 0);
}

TEST(Discontinuities, SurfacesOnAnOpaqueOne)
{
    const Material blue = unlit(AlphaMode::blend, kBlue, 0.5f);
    SmallScene small;
    small.add_wall(unlit(AlphaMode::opaque, kRed, 1), 0, 1, 1e-6f);
    small.add_wall(blue, 1, 1, -1e-6f);
    EXPECT_EQ(flags_of(small), kCoplanarWithOpaque);
    SmallScene opaque;
    opaque.add_wall(unlit(AlphaMode::opaque, kRed, 1), 0, 1, 1e-6f);
    opaque.add_wall(unlit(AlphaMode::opaque, kBlue, 1), 1, 1, -1e-6f);
    EXPECT_EQ(flags_of(opaque), kDepthsWithinRounding);
}

// Metallic-roughness glass in the dark: it shows its emission and what is behind it.
Material dark_glass(Float3 color, Float3 emission)
{
    Material material;
    material.shading = Shading::metallic_roughness;
    material.base_color = color;
    material.transmission = 1;
    material.emission = emission;
    return material;
}

TEST(Discontinuities, OrderOfColoredGlass)
{
    SmallScene small;
    small.scene.sun.color = small.scene.sky.up = small.scene.sky.down = {0, 0, 0};
    small.add_wall(dark_glass(kRed, {0, 0, 0}), 0, 1, 1e-6f);
    small.add_wall(dark_glass({1, 1, 0}, {0, 0, 0}), 1, 1, -1e-6f);
    // Filters that don't shine may be swapped.
    EXPECT_EQ(flags_of(small), 0);
    // One that shines red is seen through red glass by 0.96, in front of it by 1.
    small.scene.materials[1].emission = kRed;
    EXPECT_EQ(flags_of(small), kDepthsWithinRounding);
    // On an opaque surface it may be hidden.
    small.scene.materials[0] = unlit(AlphaMode::opaque, kRed, 1);
    EXPECT_EQ(flags_of(small), kCoplanarWithOpaque);
    // Black glass hides all that is behind it.
    SmallScene behind;
    behind.scene.sun.color = behind.scene.sky.up = behind.scene.sky.down = {0, 0, 0};
    behind.add_wall(unlit(AlphaMode::blend, kGreen, 0.5f), 0, 1, 1e-6f);
    behind.add_wall(unlit(AlphaMode::blend, kBlue, 0.5f), 1, 1, -1e-6f);
    EXPECT_EQ(flags_of(behind), kDepthsWithinRounding);
    behind.add_wall(dark_glass({0, 0, 0}, {0, 0, 0}), 2, 0.5f);
    EXPECT_EQ(flags_of(behind), 0);
}

TEST(Discontinuities, ReachAsFarAsTheFilter)
{
    // MASK at its cutoff in pixel 2 alone.
    SmallScene small;
    Material material = unlit(AlphaMode::mask, kRed, 0.5f);
    small.add_triangle(small.add_object(material), 0, {{{2, 0}, {3, 0}, {2.5, 1}}});
    View view = small_view(6, 1, 1);
    const std::vector<std::uint8_t> own = {0, 0, kOpacityAtCutoff, 0, 0, 0};
    EXPECT_EQ(small.render(view).discontinuities, own);
    view.filter = Filter::gaussian;
    const std::vector<std::uint8_t> around = {
        0, kOpacityAtCutoff, kOpacityAtCutoff, kOpacityAtCutoff, 0, 0};
    EXPECT_EQ(small.render(view).discontinuities, around);
}

}  // namespace
}  // namespace sheer::reference
