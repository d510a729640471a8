// Which tiles a chunk's triangles touch: a counting sort of (tile, triangle) pairs by tile.
// Triangles keep their order in each tile.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/screen_bounds.h"
#include "geometry/tile_grid.h"
#include "geometry/triangles.h"

namespace sheer {

class TriangleBins {
public:
    // For about so many triangles.
    TriangleBins(const TileGrid& grid, std::size_t triangles);

    // Triangle number `index`, whose bounds meet the picture.
    void add(const Triangle& t, const PixelBounds& bounds, std::uint32_t index)
    {
        const int column0 = lookup_.first_column(std::max(bounds.x0, 0));
        const int column1 = lookup_.last_column(std::min(bounds.x1, grid_.width - 1));
        const int row0 = lookup_.first_row(std::max(bounds.y0, 0));
        const int row1 = lookup_.last_row(std::min(bounds.y1, grid_.height - 1));
        const bool large = column1 > column0 + 1 || row1 > row0 + 1;
        for (int row = row0; row <= row1; ++row) {
            for (int column = column0; column <= column1; ++column) {
                const int tile = row * columns_ + column;
                if (large && misses(t, tile)) continue;
                pairs_.push_back({static_cast<std::uint32_t>(tile), index});
                ++counts_[static_cast<std::size_t>(tile)];
            }
        }
    }

    // Fills in tile_begin and tile_triangles.
    // Throws Error(Fault::input) where they are more than 32 bits count.
    void write(TriangleChunk& chunk) const;

private:
    struct Pair {
        std::uint32_t tile, triangle;
    };

    // True when all of the tile lies outside of one of the triangle's edges.
    bool misses(const Triangle& t, int tile) const;

    const TileGrid grid_;
    const TileLookup lookup_;
    const int columns_;
    std::vector<Pair> pairs_;
    std::vector<std::uint32_t> counts_;  // of each tile
};

}  // namespace sheer
