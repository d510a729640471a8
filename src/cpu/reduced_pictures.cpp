// Geometry once more, for fewer pixels; then tile by tile fragments into sums.
#include "cpu/reduced_pictures.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "cpu/frame_memory.h"
#include "cpu/opaque_tiles.h"
#include "cpu/stopwatch.h"
#include "cpu/tile_passes.h"
#include "geometry/build.h"
#include "support/memory.h"
#include "support/parallel.h"

namespace sheer {

namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

// What one thread works with, tile after tile.
struct ReducedWorker {
    TileScratch scratch;
    OpaqueTile opaque;
    FragmentStream stream;
    std::shared_ptr<void> tile;
    std::vector<float> farthest;  // of a tile's pixels

    explicit ReducedWorker(const FrameJob& job)
        : opaque(job.samples.count, false),
          stream(kStreamFragments, job.surfaces.any_colored),
          farthest(kTilePixels, kNothing)
    {
    }
};

using ReducedWorkers = std::vector<std::unique_ptr<ReducedWorker>>;

// Of each of the whole picture's pixels the farthest of what is opaque there; infinite where one of
// its samples shows none.
std::vector<float> farthest_opaque(const FrameJob& job, int threads)
{
    if (!job.surfaces.any_opaque) return {};
    const auto width = static_cast<std::size_t>(job.grid.width);
    std::vector<float> depths(width * static_cast<std::size_t>(job.grid.height), kNothing);
    for_each_opaque_tile(
        job, threads,
        [&](const PixelRect& rect, const PixelRect& interior, const OpaqueTile& opaque) {
            if (!opaque.any) return;
            const auto samples = static_cast<std::size_t>(job.samples.count);
            for (int y = interior.y0; y < interior.y1; ++y) {
                for (int x = interior.x0; x < interior.x1; ++x) {
                    const auto pixel =
                        static_cast<std::size_t>((y - rect.y0) * kTileSize + x - rect.x0);
                    const float* of_pixel = opaque.depth.data() + pixel * samples;
                    depths[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] =
                        *std::max_element(of_pixel, of_pixel + samples);
                }
            }
        });
    return depths;
}

// Of what a row or column of texels shows of `pixels`: those of texel i are [first(i), end(i)).
struct TexelPixels {
    int pixels, texels;

    int first(int i) const { return static_cast<int>(std::int64_t{i} * pixels / texels); }
    int end(int i) const
    {
        return static_cast<int>((std::int64_t{i + 1} * pixels + texels - 1) / texels);
    }
};

// Into a tile's texels the farthest of their pixels.
void find_farthest(const std::vector<float>& depths, const ReducedMoments& to,
                   const PixelRect& rect, std::vector<float>& farthest)
{
    if (depths.empty()) return;
    const TexelPixels columns{to.picture_width, to.width}, rows{to.picture_height, to.height};
    for (int y = rect.y0; y < rect.y1; ++y) {
        for (int x = rect.x0; x < rect.x1; ++x) {
            float most = -kNothing;
            for (int row = rows.first(y); row < rows.end(y); ++row) {
                const float* at = depths.data() + static_cast<std::size_t>(row) *
                                                      static_cast<std::size_t>(to.picture_width);
                most =
                    std::max(most, *std::max_element(at + columns.first(x), at + columns.end(x)));
            }
            farthest[static_cast<std::size_t>((y - rect.y0) * kTileSize + x - rect.x0)] = most;
        }
    }
}

struct ReducedJob {
    const FrameJob& whole;
    const ChosenMethod& method;
    const ReducedVerbs& verbs;
    const Geometry& geometry;
    const std::vector<float>& farthest;
    TileGrid grid;
};

void draw_tile(const ReducedJob& job, int number, ReducedWorker& worker, ReducedMoments& to)
{
    const PixelRect rect = job.grid.rect(number);
    TileJob drawn{&job.geometry, &job.whole.surfaces, &job.whole.samples, number, rect, rect};
    drawn.part = TilePart::transparent;
    find_farthest(job.farthest, to, rect, worker.farthest);
    job.verbs.clear(worker.tile.get());
    const int passes = job.method.traits().reduced_passes;
    for (int pass = 0; pass < passes; ++pass) {
        const auto insert = [&](const FragmentStream& stream) {
            if (stream.size == 0) return;
            job.verbs.insert(worker.tile.get(), stream, worker.farthest.data(), pass);
        };
        const FragmentConsumer consumer{[](void* context, const FragmentStream& stream) {
                                            (*static_cast<decltype(insert)*>(context))(stream);
                                            return true;
                                        },
                                        const_cast<void*>(static_cast<const void*>(&insert))};
        job.whole.tile_fragments(drawn, worker.scratch, worker.opaque, worker.stream, consumer);
        insert(worker.stream);
    }
    job.verbs.write(worker.tile.get(), rect, to);
}

void draw_moments(const ReducedJob& job, int threads, ReducedMoments& to)
{
    const StoreShape shape{.samples = &job.whole.samples,
                           .method = &job.method,
                           .eye = job.whole.eye,
                           .stream_capacity = kStreamFragments};
    ReducedWorkers workers(static_cast<std::size_t>(threads));
    parallel_for(threads, static_cast<std::size_t>(job.grid.count()), [&](std::size_t tile, int t) {
        auto& worker = workers[static_cast<std::size_t>(t)];
        if (!worker) {
            worker = std::make_unique<ReducedWorker>(job.whole);
            worker->tile = job.verbs.make(shape);
        }
        draw_tile(job, static_cast<int>(tile), *worker, to);
    });
}

// At most: what the pictures take, and what it takes to make one of them.
std::uint64_t reduced_bytes(const FrameJob& job, const Scene& scene, int threads)
{
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(job.grid.width) * static_cast<std::uint64_t>(job.grid.height);
    std::uint64_t bytes = geometry_bytes(scene), tile_bytes = 0;
    if (job.surfaces.any_opaque) bytes += pixels * sizeof(float);
    for (const Take& take : job.takes) {
        const MethodTraits traits = take.method.traits();
        if (traits.reduction == 1) continue;
        const ReducedMoments size(job.grid.width, job.grid.height, traits.reduction, 0);
        const auto numbers = static_cast<std::uint64_t>(traits.reduced_numbers);
        bytes += static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
                 numbers * sizeof(double);
        tile_bytes = std::max(tile_bytes, kTilePixels * (8 + 20 * numbers));
    }
    const std::uint64_t thread_bytes = tile_bytes + opaque_thread_bytes(job);
    return bytes + static_cast<std::uint64_t>(threads) * thread_bytes;
}

}  // namespace

std::vector<std::optional<ReducedPicture>> draw_reduced_pictures(const FrameJob& job,
                                                                 const Scene& scene,
                                                                 const Projection& projection,
                                                                 TargetSet targets, int threads,
                                                                 const Options& options)
{
    std::vector<std::optional<ReducedPicture>> pictures(job.takes.size());
    const auto is_reduced = [](const Take& take) { return take.method.traits().reduction > 1; };
    if (std::none_of(job.takes.begin(), job.takes.end(), is_reduced)) return pictures;
    if (options.memory_limit != 0) {
        require_memory(options.memory_limit, reduced_bytes(job, scene, threads));
    }
    Stopwatch before;
    before.start();
    const std::vector<float> farthest = farthest_opaque(job, threads);
    before.stop();
    for (std::size_t i = 0; i < job.takes.size(); ++i) {
        const ChosenMethod& method = job.takes[i].method;
        if (!is_reduced(job.takes[i])) continue;
        const MethodTraits traits = method.traits();
        Stopwatch time;
        time.start();
        ReducedMoments moments(job.grid.width, job.grid.height, traits.reduction,
                               traits.reduced_numbers);
        const TileGrid grid{moments.width, moments.height, 0};
        const Geometry geometry = build_geometry(
            {scene, projection, grid, job.samples.extent, threads, {}, job.grid.height});
        const ReducedVerbs verbs = method.row->reduced_verbs(targets, method);
        draw_moments({job, method, verbs, geometry, farthest, grid}, threads, moments);
        time.stop();
        pictures[i] = ReducedPicture{std::move(moments), before.ms() + time.ms()};
    }
    if (options.memory_limit != 0) release_free_memory();
    return pictures;
}

}  // namespace sheer
