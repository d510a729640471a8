// Takes over the same fragments, passes, halves of tiles, memory limits: none of them shows in a
// picture.
#include "cpu/tile_passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include <sheer/error.h>
#include <sheer/sheer.h>

#include "geometry/build.h"
#include "lanes/targets.h"
#include "scene/camera.h"
#include "support/memory.h"

namespace sheer {

namespace {

View small_view(int samples = 4)
{
    View view;
    view.width = 70;  // three tiles, the last of them narrow
    view.height = 40;
    view.samples = samples;
    return view;
}

std::string with_layers(int count)
{
    return "builtin:layers?alpha=0.1&color=1,0,0;0,1,0;0,0,1&n=" + std::to_string(count);
}

std::vector<std::string> all_methods()
{
    std::vector<std::string> ids;
    for (const MethodRow& row : method_table()) {
        if (!row.bench_only) ids.emplace_back(row.id);
    }
    for (const char* other : {"sorted-blend:by=triangle", "stochastic:correction=on",
                              "stochastic:depth-test=before", "stochastic:sample-passes=2"}) {
        ids.emplace_back(other);
    }
    return ids;
}

bool leaves_out_what_is_hidden(const ChosenMethod& method, int samples)
{
    return method.row->verbs(targets_of(Simd::best), method, samples).hidden_behind != nullptr;
}

// Everything at once against one at a time, where what is hidden is left out as fragments arrive.
void expect_takes_are_renders(const Scene& scene, const View& view)
{
    std::vector<Take> takes;
    for (const std::string& method : all_methods()) {
        takes.push_back({choose_method(method), {frame_key(7, 0)}});
    }
    const FrameTakes all = render_takes(scene, view, {}, {takes});
    for (std::size_t i = 0; i < takes.size(); ++i) {
        Options options;
        options.method = all_methods()[i];
        options.seed = 7;
        const Frame alone = render(scene, view, options);
        EXPECT_EQ(all.frames[i].image.pixels, alone.image.pixels) << options.method;
        if (leaves_out_what_is_hidden(takes[i].method, view.samples)) {
            // Of textures, what is hidden may have no opacity, and counts all the same.
            if (!scene.images.empty()) continue;
            EXPECT_LE(alone.stats.fragments, all.frames[i].stats.fragments) << options.method;
        } else {
            EXPECT_EQ(alone.stats.fragments, all.frames[i].stats.fragments) << options.method;
        }
    }
}

// Counts what arrives, pass by pass, and holds only so much.
struct CountingStore {
    std::size_t most = ~std::size_t{0};
    std::vector<std::vector<std::uint32_t>> seen;   // of each pass: pixels in order
    std::map<std::uint32_t, std::size_t> resolved;  // fragments of each pixel

    static StoreVerbs verbs()
    {
        StoreVerbs verbs{};
        verbs.clear = [](void* store, const TilePlace&) {
            static_cast<CountingStore*>(store)->seen.clear();
        };
        verbs.insert = [](void* store, const FragmentStream& stream, int pass) {
            auto& self = *static_cast<CountingStore*>(store);
            self.seen.resize(std::max(self.seen.size(), static_cast<std::size_t>(pass) + 1));
            auto& list = self.seen[static_cast<std::size_t>(pass)];
            if (list.size() + static_cast<std::size_t>(stream.size) > self.most) return false;
            for (int i = 0; i < stream.size; ++i) list.push_back(stream.pixel[i]);
            return true;
        };
        verbs.resolve = [](void* store, SampleColors&) {
            auto& self = *static_cast<CountingStore*>(store);
            for (const auto& pass : self.seen) {
                for (const std::uint32_t pixel : pass) ++self.resolved[pixel];
            }
        };
        return verbs;
    }
};

// The first tile of a picture of layers.
class OneTile {
public:
    explicit OneTile(int layers)
        : scene_(load(with_layers(layers))),
          set_(make_sample_set(4, SamplePositions::center)),  // no pixel has a quad's diagonal
          grid_{32, 32, 0}
    {
        View view = small_view();
        view.width = view.height = 32;
        geometry_ = build_geometry({scene_, resolve_camera(scene_, view), grid_, set_.extent, 1});
        surfaces_ = make_surfaces({scene_, 0, geometry_.eye, 1});
        setting_.job = {&geometry_, &surfaces_, &set_, 0, grid_.rect(0), grid_.rect(0)};
    }

    std::shared_ptr<CountingStore> draw(int passes, bool keep, std::size_t most)
    {
        const StoreVerbs verbs = CountingStore::verbs();
        TilePasses tile(tile_fragments_for(targets_of(Simd::best)), OpaqueTile(4, false),
                        FragmentStream(keep ? kKeptFragments : kStreamFragments));
        if (keep) tile.keep(setting_);
        auto store = std::make_shared<CountingStore>();
        store->most = most;
        TileStore fed{&verbs, store, false,
                      std::vector<Stopwatch>(static_cast<std::size_t>(passes))};
        SampleColors colors(4);
        tile.draw(setting_, fed, colors);
        return store;
    }

private:
    Scene scene_;
    SampleSet set_;
    TileGrid grid_;
    Geometry geometry_;
    FrameSurfaces surfaces_;
    TileSetting setting_{};
};

}  // namespace

TEST(TilePasses, TakesTogetherAreTakesAlone)
{
    expect_takes_are_renders(load("builtin:quads"), small_view());
    expect_takes_are_renders(load("builtin:motor"), small_view(8));
    expect_takes_are_renders(load(SHEER_SOURCE_DIR "/scenes/tea_table.glb"), small_view());
}

TEST(TilePasses, TilesTooLongToKeepAreRasterisedAgain)
{
    // 64 layers over 1,024 pixels: twice what is kept.
    expect_takes_are_renders(load(with_layers(64)), small_view());
}

TEST(TilePasses, GaussianFilterToo)
{
    View view = small_view();
    view.filter = Filter::gaussian;
    expect_takes_are_renders(load("builtin:quads"), view);
}

TEST(TilePasses, EveryPassSeesTheSameFragments)
{
    for (const int layers : {1, 5, 64}) {
        OneTile tile(layers);
        for (const bool keep : {false, true}) {
            const auto store = tile.draw(3, keep, ~std::size_t{0});
            ASSERT_EQ(store->seen.size(), 3u);
            EXPECT_EQ(store->seen[0].size(), 1024u * static_cast<unsigned>(layers));
            EXPECT_EQ(store->seen[1], store->seen[0]);
            EXPECT_EQ(store->seen[2], store->seen[0]);
        }
    }
}

TEST(TilePasses, HalvesTogetherAreTheTile)
{
    OneTile tile(20);
    // From a half to a single pixel of the tile at once.
    for (const std::size_t most : {20480u, 20479u, 5000u, 100u, 20u}) {
        for (const bool keep : {false, true}) {
            const auto store = tile.draw(1, keep, most);
            ASSERT_EQ(store->resolved.size(), 1024u) << most;
            for (const auto& [pixel, count] : store->resolved) ASSERT_EQ(count, 20u) << pixel;
        }
    }
}

TEST(TilePasses, APixelThatDoesNotFitIsAnError)
{
    OneTile tile(20);
    try {
        tile.draw(1, false, 19);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::work);
        EXPECT_STREQ(error.what(), "memory-limit: too low for all fragments of pixel 0,0");
    }
}

TEST(MemoryLimit, ThePictureIsTheSame)
{
    const Scene scene = load(with_layers(300));
    View view = small_view();
    for (const std::string& method : all_methods()) {
        Options options;
        options.method = method;
        const Image free = render(scene, view, options).image;
        // 300 layers of a tile take 22 MB and more; what is left here is about half of that.
        options.memory_limit = resident_memory_bytes() + (24u << 20);
        EXPECT_EQ(render(scene, view, options).image.pixels, free.pixels) << method;
    }
}

TEST(MemoryLimit, TooLittleIsAnErrorThatSaysHowMuchIsNeeded)
{
    Options options;
    options.memory_limit = 1 << 20;
    try {
        render(load("builtin:quads"), small_view(), options);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::work);
        const std::string text = error.what();
        EXPECT_TRUE(text.starts_with("memory-limit: 1 MiB are too little")) << text;
        EXPECT_TRUE(text.ends_with(" MiB are needed")) << text;
    }
}

TEST(Channels, CountWhatIsThere)
{
    const Scene scene = load("builtin:layers?alpha=0.5,0.25,0.5&depth=3,2,4");
    for (const int samples : {1, 8, 64}) {
        Options options;
        options.channels = true;
        View view = small_view(samples);
        const Frame spread = render(scene, view, options);
        view.positions = SamplePositions::center;  // no pixel has fragments of a quad's two halves
        const Frame frame = render(scene, view, options);
        ASSERT_TRUE(frame.channels);
        ASSERT_EQ(frame.channels->fragments.size(), 2800u);
        EXPECT_EQ(spread.channels->depth_complexity, frame.channels->depth_complexity);
        EXPECT_EQ(spread.channels->coverage, frame.channels->coverage);
        for (std::size_t i = 0; i < 2800; ++i) {
            ASSERT_EQ(frame.channels->fragments[i], 3.0f);
            ASSERT_EQ(frame.channels->depth_complexity[i], 3.0f);
            ASSERT_EQ(frame.channels->coverage[i], 1.0f);
            ASSERT_FLOAT_EQ(frame.channels->depth[i], 2.0f);
        }
    }
}

TEST(Channels, AreEmptyWhereNothingIsTransparent)
{
    Options options;
    options.channels = true;
    Scene scene = load("builtin:quads");
    scene.objects.clear();
    const Frame frame = render(scene, small_view(), options);
    ASSERT_TRUE(frame.channels);
    EXPECT_EQ(frame.channels->fragments[0], 0.0f);
    EXPECT_EQ(frame.channels->coverage[0], 0.0f);
    EXPECT_EQ(frame.channels->depth[0], std::numeric_limits<float>::infinity());
    EXPECT_FALSE(render(scene, small_view(), {}).channels);
}

}  // namespace sheer
