// The level that a fragment's texture is read at, times how oblique it is seen: against rays that
// are cut with planes in doubles. And pictures that fade from an alpha test to a hashed one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <sheer/sheer.h>

#include "cpu/sheet.h"
#include "cpu/tile_fragments.h"
#include "geometry/build.h"
#include "reference/hashed_threshold.h"
#include "scene/camera.h"
#include "shade/textured_wall.h"
#include "simd_levels.h"

namespace sheer::test {
namespace {

constexpr int kTexelsWide = 64, kTexelsHigh = 32;

Scene textured(const Sheet& sheet)
{
    Scene scene = sheet.scene();
    scene.images.push_back(
        image_of(kTexelsWide, kTexelsHigh,
                 std::vector<Rgba8>(std::size_t{kTexelsWide} * kTexelsHigh, Rgba8{9, 9, 9, 200})));
    scene.materials[0].base_color_texture = Texture{};
    return scene;
}

// Calls check(x, y, level) for the fragments' pixels.
template <class Check>
void for_each_level(const Scene& scene, Simd simd, Check&& check)
{
    View view;
    view.width = kWidth;
    view.height = kHeight;
    const SampleSet set = make_sample_set(1, SamplePositions::center);
    const TileGrid grid{kWidth, kHeight, 0};
    const Geometry geometry = build_geometry(
        {scene, resolve_camera(scene, view), grid, set.extent, 1, {true, false, false}});
    const FrameSurfaces surfaces = make_surfaces({scene, 0, geometry.eye, 1});
    TileScratch scratch;
    OpaqueTile opaque(1, false);
    FragmentStream stream(2 * kTilePixels, false, true);
    const FragmentConsumer full{[](void*, const FragmentStream&) { return false; }, nullptr};
    for (int tile = 0; tile < grid.count(); ++tile) {
        const PixelRect rect = grid.rect(tile);
        TileJob job{&geometry, &surfaces, &set, tile, rect, rect};
        job.wants.places = PlaceSpace::object;
        job.wants.levels = true;
        ASSERT_TRUE(tile_fragments_for(targets_of(simd))(job, scratch, opaque, stream, full));
        for (int i = 0; i < stream.size; ++i) {
            check(rect.x0 + static_cast<int>(stream.pixel[i]) % kTileSize,
                  rect.y0 + static_cast<int>(stream.pixel[i]) / kTileSize,
                  static_cast<double>(stream.level[i]));
        }
    }
}

struct Expected {
    double level, anisotropy;
};

// docs/numerics.md, "Level", and section 7.1.1's factor.
Expected expected_at(const Sheet& sheet, double x, double y)
{
    const double step = 1e-4;
    const auto change = [&](double dx, double dy) {
        const Point to = sheet.at(x + step * dx, y + step * dy);
        const Point from = sheet.at(x - step * dx, y - step * dy);
        const double px = (to[0] - from[0]) / (2 * step), py = (to[1] - from[1]) / (2 * step);
        return std::array<double, 2>{0.5 * px, 2 * py - px};  // of Sheet's texture coordinates
    };
    const auto right = change(1, 0), down = change(0, 1);
    const auto texels = [](const std::array<double, 2>& uv) {
        return std::hypot(kTexelsWide * uv[0], kTexelsHigh * uv[1]);
    };
    const double longer = std::max(texels(right), texels(down));
    const double shorter = std::min(texels(right), texels(down));
    return {std::log2(std::max(shorter, longer / 8)), reference::anisotropy(right, down)};
}

// Derivatives are off by 0.0006 of the largest (places_test.cpp), of the texture's coordinates by
// up to 4 times that: where a pixel is A times as long as wide, by 0.0024 A of its width.
void expect_levels(const Sheet& sheet)
{
    const Scene scene = textured(sheet);
    for (const Simd simd : simd_levels()) {
        int count = 0;
        double least = 100, most = -100;
        for_each_level(scene, simd, [&](int x, int y, double level) {
            const auto [own, anisotropy] = expected_at(sheet, x + 0.5, y + 0.5);
            const double part = 0.0024 * anisotropy, expected = own * anisotropy;
            EXPECT_NEAR(level, expected,
                        anisotropy * part / std::log(2) + 2 * part * std::abs(expected));
            least = std::min(least, level);
            most = std::max(most, level);
            ++count;
        });
        EXPECT_GT(count, 400);
        EXPECT_GT(most - least, 1);
    }
}

TEST(Levels, OfATriangleInPerspective)
{
    expect_levels({{{-1.5, -1.2, -2}, {2.5, -1, -9}, {0.3, 1.5, -4}}});
}

TEST(Levels, AreEndlessWithoutATexture)
{
    const Sheet sheet{{{-1.5, -1.2, -2}, {2.5, -1, -5}, {0.3, 1.5, -4}}};
    for_each_level(sheet.scene(), Simd::best,
                   [](int, int, double level) { ASSERT_TRUE(std::isinf(level) && level > 0); });
}

// Squares of opacity 0.25 and 0.75, the nearest texel of any level that is read.
Image drawn(float repeats, const char* method)
{
    std::vector<Rgba8> texels;
    for (int i = 0; i < 64 * 64; ++i) {
        const bool strong = (i % 64 / 32 + i / 64 / 32) % 2 == 0;
        texels.push_back({255, 255, 255, static_cast<std::uint8_t>(strong ? 191 : 64)});
    }
    Wall wall(image_of(64, 64, std::move(texels)), 0, 0, repeats, repeats);
    wall.material().alpha_mode = AlphaMode::blend;
    wall.view.width = wall.view.height = 64;
    Options options;
    options.method = method;
    return render(wall.scene, wall.view, options).image;
}

double differing(const Image& a, const Image& b)
{
    double count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) count += a.pixels[i] != b.pixels[i] ? 1 : 0;
    return count / static_cast<double>(a.pixels.size());
}

TEST(Levels, NoiseFadesIn)
{
    const char* const faded = "hashed-alpha-test:fade-in=6";
    // A texel a pixel, level 0: an alpha test.
    EXPECT_EQ(drawn(1, faded).pixels, drawn(1, "alpha-test").pixels);
    EXPECT_GT(differing(drawn(1, faded), drawn(1, "hashed-alpha-test")), 0.15);
    // 64 a pixel, level 6: thresholds are off by 2^-25, so that no pixel of 4,096 differs.
    EXPECT_EQ(drawn(64, faded).pixels, drawn(64, "hashed-alpha-test").pixels);
    EXPECT_GT(differing(drawn(64, faded), drawn(64, "alpha-test")), 0.3);
    // 8 a pixel, level 3, b = 1/4: thresholds from 3/8 to 5/8.
    EXPECT_EQ(drawn(8, faded).pixels, drawn(8, "alpha-test").pixels);
    // From that level on all is noise: a quarter of all pixels change.
    EXPECT_GT(differing(drawn(8, "hashed-alpha-test:fade-in=3"), drawn(8, "alpha-test")), 0.15);
}

}  // namespace
}  // namespace sheer::test
