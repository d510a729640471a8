// Fragments that a consumer says are hidden are not shaded: those in pixels where it is nearer than
// the whole triangle, and no others.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include <sheer/sheer.h>

#include "cpu/tile_fragments.h"
#include "geometry/build.h"
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
    }
    int count() const { return grid_.count(); }

    // `hidden`: of kTilePixels, or null. Returns how many fragments were left out.
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
            if (all_have_opacity) EXPECT_EQ(count, difference) << source << ", tile " << tile;
            EXPECT_GE(count, difference) << source << ", tile " << tile;
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

}  // namespace sheer
