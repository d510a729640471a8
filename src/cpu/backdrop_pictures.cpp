// Means over samples, then the coarser levels.
#include "cpu/backdrop_pictures.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "cpu/memory_plan.h"
#include "cpu/opaque_tiles.h"
#include "cpu/stopwatch.h"
#include "support/memory.h"

namespace sheer {

namespace {

// Nearer than any opaque surface of a scene in metres, where a camera without perspective is in the
// middle of one.
constexpr float kLeastDistance = 1e-6f;

struct PixelMean {
    Float4 color;
    float nearness;
};

PixelMean mean_of_pixel(const FrameJob& job, const OpaqueTile& opaque, std::size_t pixel)
{
    PixelMean sum = {{0, 0, 0, 0}, 0};
    const auto samples = static_cast<std::size_t>(job.samples.count);
    for (std::size_t s = 0; s < samples; ++s) {
        const std::size_t at = pixel * samples + s;
        const float depth = opaque.depth[at];
        Float4 color = job.background;
        if (depth != std::numeric_limits<float>::infinity()) {
            color = {opaque.red[at], opaque.green[at], opaque.blue[at], 1};
            sum.nearness += job.eye.orthographic ? 1.0f / std::max(depth, kLeastDistance) : -depth;
        }
        for (std::size_t c = 0; c < 4; ++c) sum.color[c] += color[c];
    }
    const float part = 1.0f / static_cast<float>(samples);
    for (float& c : sum.color) c *= part;
    return {sum.color, sum.nearness * part};
}

void write_tile(const FrameJob& job, const PixelRect& rect, const PixelRect& interior,
                const OpaqueTile& opaque, BackdropPicture& picture)
{
    for (int y = interior.y0; y < interior.y1; ++y) {
        for (int x = interior.x0; x < interior.x1; ++x) {
            const auto pixel = static_cast<std::size_t>((y - rect.y0) * kTileSize + x - rect.x0);
            const PixelMean mean =
                opaque.any ? mean_of_pixel(job, opaque, pixel) : PixelMean{job.background, 0};
            picture.color(x, y) = mean.color;
            picture.nearness(x, y) = mean.nearness;
        }
    }
}

}  // namespace

std::optional<DrawnBackdrop> draw_backdrop_picture(const FrameJob& job,
                                                   const Projection& projection, int threads,
                                                   const Options& options)
{
    if (std::none_of(job.takes.begin(), job.takes.end(),
                     [](const Take& take) { return take.method.traits().reads_backdrop; })) {
        return std::nullopt;
    }
    const int width = job.grid.width, height = job.grid.height;
    if (options.memory_limit != 0) {
        require_memory(options.memory_limit,
                       BackdropPicture::bytes(width, height) +
                           static_cast<std::uint64_t>(threads) * opaque_thread_bytes(job));
    }
    Stopwatch time;
    time.start();
    // Normalised coordinates go from -1 to 1.
    BackdropPicture picture(width, height,
                            {static_cast<float>(projection.scale_x * width / 2),
                             static_cast<float>(projection.scale_y * height / 2)});
    for_each_opaque_tile(
        job, threads,
        [&](const PixelRect& rect, const PixelRect& interior, const OpaqueTile& opaque) {
            write_tile(job, rect, interior, opaque, picture);
        });
    picture.make_levels();
    time.stop();
    if (options.memory_limit != 0) release_free_memory();
    return DrawnBackdrop{std::move(picture), time.ms()};
}

}  // namespace sheer
