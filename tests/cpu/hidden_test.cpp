// Fragments that a consumer says are hidden are not shaded: those in pixels where it is nearer than
// the whole triangle, and no others. Where that is so of all that a triangle may cover, it is not
// even rasterised.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include <sheer/sheer.h>

#include "cpu/tile_fragments.h"
#include "geometry/build.h"
#include "geometry/screen_bounds.h"
#include "scene/camera.h"
#include "simd_levels.h"
#include "support/random.h"

namespace sheer {

namespace {

constexpr int kSide = 64, kCapacity = 1 << 19;

struct Listed {
    std::uint32_t primitive, pixel;
    std::uint64_t samples;
    float nearest, depth, red, opacity;

    auto key() const { return std::tuple(primitive, pixel, samples, depth, red, opacity); }
};

// A picture's tiles, whose fragments are listed in order.
class Tiles {
public:
    Tiles(const std::string& source, int samples, bool shaded_at_samples)
        : scene_(load(source)), set_(make_sample_set(samples, SamplePositions::standard))
    {
        View view;
        view.width = view.height = kSide;
        geometry_ = build_geometry({scene_, resolve_camera(scene_, view), grid_, set_.extent, 1});
        FragmentKinds kinds;
        kinds.at_samples = shaded_at_samples;
        surfaces_ = make_surfaces({scene_, 0, geometry_.eye, 1, Shadowed::no, {}, kinds});
        for (const TriangleChunk& chunk : geometry_.chunks) {
            for (const Triangle& t : chunk.triangles) triangles_[t.primitive] = &t;
        }
    }
    int count() const { return grid_.count(); }

    // Of triangle `primitive`, none of them clipped: pixels of the tile that it may cover.
    PixelBounds bounds(std::uint32_t primitive, int tile) const
    {
        const PixelRect rect = grid_.rect(tile);
        const PixelBounds b = pixel_bounds(*triangles_.at(primitive), set_.extent);
        return {std::max(b.x0, rect.x0) - rect.x0, std::max(b.y0, rect.y0) - rect.y0,
                std::min(b.x1, rect.x1 - 1) - rect.x0, std::min(b.y1, rect.y1 - 1) - rect.y0};
    }

    // `hidden`: of kTilePixels, or null. Returns how many fragments were left out, but for those of
    // triangles that were not rasterised.
    int list(int tile, Simd simd, const float* hidden, std::vector<Listed>& to)
    {
        const PixelRect rect = grid_.rect(tile);
        const TileJob job{&geometry_, &surfaces_, &set_, tile, rect, rect};
        const FragmentConsumer consumer{[](void*, const FragmentStream&) { return false; }, nullptr,
                                        hidden};
        EXPECT_TRUE(
            tile_fragments_for(targets_of(simd))(job, scratch_, opaque_, stream_, consumer));
        to.clear();
        for (int r = 0; r < stream_.run_count; ++r) {
            const FragmentRun& run = stream_.runs[r];
            for (std::size_t i = run.first; i < run.first + run.count; ++i) {
                to.push_back({run.primitive, stream_.pixel[i], stream_.sample_bits(i),
                              run.depth.least, stream_.depth[i], stream_.red[i],
                              stream_.opacity[i]});
            }
        }
        return static_cast<int>(scratch_.hidden);
    }

private:
    Scene scene_;
    SampleSet set_;
    TileGrid grid_{kSide, kSide, 0};
    Geometry geometry_;
    FrameSurfaces surfaces_;
    std::map<std::uint32_t, const Triangle*> triangles_;
    TileScratch scratch_;
    OpaqueTile opaque_{set_.count, true};
    FragmentStream stream_{kCapacity};
};

// In each pixel the least depth of one of its triangles, or that of none, or that of all.
std::vector<float> somewhere_between(const std::vector<Listed>& all, std::uint64_t seed)
{
    std::vector<float> depths(kTilePixels, std::numeric_limits<float>::infinity());
    std::map<std::uint32_t, std::vector<float>> of_pixel;
    for (const Listed& f : all) of_pixel[f.pixel].push_back(f.nearest);
    const CounterRandom random{seed};
    for (const auto& [pixel, nearest] : of_pixel) {
        const std::uint64_t bits = random.bits(pixel);
        if (bits % 4 == 0) continue;
        depths[pixel] = bits % 4 == 1 ? -std::numeric_limits<float>::infinity()
                                      : nearest[(bits >> 8) % nearest.size()];
    }
    return depths;
}

// Fragments of triangles that have none left.
int of_gone_triangles(const std::vector<Listed>& all, const std::vector<Listed>& left)
{
    std::set<std::uint32_t> there;
    for (const Listed& f : left) there.insert(f.primitive);
    return static_cast<int>(
        std::ranges::count_if(all, [&](const Listed& f) { return !there.contains(f.primitive); }));
}

void expect_exactly_hidden(const std::string& source, int samples, bool all_have_opacity,
                           bool shaded_at_samples = false)
{
    Tiles tiles(source, samples, shaded_at_samples);
    std::vector<Listed> all, left;
    std::size_t gone = 0, stayed = 0;
    for (int tile = 0; tile < tiles.count(); ++tile) {
        ASSERT_EQ(tiles.list(tile, Simd::best, nullptr, all), 0);
        const auto seed = static_cast<std::uint64_t>(tile + samples);
        const std::vector<float> hidden = somewhere_between(all, seed);
        std::vector<Listed> expected;
        for (const Listed& f : all) {
            if (!(f.nearest > hidden[f.pixel])) expected.push_back(f);
        }
        for (const Simd simd : simd_levels()) {
            const int count = tiles.list(tile, simd, hidden.data(), left);
            ASSERT_EQ(left.size(), expected.size()) << source << ", tile " << tile;
            for (std::size_t i = 0; i < left.size(); ++i) {
                EXPECT_EQ(left[i].key(), expected[i].key()) << source << ", " << i;
            }
            const int difference = static_cast<int>(all.size() - left.size());
            if (all_have_opacity) {
                EXPECT_LE(count, difference) << source << ", tile " << tile;
            }
            EXPECT_GE(count + of_gone_triangles(all, left), difference)
                << source << ", tile " << tile;
        }
        gone += all.size() - expected.size();
        stayed += expected.size();
    }
    EXPECT_GT(gone, stayed / 4) << source;
    EXPECT_GT(stayed, gone / 4) << source;
}

}  // namespace

TEST(Hidden, IsWhatLiesBehindAlone)
{
    for (const int samples : {1, 8, 64}) {
        expect_exactly_hidden("builtin:motor?detail=0.1", samples, true);
        expect_exactly_hidden("builtin:quads", samples, true);
    }
}

// A block of 4 x 4 pixels in which nothing can be seen: triangles that touch no others leave no
// fragments that count.
TEST(Hidden, TrianglesWithinHiddenBlocksAreNotMade)
{
    Tiles tiles("builtin:motor?detail=0.1", 8, false);
    std::vector<Listed> all, left;
    for (int tile = 0; tile < tiles.count(); ++tile) {
        tiles.list(tile, Simd::best, nullptr, all);
        int whole = 0, hidden_in_all = 0;
        for (int block = tile % 5; block < kTilePixels / 16; block += 5) {
            const int x0 = block % 8 * 4, y0 = block / 8 * 4;
            const auto is_within = [&](int x, int y) {
                return x >= x0 && x < x0 + 4 && y >= y0 && y < y0 + 4;
            };
            std::vector<float> hidden(kTilePixels, std::numeric_limits<float>::infinity());
            for (int y = y0; y < y0 + 4; ++y) {
                std::fill_n(&hidden[static_cast<std::size_t>(y * kTileSize + x0)], 4,
                            -std::numeric_limits<float>::infinity());
            }
            int expected = 0, gone = 0;
            for (const Listed& f : all) {
                const int pixel = static_cast<int>(f.pixel);
                if (!is_within(pixel % kTileSize, pixel / kTileSize)) continue;
                const PixelBounds b = tiles.bounds(f.primitive, tile);
                ++gone;
                expected += !(is_within(b.x0, b.y0) && is_within(b.x1, b.y1));
            }
            for (const Simd simd : simd_levels()) {
                EXPECT_EQ(tiles.list(tile, simd, hidden.data(), left), expected)
                    << "tile " << tile << ", block " << block;
                EXPECT_EQ(left.size() + static_cast<std::size_t>(gone), all.size());
            }
            whole += gone - expected;
            hidden_in_all += gone;
        }
        EXPECT_GT(whole, hidden_in_all / 8) << "tile " << tile;
    }
}

TEST(Hidden, IsSoWhereSamplesAreShaded)
{
    expect_exactly_hidden("builtin:smoke?particles=100", 2, false, true);
    expect_exactly_hidden("builtin:smoke?particles=100", 8, false, true);
    expect_exactly_hidden("builtin:smoke?particles=10", 64, false, true);
}

TEST(Hidden, IsInFrontOfWhatIsOpaque)
{
    for (const int samples : {1, 8}) {
        expect_exactly_hidden(SHEER_SOURCE_DIR "/scenes/tea_table.glb", samples, false);
    }
}

// A blended plane before, in or behind an opaque one. Depths in floats may be off by some 16 of
// these steps.
TEST(Hidden, OpaqueSurfacesHideWhatFloatsCannotTell)
{
    for (const int samples : {1, 8, 64}) {
        const auto picture = [&](float distance) {
            Scene scene = load("builtin:layers?n=2&alpha=0.5&color=1,0,0;0,1,0");
            scene.materials[0].alpha_mode = AlphaMode::opaque;
            for (Float3& at : scene.meshes[0].positions) at = {20 * at[0], 20 * at[1], -4};
            for (Float3& at : scene.meshes[1].positions) at = {20 * at[0], 20 * at[1], -distance};
            View view;
            view.width = view.height = 40;  // two tiles across, one of them narrow
            view.samples = samples;
            Options options;
            options.method = "blend";
            return render(scene, view, options).image.pixels;
        };
        const auto seen = picture(3), hidden = picture(5);
        EXPECT_NE(seen, hidden);
        constexpr float kStep = 4 * std::numeric_limits<float>::epsilon();
        for (const float steps : {1.0f, 2.0f, 4.0f, 8.0f, 100.0f}) {
            EXPECT_EQ(picture(4 - steps * kStep), seen) << steps;
            EXPECT_EQ(picture(4 + steps * kStep), hidden) << steps;
        }
        EXPECT_EQ(picture(4), hidden);
    }
}

}  // namespace sheer
