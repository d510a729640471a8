// How often each sample of a picture is covered, as the renderer itself counts it.
#pragma once

#include <vector>

#include "cpu/tile_fragments.h"
#include "geometry/bins.h"

namespace sheer {

// Takes every object for a transparent, unlit one.
class CoverageCounter {
public:
    CoverageCounter(int width, int height, int samples, SamplePositions positions,
                    std::size_t objects = 1)
        : grid_{width, height, 0},
          set_(make_sample_set(samples, positions)),
          counts_(static_cast<std::size_t>(width * height * samples))
    {
        Surface surface{{1, 1, 1}, 0.5f, 0.5f, AlphaMode::blend, Shading::unlit, false, 0};
        surface.transparent = true;
        surfaces_.surfaces.resize(objects, surface);
    }

    // Counts of sample s of pixel (x, y) at (y width + x) samples + s.
    const std::vector<std::uint8_t>& count(Geometry& geometry, TargetSet targets)
    {
        if (geometry.attributes.empty()) geometry.attributes.resize(1);
        for (TriangleChunk& chunk : geometry.chunks) {
            TriangleBins bins(grid_, chunk.triangles.size());
            std::uint32_t index = 0;
            for (const Triangle& t : chunk.triangles) {
                bins.add(t, pixel_bounds(t, set_.extent), index++);
            }
            bins.write(chunk);
        }
        std::fill(counts_.begin(), counts_.end(), std::uint8_t{0});
        OpaqueTile opaque(set_.count, false);
        FragmentStream stream(2048);
        for (tile_ = 0; tile_ < grid_.count(); ++tile_) {
            const PixelRect rect = grid_.rect(tile_);
            const TileJob job{&geometry, &surfaces_, &set_, tile_, rect, rect};
            tile_fragments_for(targets)(job, scratch_, opaque, stream, {take, this});
            take(this, stream);
        }
        return counts_;
    }

    const SampleSet& samples() const { return set_; }
    const TileGrid& grid() const { return grid_; }

    // The position of the sample that an element of the counts stands for, in subpixels.
    SamplePoint position(std::size_t element) const
    {
        const auto s = element % static_cast<std::size_t>(set_.count);
        const auto pixel = static_cast<int>(element / static_cast<std::size_t>(set_.count));
        return {pixel % grid_.width * kSubpixels + set_.x[s],
                pixel / grid_.width * kSubpixels + set_.y[s]};
    }

private:
    static bool take(void* context, const FragmentStream& stream)
    {
        auto& self = *static_cast<CoverageCounter*>(context);
        const PixelRect rect = self.grid_.rect(self.tile_);
        for (int i = 0; i < stream.size; ++i) {
            const int x = rect.x0 + static_cast<int>(stream.pixel[i]) % kTileSize;
            const int y = rect.y0 + static_cast<int>(stream.pixel[i]) / kTileSize;
            for (int s = 0; s < self.set_.count; ++s) {
                const auto at =
                    static_cast<std::size_t>((y * self.grid_.width + x) * self.set_.count + s);
                self.counts_[at] = static_cast<std::uint8_t>(
                    self.counts_[at] + (stream.sample_bits(static_cast<std::size_t>(i)) >> s & 1));
            }
        }
        return true;
    }

    TileGrid grid_;
    SampleSet set_;
    FrameSurfaces surfaces_;
    TileScratch scratch_;
    int tile_ = 0;
    std::vector<std::uint8_t> counts_;
};

inline Triangle screen_triangle(const SamplePoint& a, const SamplePoint& b, const SamplePoint& c)
{
    Triangle t{};
    const SamplePoint corners[3] = {a, b, c};
    for (int i = 0; i < 3; ++i) {
        t.x[i] = corners[i].x;
        t.y[i] = corners[i].y;
        t.depth[i] = -1;
    }
    return t;
}

}  // namespace sheer
