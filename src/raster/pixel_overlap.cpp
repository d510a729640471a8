// A triangle is cut at the four sides of a pixel: I. Sutherland and G. Hodgman, Reentrant Polygon
// Clipping (CACM 17(1), 1974).
#include "raster/pixel_overlap.h"

#include <algorithm>
#include <array>

namespace sheer {

namespace {

using Point = std::array<double, 2>;

// Each of the four cuts adds a corner at most.
struct Polygon {
    std::array<Point, 7> corners;
    std::size_t count = 0;

    void add(const Point& p) { corners[count++] = p; }
};

// What is left where coordinate c is no less (sign 1) or no more (sign -1) than `limit`.
Polygon cut(const Polygon& polygon, std::size_t c, double sign, double limit)
{
    Polygon result;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Point& from = polygon.corners[i];
        const Point& to = polygon.corners[i + 1 == polygon.count ? 0 : i + 1];
        const bool from_inside = sign * (from[c] - limit) >= 0;
        const bool to_inside = sign * (to[c] - limit) >= 0;
        if (from_inside) result.add(from);
        if (from_inside == to_inside) continue;
        const double t = (limit - from[c]) / (to[c] - from[c]);
        Point crossing = {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])};
        crossing[c] = limit;
        result.add(crossing);
    }
    return result;
}

// As a fan around its first corner.
PixelOverlap measure(const Polygon& polygon)
{
    double twice = 0, x = 0, y = 0;
    const Point& o = polygon.corners[0];
    for (std::size_t i = 2; i < polygon.count; ++i) {
        const Point &a = polygon.corners[i - 1], &b = polygon.corners[i];
        const double area = (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
        twice += area;
        x += area * (o[0] + a[0] + b[0]);
        y += area * (o[1] + a[1] + b[1]);
    }
    const double part = twice / (2.0 * kSubpixels * kSubpixels);
    if (!(part >= kLeastOverlap)) return {0, 0, 0};
    const double half = 0.5 * kSubpixels;
    return {std::min(part, 1.0), x / (3 * twice) - half, y / (3 * twice) - half};
}

}  // namespace

PixelOverlap overlap_of(const Triangle& triangle, int x, int y)
{
    Polygon polygon;
    for (std::size_t i = 0; i < 3; ++i) {
        polygon.add({static_cast<double>(triangle.x[i]) - static_cast<double>(x) * kSubpixels,
                     static_cast<double>(triangle.y[i]) - static_cast<double>(y) * kSubpixels});
    }
    for (std::size_t c = 0; c < 2; ++c) {
        polygon = cut(polygon, c, 1, 0);
        polygon = cut(polygon, c, -1, kSubpixels);
        if (polygon.count < 3) return {0, 0, 0};
    }
    return measure(polygon);
}

void cover_touched(const Triangle& triangle, const ConservativeCover& cover, CoverageList& list)
{
    const std::uint64_t all = cover.set.all();
    const PixelRect& region = cover.region;
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x) {
            const PixelOverlap overlap = overlap_of(triangle, x, y);
            if (!(overlap.part > 0)) continue;
            const int i = list.count++;
            const auto at = static_cast<std::size_t>(i);
            list.pixel[i] =
                static_cast<std::uint32_t>((y - cover.tile_y) * kTileSize + x - cover.tile_x);
            list.low[i] = static_cast<std::uint32_t>(all);
            if (cover.set.count > 32) list.high[i] = static_cast<std::uint32_t>(all >> 32);
            list.overlaps->part[at] = cover.counts ? static_cast<float>(overlap.part) : 1.0f;
            list.overlaps->x[at] = static_cast<float>(overlap.x);
            list.overlaps->y[at] = static_cast<float>(overlap.y);
        }
    }
}

}  // namespace sheer
