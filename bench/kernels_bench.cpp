// What the stages cost, one thread on this machine's best vector instructions: geometry per
// triangle; rasterising and shading, and each method's store, per fragment of the motor's fullest
// tile. The column `each` is the time of one triangle or fragment.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <vector>

#include <sheer/sheer.h>

#include "cpu/tile_passes.h"
#include "geometry/build.h"
#include "methods/method.h"
#include "scene/camera.h"

namespace sheer {

namespace {

constexpr int kPictureSize = 800;

const Scene& motor()
{
    static const Scene scene = load("builtin:motor");
    return scene;
}

TargetSet targets()
{
    return targets_of(Simd::best);
}

// Time of one of `count` things that every iteration does.
void report_each(benchmark::State& state, std::uint64_t count)
{
    using benchmark::Counter;
    state.counters["each"] =
        Counter(static_cast<double>(count), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

template <class T>
void copy(const AlignedArray<T>& from, AlignedArray<T>& to)
{
    std::copy_n(from.data(), from.size(), to.data());
}

FragmentStream copy_of(const FragmentStream& stream)
{
    FragmentStream result(stream.capacity);
    result.size = stream.size;
    result.run_count = stream.run_count;
    copy(stream.runs, result.runs);
    copy(stream.pixel, result.pixel);
    copy(stream.samples, result.samples);
    copy(stream.samples_high, result.samples_high);
    copy(stream.depth, result.depth);
    copy(stream.red, result.red);
    copy(stream.green, result.green);
    copy(stream.blue, result.blue);
    copy(stream.opacity, result.opacity);
    return result;
}

// The motor's fullest tile at one number of samples, ready to be drawn again and again.
class FullestTile {
public:
    explicit FullestTile(int samples)
        : set_(make_sample_set(samples, SamplePositions::standard)),
          opaque_(samples, false),
          stream_(kStreamFragments)
    {
        View view;
        view.width = view.height = kPictureSize;
        const Projection projection = resolve_camera(motor(), view);
        geometry_ = build_geometry({motor(), projection, grid_, set_.extent, 1});
        surfaces_ = make_surfaces({motor(), 0, geometry_.eye, 1});
        std::vector<std::size_t> triangles(static_cast<std::size_t>(grid_.count()));
        for (const TriangleChunk& chunk : geometry_.chunks) {
            for (std::size_t t = 0; t + 1 < chunk.tile_begin.size(); ++t) {
                triangles[t] += chunk.tile_begin[t + 1] - chunk.tile_begin[t];
            }
        }
        const auto fullest = std::max_element(triangles.begin(), triangles.end());
        tile_ = static_cast<int>(fullest - triangles.begin());
        draw({record, this});
        record(this, stream_);
    }

    void draw(const FragmentConsumer& consumer)
    {
        const PixelRect rect = grid_.rect(tile_);
        const TileJob job{&geometry_, &surfaces_, &set_, tile_, rect, rect};
        tile_fragments_for(targets())(job, scratch_, opaque_, stream_, consumer);
    }

    const SampleSet& samples() const { return set_; }
    const std::vector<FragmentStream>& streams() const { return streams_; }
    std::uint64_t fragments() const { return fragments_; }

private:
    static bool record(void* context, const FragmentStream& stream)
    {
        auto& self = *static_cast<FullestTile*>(context);
        self.streams_.push_back(copy_of(stream));
        self.fragments_ += static_cast<std::uint64_t>(stream.size);
        return true;
    }

    TileGrid grid_{kPictureSize, kPictureSize, 0};
    SampleSet set_;
    Geometry geometry_;
    FrameSurfaces surfaces_;
    TileScratch scratch_;
    OpaqueTile opaque_;
    FragmentStream stream_;
    int tile_ = 0;
    std::vector<FragmentStream> streams_;
    std::uint64_t fragments_ = 0;
};

void geometry(benchmark::State& state)
{
    const SampleSet set = make_sample_set(8, SamplePositions::standard);
    View view;
    view.width = view.height = kPictureSize;
    const Projection projection = resolve_camera(motor(), view);
    std::uint64_t triangles = 0;
    for (auto _ : state) {
        const Geometry built =
            build_geometry({motor(), projection, {kPictureSize, kPictureSize, 0}, set.extent, 1});
        triangles = built.submitted;
        benchmark::DoNotOptimize(built.chunks.data());
    }
    report_each(state, triangles);
}

void raster_and_shade(benchmark::State& state)
{
    FullestTile tile(static_cast<int>(state.range(0)));
    for (auto _ : state) tile.draw({[](void*, const FragmentStream&) { return true; }, nullptr});
    report_each(state, tile.fragments());
}

// Clears the method's store and inserts the tile's fragments; resolves it too if asked.
void store(benchmark::State& state, const std::string& name, bool with_resolve)
{
    const FullestTile tile(static_cast<int>(state.range(0)));
    const int samples = tile.samples().count;
    const ChosenMethod method = choose_method(name);
    const MethodTraits traits = method.traits();
    const StoreVerbs verbs = method.row->verbs(targets(), method, samples);
    const std::shared_ptr<void> kept = verbs.make({&tile.samples(),
                                                   &method,
                                                   {false, 0.1f, 100.0f},
                                                   kStreamFragments,
                                                   ~std::size_t{0},
                                                   false});
    SampleColors colors(samples, traits.divides);
    for (auto _ : state) {
        verbs.clear(kept.get(), {});
        const auto done = [&] { return verbs.done != nullptr && verbs.done(kept.get()); };
        for (int pass = 0; pass < traits.passes && (pass == 0 || !done()); ++pass) {
            for (const FragmentStream& s : tile.streams()) verbs.insert(kept.get(), s, pass);
        }
        if (with_resolve) {
            std::fill_n(colors.values.data(), colors.values.size(), 0.6f);
            verbs.resolve(kept.get(), colors);
        }
        benchmark::ClobberMemory();
    }
    report_each(state, tile.fragments());
}

void register_all()
{
    benchmark::RegisterBenchmark("geometry", geometry)->Unit(benchmark::kMillisecond);
    const auto at_samples = [](benchmark::internal::Benchmark* b) {
        b->ArgName("samples")->Arg(1)->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMicrosecond);
    };
    at_samples(benchmark::RegisterBenchmark("raster_and_shade", raster_and_shade));
    std::vector<std::string> methods = {"stochastic:correction=on",
                                        "stochastic:depth-based=on:correction=on"};
    for (const MethodRow& row : method_table()) {
        if (!row.bench_only) methods.push_back(row.id);
    }
    for (const std::string& method : methods) {
        for (const bool with_resolve : {false, true}) {
            const std::string name = method + (with_resolve ? "/insert_and_resolve" : "/insert");
            at_samples(benchmark::RegisterBenchmark(
                name.c_str(),
                [method, with_resolve](benchmark::State& s) { store(s, method, with_resolve); }));
        }
    }
}

}  // namespace

}  // namespace sheer

int main(int argc, char** argv)
{
    sheer::register_all();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::AddCustomContext("simd", sheer::name_of_targets(sheer::targets()));
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
