// Edge functions in 64 bits (docs/numerics.md, "Coverage").
#include "raster/coverage_wide.h"

namespace sheer {

namespace {

struct Edge {
    std::int64_t dx, dy, x, y, bias;

    std::int64_t at(std::int64_t px, std::int64_t py) const
    {
        return dx * (py - y) - dy * (px - x) + bias;
    }
};

std::uint64_t samples_inside(const Edge (&edges)[3], const SampleSet& set, int x, int y)
{
    std::uint64_t bits = 0;
    for (std::size_t s = 0; s < static_cast<std::size_t>(set.count); ++s) {
        const std::int64_t px = std::int64_t{x} * kSubpixels + set.x[s];
        const std::int64_t py = std::int64_t{y} * kSubpixels + set.y[s];
        const bool inside =
            edges[0].at(px, py) >= 0 && edges[1].at(px, py) >= 0 && edges[2].at(px, py) >= 0;
        bits |= static_cast<std::uint64_t>(inside) << s;
    }
    return bits;
}

// All of the pixel's square inside: no sample needs a test.
bool pixel_inside(const Edge (&edges)[3], int x, int y)
{
    const std::int64_t left = std::int64_t{x} * kSubpixels, top = std::int64_t{y} * kSubpixels;
    for (const Edge& e : edges) {
        const std::int64_t px = e.dy > 0 ? left + kSubpixels : left;
        const std::int64_t py = e.dx < 0 ? top + kSubpixels : top;
        if (e.at(px, py) < 0) return false;
    }
    return true;
}

}  // namespace

void cover_wide(const Triangle& triangle, const SampleSet& set, const PixelRect& region, int tile_x,
                int tile_y, CoverageList& list)
{
    Edge edges[3];
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const std::int64_t dx = triangle.x[j] - triangle.x[i], dy = triangle.y[j] - triangle.y[i];
        const bool top_or_left = dy < 0 || (dy == 0 && dx > 0);
        edges[i] = {dx, dy, triangle.x[i], triangle.y[i], top_or_left ? 0 : -1};
    }
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x) {
            const std::uint64_t bits =
                pixel_inside(edges, x, y) ? set.all() : samples_inside(edges, set, x, y);
            if (bits == 0) continue;
            list.pixel[list.count] =
                static_cast<std::uint32_t>((y - tile_y) * kTileSize + x - tile_x);
            list.low[list.count] = static_cast<std::uint32_t>(bits);
            if (set.count > 32) list.high[list.count] = static_cast<std::uint32_t>(bits >> 32);
            ++list.count;
        }
    }
}

}  // namespace sheer
