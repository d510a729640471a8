// Tiles that a large triangle's bounds touch and itself does not; the sort.
#include "geometry/bins.h"

#include <limits>
#include <numeric>

#include <sheer/error.h>

namespace sheer {

TriangleBins::TriangleBins(const TileGrid& grid, std::size_t triangles)
    : grid_(grid),
      lookup_(grid),
      columns_(grid.columns()),
      counts_(static_cast<std::size_t>(grid.count()))
{
    pairs_.reserve(triangles * 2);
}

bool TriangleBins::misses(const Triangle& t, int tile) const
{
    const PixelRect rect = grid_.rect(tile);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const std::int64_t dx = t.x[j] - t.x[i], dy = t.y[j] - t.y[i];
        // The corner of the rectangle that is furthest inside.
        const std::int64_t x = std::int64_t{dy > 0 ? rect.x0 : rect.x1} * kSubpixels - t.x[i];
        const std::int64_t y = std::int64_t{dx > 0 ? rect.y1 : rect.y0} * kSubpixels - t.y[i];
        if (dx * y - dy * x < 0) return true;
    }
    return false;
}

void TriangleBins::write(TriangleChunk& chunk) const
{
    if (pairs_.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw Error(Fault::input,
                    "the scene's triangles cover too many tiles of so large a picture");
    }
    chunk.tile_begin.assign(counts_.size() + 1, 0);
    std::partial_sum(counts_.begin(), counts_.end(), chunk.tile_begin.begin() + 1);
    chunk.tile_triangles.resize(pairs_.size());
    std::vector<std::uint32_t> next(chunk.tile_begin.begin(), chunk.tile_begin.end() - 1);
    for (const Pair& p : pairs_) chunk.tile_triangles[next[p.tile]++] = p.triangle;
}

}  // namespace sheer
