// Barycentric weights from edge functions: b1 = E2 / A2, b2 = E0 / A2 (docs/numerics.md).
#include "cpu/triangle_planes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace sheer {

namespace {

// |E| at the centre of a pixel that the triangle covers is at most A2 plus half a pixel's steps;
// both below 2^30 leaves it inside 32 bits.
constexpr std::int64_t kLargestExactArea = std::int64_t{1} << 30;
constexpr std::int64_t kLongestExactEdge = std::int64_t{1} << 22;

struct Edge {
    std::int64_t dx, dy;
    std::int64_t at_first_center;  // of the tile's first pixel
    bool exact() const { return std::abs(dx) + std::abs(dy) < kLongestExactEdge; }
};

Edge make_edge(const Triangle& t, int from, int to, const PixelRect& rect)
{
    const std::int64_t dx = t.x[to] - t.x[from], dy = t.y[to] - t.y[from];
    const std::int64_t x = rect.x0 * kSubpixels + kSubpixels / 2 - t.x[from];
    const std::int64_t y = rect.y0 * kSubpixels + kSubpixels / 2 - t.y[from];
    return {dx, dy, dx * y - dy * x};
}

void make_weight(const Edge& e, double inverse_area, WeightPlane& w)
{
    const double right = static_cast<double>(-e.dy) * inverse_area;
    const double down = static_cast<double>(e.dx) * inverse_area;
    w.edge = static_cast<std::int32_t>(e.at_first_center);
    w.edge_x = static_cast<std::int32_t>(-e.dy * kSubpixels);
    w.edge_y = static_cast<std::int32_t>(e.dx * kSubpixels);
    w.base = static_cast<float>(static_cast<double>(e.at_first_center) * inverse_area);
    w.pixel_x = static_cast<float>(right * kSubpixels);
    w.pixel_y = static_cast<float>(down * kSubpixels);
    w.dx = static_cast<float>(right);
    w.dy = static_cast<float>(down);
}

// In magnitude, of the terms that make the weight at the centre of a pixel that the triangle
// covers: within half a pixel of it the weight is in [0, 1].
double largest_weight(const WeightPlane& w, bool exact)
{
    const double step = static_cast<double>(std::abs(w.dx)) + static_cast<double>(std::abs(w.dy));
    if (exact) return 1 + step * kSubpixels / 2;
    return static_cast<double>(std::abs(w.base)) + step * kSubpixels * kTileSize;
}

}  // namespace

void make_triangle_planes(const Triangle& t, const PixelRect& rect, bool orthographic,
                          TrianglePlanes& p)
{
    const Edge e0 = make_edge(t, 0, 1, rect), e2 = make_edge(t, 2, 0, rect);
    // (x1 - x0) (y2 - y0) - (x2 - x0) (y1 - y0), the edge 2 running from vertex 2 to vertex 0.
    const std::int64_t area = e2.dx * e0.dy - e0.dx * e2.dy;
    const double inverse_area = 1.0 / static_cast<double>(area);

    p.exact = area < kLargestExactArea && e0.exact() && e2.exact();
    p.inverse_area = static_cast<float>(inverse_area);
    make_weight(e2, inverse_area, p.weight1);
    make_weight(e0, inverse_area, p.weight2);
    p.depth0 = t.depth[0];
    p.depth1 = t.depth[1] - t.depth[0];
    p.depth2 = t.depth[2] - t.depth[0];
    const double d0 = static_cast<double>(t.depth[0]);
    const double d1 = static_cast<double>(t.depth[1]) - d0;
    const double d2 = static_cast<double>(t.depth[2]) - d0;
    const double scale = inverse_area * kSubpixels;
    const double dx = -(static_cast<double>(e2.dy) * d1 + static_cast<double>(e0.dy) * d2) * scale;
    const double dy = (static_cast<double>(e2.dx) * d1 + static_cast<double>(e0.dx) * d2) * scale;
    const double at_first_center =
        static_cast<double>(t.depth[0]) + (static_cast<double>(e2.at_first_center) * d1 +
                                           static_cast<double>(e0.at_first_center) * d2) *
                                              inverse_area;
    const auto [least, most] = std::minmax({t.depth[0], t.depth[1], t.depth[2]});
    p.depth = {
        static_cast<float>(dx), static_cast<float>(dy), least, most, 0, at_first_center, dx, dy};
    p.depth.slack = depth_slack(p.depth, std::abs(d1) * largest_weight(p.weight1, p.exact) +
                                             std::abs(d2) * largest_weight(p.weight2, p.exact));
    p.affine = orthographic || least == most;
    for (int i = 0; i < 3; ++i) p.inverse_w[i] = -t.depth[i];
}

}  // namespace sheer
