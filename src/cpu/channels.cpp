// Counting.
#include "cpu/channels.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace sheer {

void ChannelTile::clear()
{
    std::fill(pixels_.begin(), pixels_.end(),
              Pixel{0, 0, 0, std::numeric_limits<float>::infinity()});
}

void ChannelTile::add(const FragmentStream& stream)
{
    for (std::size_t r = 0; r < static_cast<std::size_t>(stream.run_count); ++r) {
        const FragmentRun& run = stream.runs[r];
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            Pixel& pixel = pixels_[stream.pixel[i]];
            const std::uint64_t samples = stream.sample_bits(i);
            ++pixel.fragments;
            pixel.layers += static_cast<std::uint32_t>(std::popcount(samples));
            pixel.covered |= samples;
            const float depth = std::clamp(stream.depth[i], run.depth.least, run.depth.most);
            pixel.depth = std::min(pixel.depth, depth);
        }
    }
}

void ChannelTile::write(const PixelRect& rect, const PixelRect& interior, const ChannelShape& shape,
                        Channels& channels) const
{
    const auto samples = static_cast<float>(shape.samples);
    for (int y = interior.y0; y < interior.y1; ++y) {
        for (int x = interior.x0; x < interior.x1; ++x) {
            const Pixel& pixel =
                pixels_[static_cast<std::size_t>((y - rect.y0) * kTileSize + x - rect.x0)];
            const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(shape.width) +
                            static_cast<std::size_t>(x);
            channels.fragments[at] = static_cast<float>(pixel.fragments);
            channels.depth_complexity[at] = static_cast<float>(pixel.layers) / samples;
            channels.coverage[at] = static_cast<float>(std::popcount(pixel.covered)) / samples;
            const bool is_distance = pixel.fragments == 0 || shape.eye.orthographic;
            channels.depth[at] = is_distance ? pixel.depth : -1.0f / pixel.depth;
        }
    }
}

}  // namespace sheer
