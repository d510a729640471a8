// The pipeline on one page: geometry, then tile by tile raster and shade, store, resolve, image.
#include "cpu/frame.h"

#include <algorithm>
#include <mutex>

#include "cpu/filter.h"
#include "cpu/stopwatch.h"
#include "cpu/tile_fragments.h"
#include "geometry/build.h"
#include "methods/method.h"
#include "scene/camera.h"
#include "support/memory.h"
#include "support/parallel.h"

namespace sheer {

namespace {

// The stream and the store of a tile share the second-level cache: about 150 KB of fragments.
constexpr int kStreamFragments = 4096;

// Light grey, linear.
constexpr Float4 kDefaultBackground = {0.6f, 0.6f, 0.6f, 1.0f};

// What all tiles read.
struct FrameJob {
    const Geometry& geometry;
    const FrameSurfaces& surfaces;
    const SampleSet& samples;
    const SampleFilter& filter;
    TileGrid grid;
    Float4 background;
    StoreVerbs verbs;
    TileFragmentsFunction tile_fragments;
};

// What one thread works with, tile after tile.
struct Worker {
    TileScratch scratch;
    OpaqueTile opaque;
    FragmentStream stream;
    SampleColors colors;
    std::shared_ptr<void> store;
    const StoreVerbs* verbs = nullptr;

    std::uint64_t fragments = 0;
    Stopwatch raster_shade, storing, resolving;
};

std::unique_ptr<Worker> make_worker(const FrameJob& job)
{
    auto worker = std::make_unique<Worker>();
    worker->opaque = OpaqueTile(job.samples.count, job.surfaces.any_opaque);
    worker->stream = FragmentStream(kStreamFragments);
    worker->colors = SampleColors(job.samples.count);
    worker->store = job.verbs.make({&job.samples});
    worker->verbs = &job.verbs;
    return worker;
}

void insert_fragments(void* context, const FragmentStream& stream)
{
    auto& worker = *static_cast<Worker*>(context);
    worker.raster_shade.stop();
    worker.storing.start();
    worker.verbs->insert(worker.store.get(), stream, 0);
    worker.fragments += static_cast<std::uint64_t>(stream.size);
    worker.storing.stop();
    worker.raster_shade.start();
}

// What is behind everything transparent.
void fill_backdrop(const OpaqueTile& opaque, const Float4& background, SampleColors& colors)
{
    const auto samples = static_cast<std::size_t>(colors.samples);
    for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
        for (std::size_t c = 0; c < 4; ++c) {
            std::fill_n(colors.channel(pixel, c), samples, background[c]);
        }
        if (!opaque.any) continue;
        const float* channels[3] = {opaque.red.data(), opaque.green.data(), opaque.blue.data()};
        for (std::size_t s = 0; s < samples; ++s) {
            const std::size_t at = pixel * samples + s;
            if (opaque.depth[at] == std::numeric_limits<float>::infinity()) continue;
            for (std::size_t c = 0; c < 3; ++c) colors.channel(pixel, c)[s] = channels[c][at];
            colors.channel(pixel, 3)[s] = 1.0f;
        }
    }
}

void render_tile(const FrameJob& job, int tile, Worker& worker, Image& image)
{
    const PixelRect rect = job.grid.rect(tile);

    worker.raster_shade.start();
    job.verbs.clear(worker.store.get());
    const TileJob tile_job{&job.geometry, &job.surfaces, &job.samples, tile, rect};
    job.tile_fragments(tile_job, worker.scratch, worker.opaque, worker.stream,
                       {insert_fragments, &worker});
    worker.raster_shade.stop();

    worker.resolving.start();
    fill_backdrop(worker.opaque, job.background, worker.colors);
    job.verbs.resolve(worker.store.get(), worker.colors);
    job.filter.apply(worker.colors, rect, job.grid.interior(tile), image);
    worker.resolving.stop();
}

FrameSurfaces prepare_surfaces(const Scene& scene, float exposure)
{
    FrameSurfaces result{make_surfaces(scene, exposure), make_light(scene)};
    result.any_opaque =
        std::any_of(result.surfaces.begin(), result.surfaces.end(),
                    [](const Surface& s) { return s.alpha_mode != AlphaMode::blend; });
    return result;
}

// Tells the caller how far it is, from one thread at a time.
class Reporter {
public:
    Reporter(const std::function<void(double)>& report, int count) : report_(report), count_(count)
    {
    }
    void done_one()
    {
        if (!report_) return;
        const std::lock_guard lock(mutex_);
        report_(static_cast<double>(++done_) / count_);
    }

private:
    const std::function<void(double)>& report_;
    const int count_;
    int done_ = 0;
    std::mutex mutex_;
};

void sum_up(const std::vector<std::unique_ptr<Worker>>& workers, Stats& stats)
{
    for (const auto& worker : workers) {
        if (!worker) continue;
        stats.fragments += worker->fragments;
        stats.ms_raster_shade += worker->raster_shade.ms();
        stats.ms_store += worker->storing.ms();
        stats.ms_resolve += worker->resolving.ms();
    }
    const double threads = stats.threads;
    stats.ms_raster_shade /= threads;
    stats.ms_store /= threads;
    stats.ms_resolve /= threads;
    stats.ms_passes = {{"fragments", stats.ms_raster_shade + stats.ms_store}};
}

}  // namespace

Frame render_frame(const Scene& scene, const View& view, const Options& options)
{
    Stopwatch total, geometry_time;
    total.start();
    const ChosenMethod method = choose_method(options.method);
    const TargetSet targets = targets_of(options.simd);
    const SampleSet samples = make_sample_set(view.samples, view.positions);
    const SampleFilter filter(view.filter, samples);
    const TileGrid grid{view.width, view.height, filter.reach()};
    const int wanted = options.threads > 0 ? options.threads : hardware_threads();
    const int threads = std::min(wanted, grid.count());

    geometry_time.start();
    const Projection projection = resolve_camera(scene, view);
    const Geometry geometry = build_geometry({scene, projection, grid, samples.extent, threads});
    const FrameSurfaces surfaces = prepare_surfaces(scene, view.exposure);
    geometry_time.stop();

    const Float4 background =
        view.background ? *view.background : scene.background.value_or(kDefaultBackground);
    const FrameJob job{geometry,
                       surfaces,
                       samples,
                       filter,
                       grid,
                       background,
                       method.row->verbs(targets, samples.count),
                       tile_fragments_for(targets)};
    Frame frame{Image(view.width, view.height), {}};
    std::vector<std::unique_ptr<Worker>> workers(static_cast<std::size_t>(threads));
    Reporter reporter(options.progress, grid.count());
    parallel_for(threads, static_cast<std::size_t>(grid.count()), [&](std::size_t tile, int t) {
        std::unique_ptr<Worker>& worker = workers[static_cast<std::size_t>(t)];
        if (!worker) worker = make_worker(job);
        render_tile(job, static_cast<int>(tile), *worker, frame.image);
        reporter.done_one();
    });
    total.stop();

    Stats& stats = frame.stats;
    stats.method = method.row->id;
    stats.parameters = method.parameters_text();
    stats.samples = samples.count;
    stats.width = view.width;
    stats.height = view.height;
    stats.simd = name_of_targets(targets);
    stats.threads = threads;
    stats.seed = options.seed;
    stats.triangles = geometry.submitted;
    stats.passes = method.row->passes;
    stats.ms_geometry = geometry_time.ms();
    stats.ms_total = total.ms();
    sum_up(workers, stats);
    const double pixels = static_cast<double>(view.width) * view.height;
    stats.bytes_per_pixel =
        method.row->bytes_per_pixel(samples.count, static_cast<double>(stats.fragments) / pixels);
    stats.peak_memory_bytes = peak_memory_bytes();
    return frame;
}

}  // namespace sheer
