// How a picture is cut into tiles.
//
// A tile is rasterised at once, by one thread. Where the filter reaches into neighbouring pixels a
// tile has an apron of them, which it rasterises too, so that tiles never wait for one another.
#pragma once

#include <algorithm>

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
    // Of the tiles whose rect holds pixel column x, the first and the last.
    int first_column(int x) const { return steps_in(std::max(x - apron, 0)); }
    int last_column(int x) const { return std::min(steps_in(x + apron), columns() - 1); }
    int first_row(int y) const { return steps_in(std::max(y - apron, 0)); }
    int last_row(int y) const { return std::min(steps_in(y + apron), rows() - 1); }

private:
    // x / step(), of x below 2^18, where the half keeps rounding from every whole number: a
    // division of integers takes most of the time of sorting triangles into tiles.
    int steps_in(int x) const
    {
        return static_cast<int>((static_cast<float>(x) + 0.5f) *
                                (1.0f / static_cast<float>(step())));
    }
};

}  // namespace sheer
