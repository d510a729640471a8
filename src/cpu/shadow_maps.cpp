// A light at a time: geometry, then tile by tile fragments into the map.
#include "cpu/shadow_maps.h"

#include <algorithm>
#include <memory>

#include "cpu/depth_extent.h"
#include "cpu/frame_memory.h"
#include "cpu/light_views.h"
#include "cpu/moment_shadows.h"
#include "cpu/shadow_store.h"
#include "cpu/stopwatch.h"
#include "cpu/tile_fragments.h"
#include "cpu/tile_passes.h"
#include "cpu/tracked_shadows.h"
#include "geometry/build.h"
#include "methods/depth_range.h"
#include "shade/moment_part.h"
#include "shade/light_rays.h"
#include "support/memory.h"
#include "support/parallel.h"
#include "support/random.h"

namespace sheer {

namespace {

// What one thread works with, tile after tile.
struct ShadowWorker {
    TileScratch scratch;
    OpaqueTile opaque;
    FragmentStream stream;
    std::unique_ptr<ShadowTileStore> store;  // or null
};

struct ShadowJob {
    const ShadowPass& pass;
    const Geometry& geometry;
    const FrameSurfaces& casters;
    const SampleSet& set;
    TileGrid grid;
    FrameOfPicture frame;
};

// Sent the stream of a tile.
struct Insertion {
    InsertShadows insert;
    const ShadowTile& tile;
    ShadowTileStore* store;

    void operator()(const FragmentStream& stream) const
    {
        if (store != nullptr) {
            store->insert(tile, stream);
        } else {
            insert(tile, stream);
        }
    }
};

void draw_tile(const ShadowJob& job, int number, ShadowWorker& worker, ShadowMap& map)
{
    const ShadowPass& pass = job.pass;
    const PixelRect rect = job.grid.rect(number);
    const ShadowTile tile{map, job.set, rect, pass.shadows.masks};
    clear_shadow_tile(tile);
    if (worker.store) worker.store->begin(tile, job.frame);
    Insertion insertion{insert_shadows_for(pass.targets), tile, worker.store.get()};
    const FragmentConsumer consumer{[](void* context, const FragmentStream& stream) {
                                        (*static_cast<const Insertion*>(context))(stream);
                                        return true;
                                    },
                                    &insertion};
    const TileJob fragments{&job.geometry, &job.casters, &job.set, number, rect, rect};
    tile_fragments_for(pass.targets)(fragments, worker.scratch, worker.opaque, worker.stream,
                                     consumer);
    insertion(worker.stream);
    if (worker.store) worker.store->end(tile);
    insert_opaque_shadows(tile, worker.opaque);
}

std::unique_ptr<ShadowTileStore> make_tile_store(const ShadowPass& pass, const ShadowMap& map,
                                                 const SampleSet& set)
{
    if (pass.shadows.kind == ShadowKind::moment) {
        return make_moment_shadows(pass.targets, map, set, kStreamFragments);
    }
    if (!is_tracked(pass.shadows.masks)) return nullptr;
    return make_tracked_shadows(pass.targets, map, set, pass.shadows.masks);
}

// Between the nearest and the farthest of what is transparent to the light, and a little more:
// points before all of it, or behind, are not where it is.
void set_depth_range(const Geometry& geometry, const FrameSurfaces& casters,
                     const Projection& light, ShadowMap& map)
{
    EyeSpace eye{light.orthographic, static_cast<float>(light.znear),
                 static_cast<float>(light.zfar)};
    find_depth_extent(geometry, casters, eye);
    const DepthRange range = depth_range(eye, true);
    map.moments->is_distance = range.is_distance;
    map.moments->from = range.from - (1 / kFarthestPlace - 1) / range.scale;
    map.moments->scale = kFarthestPlace * range.scale;
}

std::unique_ptr<ShadowMap> draw_map(const ShadowPass& pass, const FrameSurfaces& casters,
                                    const Projection& light, std::uint32_t key,
                                    const FrameOfPicture& frame)
{
    const Shadows& shadows = pass.shadows;
    const SampleSet set = make_sample_set(shadows.samples, SamplePositions::standard);
    const TileGrid grid{shadows.size, shadows.size, 0};
    const Geometry geometry = build_geometry({pass.scene, light, grid, set.extent, pass.threads});
    const bool colored = shadows.colored && shadows.kind == ShadowKind::stochastic;
    const int layers = colored && casters.any_colored ? 3 : 1;
    auto map =
        std::make_unique<ShadowMap>(light, shadows, layers, set, pass.seen.eye.position, key);
    if (map->moments) set_depth_range(geometry, casters, light, *map);
    const ShadowJob job{pass, geometry, casters, set, grid, frame};
    std::vector<std::unique_ptr<ShadowWorker>> workers(static_cast<std::size_t>(pass.threads));
    parallel_for(pass.threads, static_cast<std::size_t>(grid.count()),
                 [&](std::size_t tile, int thread) {
                     auto& worker = workers[static_cast<std::size_t>(thread)];
                     if (!worker) {
                         worker = std::make_unique<ShadowWorker>(
                             ShadowWorker{{},
                                          OpaqueTile(shadows.samples, casters.any_opaque),
                                          FragmentStream(kStreamFragments, casters.any_colored),
                                          {}});
                         worker->store = make_tile_store(pass, *map, set);
                     }
                     draw_tile(job, static_cast<int>(tile), *worker, *map);
                 });
    return map;
}

// At most: what the pass keeps and what it needs on its way.
std::uint64_t shadow_bytes(const ShadowPass& pass)
{
    const Shadows& shadows = pass.shadows;
    const auto size = static_cast<std::uint64_t>(shadows.size);
    const auto samples = static_cast<std::uint64_t>(shadows.samples);
    std::uint64_t lights = pass.scene.sun.color == Float3{0, 0, 0} ? 0 : 1;
    for (const Light& light : pass.scene.lights) lights += light.kind != LightKind::point;
    // Beside the pictures' triangles those of one light, or of all lights as trees.
    if (shadows.kind == ShadowKind::exact) return 2 * lights * geometry_bytes(pass.scene);
    const std::uint64_t layers = shadows.colored ? 3 : 1;
    const std::uint64_t moment_bytes =
        shadows.kind == ShadowKind::moment ? kFourMoments * sizeof(double) : 0;  // a texel
    const std::uint64_t tracked_bytes =
        is_tracked(shadows.masks) ? kTilePixels * layers * (8 * samples + 64) : 0;
    const std::uint64_t sum_bytes =
        moment_bytes * kTilePixels + (moment_bytes > 0 ? kStreamFragments * sizeof(float) : 0);
    const std::uint64_t thread_bytes =
        kTilePixels * samples * 6 * sizeof(float) + tracked_bytes + sum_bytes +
        kStreamFragments * (sizeof(FragmentRun) + 20 * sizeof(float));
    const std::uint64_t values = shadows.correction ? 2 * layers + 1 : layers;
    return lights * size * size * (samples * values * sizeof(float) + moment_bytes) +
           geometry_bytes(pass.scene) + static_cast<std::uint64_t>(pass.threads) * thread_bytes;
}

using LightViews = std::vector<std::optional<Projection>>;

// Another sequence than the frames' keys, so that masks of the eye and of lights have nothing in
// common.
std::uint32_t light_key(std::uint32_t frame_key, std::size_t light)
{
    const CounterRandom keys{~static_cast<std::uint64_t>(frame_key)};
    return static_cast<std::uint32_t>(keys.bits(light) >> 32);
}

LightShadows draw_maps(const ShadowPass& pass, const LightViews& views)
{
    const FrameSurfaces casters = make_casters(pass.surfaces);
    LightShadows shadows(views.size());
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!views[i]) continue;
        FrameOfPicture frame = pass.frame;
        frame.key = light_key(frame.key, i);
        shadows[i].map = draw_map(pass, casters, *views[i], light_key(pass.key, i), frame);
    }
    return shadows;
}

LightShadows make_rays(const ShadowPass& pass, const LightViews& views)
{
    const Scene& scene = pass.scene;
    const bool turns = std::any_of(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& mesh) {
        return mesh.topology != Topology::triangles;
    });
    LightShadows shadows(views.size());
    std::shared_ptr<const Casters> casters;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!views[i]) continue;
        // Lines and points face each light.
        if (!casters || turns) {
            casters = std::make_shared<Casters>(scene, pass.surfaces, *views[i], pass.shadows.size);
        }
        const Light& light = i == 0 ? Light{} : scene.lights[i - 1];
        const bool directional = i == 0 || light.kind == LightKind::directional;
        const Vec3d to_light =
            i == 0 ? to_vec3d(scene.sun.to_light) : -1.0 * to_vec3d(light.direction);
        shadows[i].rays = std::make_shared<LightRays>(LightRays{
            casters, pass.seen.eye, directional, normalized(to_light), to_vec3d(light.position)});
    }
    return shadows;
}

}  // namespace

FrameShadows prepare_shadows(const ShadowPass& pass, const Options& options)
{
    FrameShadows result;
    if (pass.shadows.kind == ShadowKind::none) return result;
    if (options.memory_limit != 0) require_memory(options.memory_limit, shadow_bytes(pass));
    Stopwatch time;
    time.start();
    const LightViews views = light_views(pass.scene, pass.shadows, pass.seen, pass.surfaces);
    result.shadows =
        pass.shadows.kind == ShadowKind::exact ? make_rays(pass, views) : draw_maps(pass, views);
    time.stop();
    result.passes.push_back({"shadow", time.ms()});
    if (options.memory_limit != 0) release_free_memory();
    return result;
}

}  // namespace sheer
