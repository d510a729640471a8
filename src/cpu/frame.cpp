// The pipeline on one page: geometry, then tile by tile raster and shade, store, resolve, image.
#include "cpu/frame.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "cpu/backdrop_pictures.h"
#include "cpu/depth_extent.h"
#include "cpu/draw_take.h"
#include "cpu/fragment_sink.h"
#include "cpu/frame_job.h"
#include "cpu/frame_memory.h"
#include "cpu/frame_stats.h"
#include "cpu/reduced_pictures.h"
#include "cpu/shadow_maps.h"
#include "cpu/sky_rays.h"
#include "cpu/stopwatch.h"
#include "geometry/build.h"
#include "geometry/meet.h"
#include "geometry/object_distances.h"
#include "scene/camera.h"
#include "support/memory.h"
#include "support/parallel.h"
#include "support/random.h"

namespace sheer {

namespace {

// Light grey, linear.
constexpr Float4 kDefaultBackground = {0.6f, 0.6f, 0.6f, 1.0f};

bool any_divides(std::span<const Take> takes)
{
    return std::any_of(takes.begin(), takes.end(),
                       [](const Take& take) { return take.method.traits().divides; });
}

std::unique_ptr<Worker> make_worker(const FrameJob& job)
{
    const int samples = job.samples.count;
    auto worker = std::make_unique<Worker>(Worker{
        {job.tile_fragments, OpaqueTile(samples, job.surfaces.any_opaque),
         FragmentStream(job.stream_capacity, job.surfaces.any_colored, any_placed(job.groups))},
        SampleColors(samples, any_divides(job.takes)),
        {},
        {},
        {},
        {}});
    for (std::size_t i = 0; i < job.takes.size(); ++i) {
        const ChosenMethod& method = job.takes[i].method;
        const MethodTraits traits = method.traits();
        const StoreShape shape{&job.samples,
                               &method,
                               job.eye,
                               job.stream_capacity,
                               traits.bounded ? ~std::size_t{0} : job.store_bytes,
                               job.filter.reach() > 0,
                               job.reduced[i] != nullptr ? &job.reduced[i]->moments : nullptr,
                               job.backdrop != nullptr ? &job.backdrop->picture : nullptr};
        worker->stores.push_back({&job.verbs[i], job.verbs[i].make(shape), traits.divides,
                                  std::vector<Stopwatch>(static_cast<std::size_t>(traits.passes))});
    }
    return worker;
}

void draw_tile(const FrameJob& job, int tile, Worker& worker, FrameTakes& result)
{
    const PixelRect rect = job.grid.rect(tile);
    TileSetting setting{{&job.geometry, &job.surfaces, &job.samples, tile, rect, rect},
                        job.background,
                        {rect.x0, rect.y0, 0}};
    setting.job.shading = job.shading;
    for (const TakeGroup& group : job.groups) {
        setting.job.wants = group.wants;
        worker.passes.forget();
        if (group.uses > 1) worker.passes.keep(setting);
        for (const std::size_t take : group.takes) {
            draw_take(job, take, setting, worker, result.frames[take]);
        }
    }
    // The scene's own fragments, whatever the last method asked for.
    setting.job.wants = {};
    const ChannelShape shape{job.samples.count, job.grid.width, job.eye};
    const PixelRect interior = job.grid.interior(tile);
    if (job.sink != nullptr) {
        worker.passes.visit(
            setting, [&](const FragmentStream& s) { job.sink->take(rect, interior, shape, s); });
    }
    if (!result.channels) return;
    worker.channels.clear();
    worker.passes.visit(setting, [&](const FragmentStream& s) { worker.channels.add(s); });
    worker.channels.write(rect, interior, shape, *result.channels);
}

TextureMips texture_mips(const View& view)
{
    return {view.alpha_mips, view.texture_levels};
}

FragmentKinds fragment_kinds(const View& view)
{
    const bool apart = view.samples > 1 && view.positions != SamplePositions::center;
    return {view.conservative, apart && view.shade_at == ShadeAt::sample};
}

FrameSurfaces prepare_surfaces(const Scene& scene, const View& view, const Projection& projection,
                               const Eye& eye, int threads, std::span<const Take> takes)
{
    const bool lit_everywhere =
        view.shadows.kind == ShadowKind::none && view.ambient_occlusion.rays == 0;
    const Shadowed shadowed = lit_everywhere ? Shadowed::no : Shadowed::yes;
    FrameSurfaces result = make_surfaces(
        {scene, view.exposure, eye, threads, shadowed, texture_mips(view), fragment_kinds(view)});
    const auto sorts_objects = [](const Take& take) {
        return take.method.wants().submission == Submission::objects_sorted;
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

EyeSpace eye_space(const Projection& projection)
{
    return {projection.orthographic, static_cast<float>(projection.znear),
            static_cast<float>(projection.zfar)};
}

bool any_measures_depth(std::span<const Take> takes)
{
    return std::any_of(takes.begin(), takes.end(),
                       [](const Take& take) { return take.method.traits().measures_depth; });
}

void make_images(const FrameJob& job, bool channels, FrameTakes& result)
{
    const int width = job.grid.width, height = job.grid.height;
    for (const Take& take : job.takes) {
        result.frames.push_back({Image(width, height), {}, {}, {}, {}});
        if (take.variance) result.frames.back().variance = Image(width, height);
        if (take.transparent) result.frames.back().transparent = Image(width, height);
        if (take.apart && take.method.traits().divides) {
            result.frames.back().fraction.resize(result.frames.back().image.pixels.size());
        }
    }
    if (!channels) return;
    const std::vector<float> none(static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height));
    result.channels = Channels{none, none, none, none, {}};
}

}  // namespace

std::uint32_t frame_key(std::uint64_t seed, std::int64_t frame)
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
    const PlaceSpaces places = places_of(takes, view.ambient_occlusion);
    const std::uint64_t scene_bytes =
        geometry_bytes(scene, places) + texture_bytes(scene, wanted, texture_mips(view));
    if (options.memory_limit != 0) {
        require_memory(options.memory_limit, scene_bytes);
    } else {
        require_machine_memory(scene_bytes);
    }
    for (const Take& take : takes) check_method(take.method, view.samples);
    const TargetSet targets = targets_of(options.simd);
    const SubpixelShift shift{request.shift.x + view.sample_shift[0],
                              request.shift.y + view.sample_shift[1]};
    const SampleSet covered = make_sample_set(view.samples, view.positions, shift);
    const SampleSet samples =
        view.conservative == Conservative::off ? covered : with_whole_pixels(covered);
    const SampleFilter filter(view.filter, samples);
    const TileGrid grid{view.width, view.height, filter.reach()};

    geometry_time.start();
    const Projection projection = resolve_camera(scene, view);
    const int geometry_threads = std::min(wanted, grid.count());
    const Geometry geometry =
        build_geometry({scene, projection, grid, samples.extent, geometry_threads, places});
    FrameSurfaces surfaces =
        prepare_surfaces(scene, view, projection, geometry.eye, geometry_threads, takes);
    geometry_time.stop();
    const FrameShadows shadows =
        prepare_shadows({scene,
                         view.shadows,
                         geometry,
                         surfaces,
                         targets,
                         wanted,
                         frame_key(options.seed, request.shadow_frame),
                         {frame_key(options.seed, 0), request.shadow_frame, request.shadow_frames}},
                        options);
    surfaces.light.shadows = shadows.drawn();
    const std::int64_t number = takes.empty() ? 0 : takes.front().film.number;
    const SkyRays sky = prepare_sky_rays({scene, view.ambient_occlusion, projection, geometry.eye,
                                          surfaces, frame_key(options.seed, number)},
                                         options);

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
                 0,
                 request.sink};
    job.shading = {sky.rays.get(), view.foveation ? &*view.foveation : nullptr};
    if (any_measures_depth(takes) || request.sink != nullptr)
        find_depth_extent(geometry, surfaces, job.eye);
    for (const Take& take : takes) {
        const MethodRow& row = *take.method.row;
        const bool colored = surfaces.any_colored && row.colored_verbs != nullptr;
        job.verbs.push_back(
            (colored ? row.colored_verbs : row.verbs)(targets, take.method, samples.count));
    }
    const auto reduced =
        draw_reduced_pictures(job, scene, projection, targets, geometry_threads, options);
    for (const auto& picture : reduced) job.reduced.push_back(picture ? &*picture : nullptr);
    const auto backdrop = draw_backdrop_picture(job, projection, geometry_threads, options);
    if (backdrop) job.backdrop = &*backdrop;
    job.stream_capacity = stream_capacity(job.groups);
    const MemoryPlan memory =
        plan_frame_memory(job, options, request.reserved_memory, geometry_threads);
    job.store_bytes = memory.store_bytes;

    FrameTakes result;
    make_images(job, options.channels, result);
    Workers workers(static_cast<std::size_t>(memory.threads));
    Reporter reporter(options.progress, grid.count());
    const auto tiles = static_cast<std::size_t>(grid.count());
    parallel_for(memory.threads, tiles, [&](std::size_t tile, int t) {
        if (request.only != nullptr && !meet(grid.interior(static_cast<int>(tile)), *request.only))
            return;
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
    common.ms_passes = shadows.passes;
    common.ms_passes.insert(common.ms_passes.end(), sky.passes.begin(), sky.passes.end());
    common.peak_memory_bytes = peak_memory_bytes();
    for (std::size_t i = 0; i < takes.size(); ++i) {
        result.frames[i].stats = make_stats(workers, job, i, common);
    }
    return result;
}

}  // namespace sheer
