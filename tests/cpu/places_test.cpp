// Where fragments are on their surfaces, against rays that are cut with planes in doubles.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include <sheer/sheer.h>

#include "cpu/sheet.h"
#include "cpu/tile_fragments.h"
#include "geometry/build.h"
#include "scene/camera.h"
#include "simd_levels.h"

namespace sheer {
namespace {

using test::kHeight, test::kWidth, test::Point, test::Sheet;

Point in_space(PlaceSpace space, const Point& p)
{
    if (space == PlaceSpace::object) return {3 - 2 * p[1], 2 * p[0], 2 * p[2]};
    if (space == PlaceSpace::world) return p;
    return {0.5 * p[0] + 1, 2 * p[1] - p[0], 0};
}

// Calls check(x, y, place) for the fragments' pixels.
template <class Check>
void for_each_place(const Sheet& sheet, PlaceSpace space, Simd level, Check&& check)
{
    const Scene scene = sheet.scene();
    View view;
    view.width = kWidth;
    view.height = kHeight;
    const SampleSet set = make_sample_set(1, SamplePositions::center);
    const TileGrid grid{kWidth, kHeight, 0};
    const Projection projection = resolve_camera(scene, view);
    const Geometry geometry =
        build_geometry({scene, projection, grid, set.extent, 1, {true, true, true}});
    const FrameSurfaces surfaces = make_surfaces({scene, 0, geometry.eye, 1});
    TileScratch scratch;
    OpaqueTile opaque(1, false);
    FragmentStream stream(2 * kTilePixels, false, true);
    const FragmentConsumer full{[](void*, const FragmentStream&) { return false; }, nullptr};
    for (int tile = 0; tile < grid.count(); ++tile) {
        const PixelRect rect = grid.rect(tile);
        TileJob job{&geometry, &surfaces, &set, tile, rect, rect};
        job.wants.places = space;
        ASSERT_TRUE(tile_fragments_for(targets_of(level))(job, scratch, opaque, stream, full));
        for (int i = 0; i < stream.size; ++i) {
            std::array<double, 9> place;
            for (std::size_t c = 0; c < 9; ++c) place[c] = static_cast<double>(stream.place[c][i]);
            check(rect.x0 + static_cast<int>(stream.pixel[i]) % kTileSize,
                  rect.y0 + static_cast<int>(stream.pixel[i]) / kTileSize, place);
        }
    }
}

// Corners are snapped to 1/512 pixel at most, along two axes, and a place inside moves no farther
// than they do: so many pixels' change of the place. What clipping adds to the screen lies outside.
// Derivatives change by as much over the triangle's 30 pixels or more, twice for the two corners,
// and with the square of the distance.
constexpr double kPlace = 2.0 / 512, kChange = 8.0 / 512 / 30 + 1e-4;

void expect_places(const Sheet& sheet)
{
    for (const PlaceSpace space : {PlaceSpace::object, PlaceSpace::world, PlaceSpace::texture}) {
        for (const Simd level : simd_levels()) {
            int count = 0;
            for_each_place(sheet, space, level, [&](int px, int py, const auto& place) {
                const double x = px + 0.5, y = py + 0.5, step = 1e-4;
                const auto at = [&](double dx, double dy) {
                    return in_space(space, sheet.at(x + dx, y + dy));
                };
                const Point here = at(0, 0), right = at(step, 0), left = at(-step, 0),
                            down = at(0, step), up = at(0, -step);
                double most = 0;  // that the place changes by in a pixel
                for (std::size_t c = 0; c < 3; ++c) {
                    most = std::max({most, std::abs(right[c] - left[c]) / (2 * step),
                                     std::abs(down[c] - up[c]) / (2 * step)});
                }
                for (std::size_t c = 0; c < 3; ++c) {
                    const double rounding = 1e-6 * (1 + std::abs(here[c]));
                    EXPECT_NEAR(place[c], here[c], kPlace * most + rounding);
                    EXPECT_NEAR(place[3 + c], (right[c] - left[c]) / (2 * step),
                                kChange * most + rounding);
                    EXPECT_NEAR(place[6 + c], (down[c] - up[c]) / (2 * step),
                                kChange * most + rounding);
                }
                ++count;
            });
            EXPECT_GT(count, 400);
        }
    }
}

TEST(Places, OfATriangleInPerspective)
{
    expect_places({{{-1.5, -1.2, -2}, {2.5, -1, -5}, {0.3, 1.5, -4}}});
}

TEST(Places, OfATriangleThatIsCutByTheNearPlane)
{
    expect_places({{{-3, -1, 1}, {3, -1, 0.5}, {0, 1.5, -9}}});
}

TEST(Places, OfATriangleUnderAnOrthographicCamera)
{
    expect_places({{{-3, -2.5, -2}, {3.5, -2, -8}, {0.3, 2.5, -4}}, true});
}

// MASK surfaces come to the methods that test them as BLEND surfaces do.
TEST(Places, MasksAreTestedAsIfTheyWereBlended)
{
    Scene masked = load("builtin:fence"), blended = masked;
    for (Material& material : blended.materials) {
        if (material.alpha_mode == AlphaMode::mask) material.alpha_mode = AlphaMode::blend;
    }
    View view;
    view.width = 120;
    view.height = 90;
    view.samples = 4;
    const auto picture = [&](const Scene& scene, const char* method) {
        Options options;
        options.method = method;
        return render(scene, view, options).image.pixels;
    };
    for (const char* method : {"hashed-alpha-test", "stochastic-alpha-test", "alpha-to-coverage",
                               "hashed-alpha-to-coverage", "screen-door"}) {
        EXPECT_EQ(picture(masked, method), picture(blended, method)) << method;
        EXPECT_NE(picture(masked, method), picture(masked, "blend")) << method;
    }
    // Objects' opacity makes no other difference to one than to the other.
    for (Scene* scene : {&masked, &blended}) set_opacity(*scene, "*", 0.75f);
    EXPECT_EQ(picture(masked, "alpha-to-coverage"), picture(blended, "alpha-to-coverage"));
    EXPECT_NE(picture(masked, "exact"), picture(blended, "exact"));
    for (Scene* scene : {&masked, &blended}) set_opacity(*scene, "*", 1);
    // A MASK surface's own cutoff is that of the test.
    EXPECT_EQ(picture(masked, "alpha-test"), picture(masked, "exact"));
    EXPECT_EQ(picture(blended, "alpha-test"), picture(masked, "exact"));
}

}  // namespace
}  // namespace sheer
