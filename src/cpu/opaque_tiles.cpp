// Opaque surfaces alone, shaded.
#include "cpu/opaque_tiles.h"

#include <memory>

#include "support/parallel.h"

namespace sheer {

namespace {

struct OpaqueWorker {
    TileScratch scratch;
    OpaqueTile opaque;
    FragmentStream stream;

    explicit OpaqueWorker(const FrameJob& job)
        : opaque(job.samples.count, job.surfaces.any_opaque),
          stream(kStreamFragments, job.surfaces.any_colored)
    {
    }
};

}  // namespace

void for_each_opaque_tile(const FrameJob& job, int threads, const OpaqueVisit& visit)
{
    std::vector<std::unique_ptr<OpaqueWorker>> workers(static_cast<std::size_t>(threads));
    const FragmentConsumer nobody{[](void*, const FragmentStream&) { return true; }, nullptr};
    parallel_for(threads, static_cast<std::size_t>(job.grid.count()), [&](std::size_t tile, int t) {
        auto& worker = workers[static_cast<std::size_t>(t)];
        if (!worker) worker = std::make_unique<OpaqueWorker>(job);
        const PixelRect rect = job.grid.rect(static_cast<int>(tile));
        TileJob drawn{&job.geometry,          &job.surfaces, &job.samples,
                      static_cast<int>(tile), rect,          rect};
        drawn.part = TilePart::opaque;
        drawn.shading = job.shading;
        job.tile_fragments(drawn, worker->scratch, worker->opaque, worker->stream, nobody);
        visit(rect, job.grid.interior(static_cast<int>(tile)), worker->opaque);
    });
}

std::size_t opaque_thread_bytes(const FrameJob& job)
{
    const auto samples = static_cast<std::size_t>(job.samples.count);
    return kTilePixels * (samples * 6 + 1) * sizeof(float) +
           kStreamFragments * (sizeof(FragmentRun) + 20 * sizeof(float));
}

}  // namespace sheer
