// The pipeline on one page: geometry, then tile by tile raster and shade, store, resolve, image.
#include "cpu/frame.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "cpu/channels.h"
#include "cpu/filter.h"
#include "cpu/memory_plan.h"
#include "cpu/stopwatch.h"
#include "cpu/take_groups.h"
#include "cpu/tile_mean.h"
#include "cpu/tile_passes.h"
#include "geometry/build.h"
#include "geometry/object_distances.h"
#include "geometry/pose.h"
#include "scene/camera.h"
#include "support/memory.h"
#include "support/parallel.h"
#include "support/random.h"

namespace sheer {

namespace {

// Light grey, linear.
constexpr Float4 kDefaultBackground = {0.6f, 0.6f, 0.6f, 1.0f};

// What all tiles read.
struct FrameJob {
    std::span<const Take> takes;
    std::vector<Group> groups;
    const Geometry& geometry;
    const FrameSurfaces& surfaces;
    const SampleSet& samples;
    const SampleFilter& filter;
    TileGrid grid;
    Float4 background;
    EyeSpace eye;
    std::vector<StoreVerbs> verbs;  // of each take
    TileFragmentsFunction tile_fragments;
    int stream_capacity;
    std::size_t store_bytes;  // for a store that grows
};

// What one thread works with, tile after tile.
struct Worker {
    TilePasses passes;
    SampleColors colors;
    std::vector<TileStore> stores;  // of each take
    std::vector<Float4> pixels;
    TileMean mean;
    ChannelTile channels;
};

std::unique_ptr<Worker> make_worker(const FrameJob& job)
{
    const int samples = job.samples.count;
    auto worker = std::make_unique<Worker>(
        Worker{{job.tile_fragments, OpaqueTile(samples, job.surfaces.any_opaque),
                FragmentStream(job.stream_capacity, job.surfaces.any_colored)},
               SampleColors(samples),
               {},
               {},
               {},
               {}});
    for (std::size_t i = 0; i < job.takes.size(); ++i) {
        const ChosenMethod& method = job.takes[i].method;
        const StoreShape shape{&job.samples, &method, job.eye, job.stream_capacity,
                               method.row->bounded ? ~std::size_t{0} : job.store_bytes};
        worker->stores.push_back({&job.verbs[i], job.verbs[i].make(shape), method.row->passes});
    }
    return worker;
}

void draw_take(const FrameJob& job, std::size_t number, TileSetting& setting, Worker& worker,
               TakeFrame& frame)
{
    const Take& take = job.takes[number];
    const PixelRect interior = job.grid.interior(setting.job.tile);
    TileStore& store = worker.stores[number];
    worker.mean.clear();
    for (const std::uint32_t key : take.keys) {
        setting.place.key = key;
        worker.passes.draw(setting, store, worker.colors);
        store.resolving.start();
        job.filter.apply(worker.colors, setting.job.rect, interior, worker.pixels);
        worker.mean.add(worker.pixels);
        store.resolving.stop();
    }
    worker.mean.write_mean(interior, frame.image);
    if (take.variance) worker.mean.write_variance(interior, frame.variance);
}

void draw_tile(const FrameJob& job, int tile, Worker& worker, FrameTakes& result)
{
    const PixelRect rect = job.grid.rect(tile);
    TileSetting setting{{&job.geometry, &job.surfaces, &job.samples, tile, rect, rect},
                        job.background,
                        {rect.x0, rect.y0, 0}};
    for (const Group& group : job.groups) {
        setting.job.submission = group.submission;
        worker.passes.forget();
        if (group.uses > 1) worker.passes.keep(setting);
        for (const std::size_t take : group.takes) {
            draw_take(job, take, setting, worker, result.frames[take]);
        }
    }
    if (!result.channels) return;
    worker.channels.clear();
    worker.passes.visit(setting, [&](const FragmentStream& s) { worker.channels.add(s); });
    worker.channels.write(rect, job.grid.interior(tile),
                          {job.samples.count, job.grid.width, job.eye}, *result.channels);
}

FrameSurfaces prepare_surfaces(const Scene& scene, const View& view, const Projection& projection,
                               const Eye& eye, int threads, std::span<const Take> takes)
{
    FrameSurfaces result = make_surfaces(scene, view.exposure, eye, threads);
    const auto sorts_objects = [](const Take& take) {
        return submission_of(take) == Submission::objects_sorted;
    };
    if (std::any_of(takes.begin(), takes.end(), sorts_objects)) {
        result.distances = object_distances(scene, projection);
    }
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

using Workers = std::vector<std::unique_ptr<Worker>>;

// The stages of one take, summed over the threads.
void sum_up(const Workers& workers, const FrameJob& job, std::size_t take, Stats& stats)
{
    const Submission submission = submission_of(job.takes[take]);
    for (const auto& worker : workers) {
        if (!worker) continue;
        const TileStore& store = worker->stores[take];
        stats.fragments += store.fragments;
        stats.ms_raster_shade += store.raster_shade.ms() + worker->passes.ms_keeping(submission);
        stats.ms_store += store.storing.ms();
        stats.ms_resolve += store.resolving.ms();
    }
    const double threads = stats.threads;
    stats.ms_raster_shade /= threads;
    stats.ms_store /= threads;
    stats.ms_resolve /= threads;
    stats.ms_passes = {{"fragments", stats.ms_raster_shade + stats.ms_store}};
    stats.fragments /= job.takes[take].keys.size();
}

Stats make_stats(const Workers& workers, const FrameJob& job, std::size_t number, Stats common)
{
    const ChosenMethod& method = job.takes[number].method;
    Stats stats = std::move(common);
    stats.method = method.row->id;
    stats.parameters = method.parameters_text();
    stats.passes = method.row->passes;
    sum_up(workers, job, number, stats);
    // Of several takes each would have needed the geometry and its own stages.
    if (job.takes.size() > 1) {
        stats.ms_total =
            stats.ms_geometry + stats.ms_raster_shade + stats.ms_store + stats.ms_resolve;
    }
    const double pixels = static_cast<double>(stats.width) * stats.height;
    stats.bytes_per_pixel =
        method.row->bytes_per_pixel(stats.samples, static_cast<double>(stats.fragments) / pixels);
    return stats;
}

// At most: posed vertices, and triangles in chunks that grow, none of them culled.
std::uint64_t geometry_bytes(const Scene& scene)
{
    const bool textured = std::any_of(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& m) {
        return !m.texcoords[0].empty() || !m.texcoords[1].empty() || !m.tangents.empty();
    });
    const std::size_t attribute_bytes =
        sizeof(Attributes) + (textured ? sizeof(TextureAttributes) : 0);
    const std::size_t vertex_bytes = sizeof(PosedVertex) + attribute_bytes;
    constexpr std::size_t kTriangleBytes = 2 * sizeof(Triangle) + 4 * sizeof(std::uint32_t);
    // Of a ribbon or square on its way, which is a mesh of its own.
    constexpr std::size_t kMadeBytes =
        3 * (2 * sizeof(Float3) + sizeof(Float4) + 2 * sizeof(Float2));
    std::uint64_t bytes = 0;
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        const std::size_t indices = mesh.indices.size();
        switch (mesh.topology) {
            case Topology::triangles:
                bytes += mesh.positions.size() * vertex_bytes + indices / 3 * kTriangleBytes;
                // Vertices of their own, in a vector that grows.
                if (mesh.normals.empty()) bytes += 2 * indices * attribute_bytes;
                // Tangents on their way.
                if (mesh.tangents.empty() && scene.materials[mesh.material].normal_texture) {
                    bytes += mesh.positions.size() * (9 * sizeof(double) + sizeof(Float4));
                }
                break;
            case Topology::lines:
                bytes += indices * (2 * (vertex_bytes + kMadeBytes) + kTriangleBytes);
                break;
            case Topology::points:
                bytes += indices * (4 * (vertex_bytes + kMadeBytes) + 2 * kTriangleBytes);
                break;
        }
    }
    return bytes;
}

std::size_t most_triangles_of_a_tile(const Geometry& geometry, int tiles)
{
    std::vector<std::size_t> counts(static_cast<std::size_t>(tiles));
    for (const TriangleChunk& chunk : geometry.chunks) {
        for (std::size_t t = 0; t + 1 < chunk.tile_begin.size(); ++t) {
            counts[t] += chunk.tile_begin[t + 1] - chunk.tile_begin[t];
        }
    }
    return counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
}

// Of one thread, but for the stores that grow. A vector that grows holds its old contents beside
// the new for a while: three times what it was.
std::size_t thread_bytes(const FrameJob& job)
{
    const auto samples = static_cast<std::size_t>(job.samples.count);
    const std::size_t pixel_samples = kTilePixels * samples;
    const std::size_t per_fragment = sizeof(FragmentRun) + 19 * sizeof(float);
    std::size_t bytes = static_cast<std::size_t>(job.stream_capacity) * per_fragment +
                        pixel_samples * sizeof(Float4) + kTilePixels * 10 * sizeof(Float4);
    const std::size_t triangles = most_triangles_of_a_tile(job.geometry, job.grid.count());
    if (job.surfaces.any_opaque) {
        bytes += pixel_samples * 6 * sizeof(float) + triangles * 3 * sizeof(OpaqueSurface);
    }
    const bool sorts = std::any_of(job.groups.begin(), job.groups.end(), [](const Group& group) {
        return group.submission != Submission::as_given;
    });
    if (sorts) bytes += triangles * 4 * sizeof(SortedTriangle);  // and what stable_sort takes
    for (const Take& take : job.takes) {
        if (!take.method.row->bounded) continue;
        bytes += kTilePixels *
                 static_cast<std::size_t>(take.method.row->bytes_per_pixel(job.samples.count, 0));
    }
    return bytes;
}

MemoryPlan plan(const FrameJob& job, const Options& options, std::uint64_t reserved, int threads)
{
    MemoryNeeds needs{.limit = options.memory_limit,
                      .pixels = static_cast<std::uint64_t>(job.grid.width) *
                                static_cast<std::uint64_t>(job.grid.height),
                      .pictures = options.channels ? 1u : 0u,
                      .thread_bytes = thread_bytes(job),
                      .growing_stores = 0,
                      .threads = threads,
                      .reserved = reserved};
    for (const Take& take : job.takes) {
        needs.pictures += take.variance ? 2 : 1;
        if (!take.method.row->bounded) ++needs.growing_stores;
    }
    return plan_memory(needs);
}

EyeSpace eye_space(const Projection& projection)
{
    return {projection.orthographic, static_cast<float>(projection.znear),
            static_cast<float>(projection.zfar)};
}

void make_images(const FrameJob& job, bool channels, FrameTakes& result)
{
    const int width = job.grid.width, height = job.grid.height;
    for (const Take& take : job.takes) {
        result.frames.push_back({Image(width, height), {}, {}});
        if (take.variance) result.frames.back().variance = Image(width, height);
    }
    if (!channels) return;
    const std::vector<float> none(static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height));
    result.channels = Channels{none, none, none, none};
}

}  // namespace

std::uint32_t frame_key(std::uint64_t seed, int frame)
{
    const CounterRandom random{seed};
    return static_cast<std::uint32_t>(random.bits(static_cast<std::uint64_t>(frame)) >> 32);
}

FrameTakes render_takes(const Scene& scene, const View& view, const Options& options,
                        const TakesRequest& request)
{
    Stopwatch total, geometry_time;
    total.start();
    const std::span<const Take> takes = request.takes;
    const int wanted = options.threads > 0 ? options.threads : hardware_threads();
    if (options.memory_limit != 0) {
        require_memory(options.memory_limit, geometry_bytes(scene) + texture_bytes(scene, wanted));
    }
    const TargetSet targets = targets_of(options.simd);
    const SampleSet samples = make_sample_set(view.samples, view.positions, request.shift);
    const SampleFilter filter(view.filter, samples);
    const TileGrid grid{view.width, view.height, filter.reach()};

    geometry_time.start();
    const Projection projection = resolve_camera(scene, view);
    const int geometry_threads = std::min(wanted, grid.count());
    const Geometry geometry =
        build_geometry({scene, projection, grid, samples.extent, geometry_threads});
    const FrameSurfaces surfaces =
        prepare_surfaces(scene, view, projection, geometry.eye, geometry_threads, takes);
    geometry_time.stop();

    FrameJob job{takes,
                 group_takes(takes),
                 geometry,
                 surfaces,
                 samples,
                 filter,
                 grid,
                 view.background ? *view.background : scene.background.value_or(kDefaultBackground),
                 eye_space(projection),
                 {},
                 tile_fragments_for(targets),
                 0,
                 0};
    for (const Take& take : takes) {
        const MethodRow& row = *take.method.row;
        const bool colored = surfaces.any_colored && row.colored_verbs != nullptr;
        job.verbs.push_back(
            (colored ? row.colored_verbs : row.verbs)(targets, take.method, samples.count));
    }
    job.stream_capacity = stream_capacity(job.groups);
    const MemoryPlan memory = plan(job, options, request.reserved_memory, geometry_threads);
    job.store_bytes = memory.store_bytes;

    FrameTakes result;
    make_images(job, options.channels, result);
    Workers workers(static_cast<std::size_t>(memory.threads));
    Reporter reporter(options.progress, grid.count());
    const auto tiles = static_cast<std::size_t>(grid.count());
    parallel_for(memory.threads, tiles, [&](std::size_t tile, int t) {
        std::unique_ptr<Worker>& worker = workers[static_cast<std::size_t>(t)];
        if (!worker) worker = make_worker(job);
        draw_tile(job, static_cast<int>(tile), *worker, result);
        reporter.done_one();
    });
    total.stop();

    Stats common;
    common.samples = samples.count;
    common.width = view.width;
    common.height = view.height;
    common.simd = name_of_targets(targets);
    common.threads = memory.threads;
    common.seed = options.seed;
    common.triangles = geometry.submitted;
    common.ms_geometry = geometry_time.ms();
    common.ms_total = total.ms();
    common.peak_memory_bytes = peak_memory_bytes();
    for (std::size_t i = 0; i < takes.size(); ++i) {
        result.frames[i].stats = make_stats(workers, job, i, common);
    }
    return result;
}

Frame render_frame(const Scene& scene, const View& view, const Options& options)
{
    Take take{choose_method(options.method), {}, false};
    const int frames = take.method.row->random ? options.accumulate : 1;
    for (int i = 0; i < frames; ++i) take.keys.push_back(frame_key(options.seed, i));
    FrameTakes result = render_takes(scene, view, options, {{&take, 1}});
    if (options.memory_limit != 0) release_free_memory();
    TakeFrame& frame = result.frames.front();
    return {std::move(frame.image), std::move(frame.stats), std::move(result.channels)};
}

}  // namespace sheer
