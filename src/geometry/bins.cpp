// A counting sort of (tile, triangle) pairs by tile; triangles keep their order in each tile.
#include "geometry/bins.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include <sheer/error.h>

#include "geometry/screen_bounds.h"

namespace sheer {

namespace {

struct Pair {
    std::uint32_t tile, triangle;
};

// True when all of `rect` lies outside of one of the triangle's edges.
bool misses(const Triangle& t, const PixelRect& rect)
{
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

}  // namespace

void bin_triangles(TriangleChunk& chunk, const TileGrid& tiles, const SampleExtent& samples)
{
    const TileGrid grid = tiles;  // that nothing written here can change
    const int columns = grid.columns();
    std::vector<Pair> pairs;
    pairs.reserve(chunk.triangles.size() * 2);
    chunk.tile_begin.assign(static_cast<std::size_t>(grid.count()) + 1, 0);
    for (std::size_t i = 0; i < chunk.triangles.size(); ++i) {
        const Triangle& t = chunk.triangles[i];
        const PixelBounds b = pixel_bounds(t, samples);
        const int column0 = grid.first_column(std::max(b.x0, 0));
        const int column1 = grid.last_column(std::min(b.x1, grid.width - 1));
        const int row0 = grid.first_row(std::max(b.y0, 0));
        const int row1 = grid.last_row(std::min(b.y1, grid.height - 1));
        const bool large = column1 > column0 + 1 || row1 > row0 + 1;
        for (int row = row0; row <= row1; ++row) {
            for (int column = column0; column <= column1; ++column) {
                const int tile = row * columns + column;
                if (large && misses(t, grid.rect(tile))) continue;
                pairs.push_back({static_cast<std::uint32_t>(tile), static_cast<std::uint32_t>(i)});
                ++chunk.tile_begin[static_cast<std::size_t>(tile) + 1];
            }
        }
    }
    if (pairs.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw Error(Fault::input,
                    "the scene's triangles cover too many tiles of so large a picture");
    }
    std::partial_sum(chunk.tile_begin.begin(), chunk.tile_begin.end(), chunk.tile_begin.begin());
    chunk.tile_triangles.resize(pairs.size());
    std::vector<std::uint32_t> next(chunk.tile_begin.begin(), chunk.tile_begin.end() - 1);
    for (const Pair& p : pairs) chunk.tile_triangles[next[p.tile]++] = p.triangle;
}

}  // namespace sheer
