// How a picture is cut into tiles.
//
// A tile is rasterised at once, by one thread. Where the filter reaches into neighbouring pixels a
// tile has an apron of them, which it rasterises too, so that tiles never wait for one another.
#pragma once

#include <algorithm>
#include <cstdint>

namespace sheer {

inline constexpr int kTileSize = 32;  // pixels across, apron included
inline constexpr int kTilePixels = kTileSize * kTileSize;

// Pixels [x0, x1) x [y0, y1) of the picture.
struct PixelRect {
    int x0, y0, x1, y1;
};

struct TileGrid {
    int width, height;  // of the picture
    int apron;          // pixels

    int step() const { return kTileSize - 2 * apron; }
    int columns() const { return (width + step() - 1) / step(); }
    int rows() const { return (height + step() - 1) / step(); }
    int count() const { return columns() * rows(); }

    // The pixels that a tile writes.
    PixelRect interior(int tile) const
    {
        const int x = tile % columns() * step(), y = tile / columns() * step();
        return {x, y, std::min(x + step(), width), std::min(y + step(), height)};
    }
    // The pixels that it rasterises.
    PixelRect rect(int tile) const
    {
        const PixelRect r = interior(tile);
        return {std::max(r.x0 - apron, 0), std::max(r.y0 - apron, 0), std::min(r.x1 + apron, width),
                std::min(r.y1 + apron, height)};
    }
};

// Which tiles' rects hold a pixel column or row.
class TileLookup {
public:
    explicit TileLookup(const TileGrid& grid)
        : apron_(grid.apron),
          last_column_(grid.columns() - 1),
          last_row_(grid.rows() - 1),
          reciprocal_((std::uint64_t{1} << 32) / static_cast<std::uint64_t>(grid.step()) + 1)
    {
    }
    int first_column(int x) const { return steps_in(std::max(x - apron_, 0)); }
    int last_column(int x) const { return std::min(steps_in(x + apron_), last_column_); }
    int first_row(int y) const { return steps_in(std::max(y - apron_, 0)); }
    int last_row(int y) const { return std::min(steps_in(y + apron_), last_row_); }

private:
    // x / step, of x below 2^18: the reciprocal is too large by less than 1, the product by less
    // than 2^-14, which is less than 1 / step. A division takes most of the time of sorting
    // triangles into tiles.
    int steps_in(int x) const
    {
        return static_cast<int>((static_cast<std::uint64_t>(x) * reciprocal_) >> 32);
    }

    int apron_, last_column_, last_row_;
    std::uint64_t reciprocal_;  // 2^32 / step, rounded up
};

}  // namespace sheer
