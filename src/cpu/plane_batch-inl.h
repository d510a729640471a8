// Weights and depth of up to a vector of triangles as functions of the pixel, relative to a tile:
// barycentric weights from edge functions, b1 = E2 / A2, b2 = E0 / A2 (docs/numerics.md).
//
// Plain loops over the triangles, which compilers turn into vectors: in doubles, whose operations
// here round to the same bits in whatever vectors they are done. Sums of products of coordinates
// stay below 2^53, so that doubles hold them exactly.
#if defined(SHEER_PLANE_BATCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_PLANE_BATCH_INL_H
#undef SHEER_PLANE_BATCH_INL_H
#else
#define SHEER_PLANE_BATCH_INL_H
#endif

#include <algorithm>
#include <cmath>

#include "raster/depth_plane.h"
#include "raster/edge_batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

using DoubleEach = double[Block::kCount];

// The barycentric weights of one vertex. At the centre of the tile's pixel (column, row) they are
// (edge + edge_x column + edge_y row) / area in wrapping 32-bit integers where PlaneBatch::exact,
// else base + pixel_x column + pixel_y row.
struct WeightBatch {
    alignas(64) WholeEach edge, edge_x, edge_y;
    alignas(64) RealEach base, pixel_x, pixel_y;
    alignas(64) RealEach dx, dy;  // a subpixel to the right and down
};

struct PlaneBatch {
    alignas(64) WeightBatch weight1, weight2;
    alignas(64) RealEach inverse_area;
    alignas(64) DoubleEach precise_inverse_area;
    // At vertex 0, and what vertices 1 and 2 add.
    alignas(64) RealEach depth[3] = {};
    alignas(64) RealEach inverse_w[3];
    // Not zero: integers serve, which lose nothing. Slivers need that: their weights are small
    // differences of large terms. Triangles so large that their edge functions leave 32 bits don't.
    alignas(64) WholeEach exact;
    alignas(64) WholeEach affine;  // not zero: the three w are equal, no perspective
    bool all_exact, all_affine, any_affine;
    float spacing = 1;  // of what is shaded, in pixels
    // DepthPlane's numbers.
    alignas(64) RealEach least, most, slack;
    alignas(64) DoubleEach depth_at, depth_dx, depth_dy;

    DepthPlane depth_plane(std::size_t k) const
    {
        return {static_cast<float>(depth_dx[k]),
                static_cast<float>(depth_dy[k]),
                least[k],
                most[k],
                slack[k],
                depth_at[k],
                depth_dx[k],
                depth_dy[k]};
    }
};

// One edge of each triangle.
struct EdgeVectors {
    alignas(64) WholeEach dx, dy;
    alignas(64) WholeEach x, y;              // from its first vertex to the first pixel's centre
    alignas(64) DoubleEach at_first_center;  // the edge function there
};

HWY_INLINE void make_edge_vectors(const CornerBatch& t, std::size_t from, std::size_t to,
                                  const PixelRect& rect, EdgeVectors& e)
{
    for (std::size_t k = 0; k < Block::kCount; ++k) {
        e.dx[k] = t.x[to][k] - t.x[from][k];
        e.dy[k] = t.y[to][k] - t.y[from][k];
        e.x[k] = rect.x0 * kSubpixels + kSubpixels / 2 - t.x[from][k];
        e.y[k] = rect.y0 * kSubpixels + kSubpixels / 2 - t.y[from][k];
    }
    for (std::size_t k = 0; k < Block::kCount; ++k) {
        e.at_first_center[k] = static_cast<double>(e.dx[k]) * static_cast<double>(e.y[k]) -
                               static_cast<double>(e.dy[k]) * static_cast<double>(e.x[k]);
    }
}

HWY_INLINE void make_weights(const EdgeVectors& e, const DoubleEach& inverse_area, WeightBatch& w)
{
    for (std::size_t k = 0; k < Block::kCount; ++k) {
        const auto dx = static_cast<std::uint32_t>(e.dx[k]);
        const auto dy = static_cast<std::uint32_t>(e.dy[k]);
        w.edge[k] = static_cast<std::int32_t>(dx * static_cast<std::uint32_t>(e.y[k]) -
                                              dy * static_cast<std::uint32_t>(e.x[k]));
        w.edge_x[k] = static_cast<std::int32_t>((0u - dy) * kSubpixels);
        w.edge_y[k] = static_cast<std::int32_t>(dx * kSubpixels);
    }
    for (std::size_t k = 0; k < Block::kCount; ++k) {
        const double right = static_cast<double>(-e.dy[k]) * inverse_area[k];
        const double down = static_cast<double>(e.dx[k]) * inverse_area[k];
        w.base[k] = static_cast<float>(e.at_first_center[k] * inverse_area[k]);
        w.pixel_x[k] = static_cast<float>(right * kSubpixels);
        w.pixel_y[k] = static_cast<float>(down * kSubpixels);
        w.dx[k] = static_cast<float>(right);
        w.dy[k] = static_cast<float>(down);
    }
}

// In magnitude, of the terms that make the weight at the centre of a pixel that the triangle
// covers: within half a pixel of it the weight is in [0, 1].
HWY_INLINE void find_largest_weights(const WeightBatch& w, const PlaneBatch& p, DoubleEach& largest)
{
    alignas(64) DoubleEach step;
    for (std::size_t k = 0; k < Block::kCount; ++k) {
        step[k] = static_cast<double>(std::abs(w.dx[k])) + static_cast<double>(std::abs(w.dy[k]));
    }
    for (std::size_t k = 0; k < Block::kCount; ++k) largest[k] = 1 + step[k] * kSubpixels / 2;
    if (p.all_exact) return;
    for (std::size_t k = 0; k < Block::kCount; ++k) {
        if (p.exact[k] != 0) continue;
        largest[k] = static_cast<double>(std::abs(w.base[k])) + step[k] * kSubpixels * kTileSize;
    }
}

// |E| at the centre of a pixel that the triangle covers is at most A2 plus half a pixel's steps;
// both below 2^30 leaves it inside 32 bits.
inline constexpr double kLargestExactArea = 0x1p30;
inline constexpr std::int32_t kLongestExactEdge = 1 << 22;

HWY_INLINE void find_inverse_areas(const EdgeVectors& e0, const EdgeVectors& e2, std::size_t count,
                                   PlaneBatch& p)
{
    using whole = Block::whole;
    alignas(64) DoubleEach area;
    for (std::size_t k = 0; k < Block::kCount; ++k) {
        // (x1 - x0) (y2 - y0) - (x2 - x0) (y1 - y0), the edge 2 running from vertex 2 to vertex 0.
        area[k] = static_cast<double>(e2.dx[k]) * static_cast<double>(e0.dy[k]) -
                  static_cast<double>(e0.dx[k]) * static_cast<double>(e2.dy[k]);
        p.precise_inverse_area[k] = 1.0 / area[k];
    }
    for (std::size_t k = 0; k < Block::kCount; ++k) {
        p.inverse_area[k] = static_cast<float>(p.precise_inverse_area[k]);
    }
    const auto length = [](const EdgeVectors& e) HWY_ATTR {
        const auto size = [](const WholeEach& d) HWY_ATTR {
            return Block::max(whole::load(d), whole(0) - whole::load(d));
        };
        return size(e.dx) + size(e.dy);
    };
    const whole longest = Block::max(length(e0), length(e2));
    Block::select(longest < whole(kLongestExactEdge), whole(1), whole(0)).store(p.exact);
    std::size_t exact = 0;
    for (std::size_t k = 0; k < count; ++k) {
        if (!(area[k] < kLargestExactArea)) p.exact[k] = 0;
        exact += p.exact[k] != 0;
    }
    p.all_exact = exact == count;
}

// What is the same for all pixels.
HWY_INLINE void set_up_depth(const RealEach (&depth)[3], std::size_t count, bool orthographic,
                             PlaneBatch& p)
{
    using real = Block::real;
    using whole = Block::whole;
    const real d0 = real::load(depth[0]), d1 = real::load(depth[1]), d2 = real::load(depth[2]);
    const real least = Block::min(Block::min(d0, d1), d2);
    const real most = Block::max(Block::max(d0, d1), d2);
    least.store(p.least);
    most.store(p.most);
    d0.store(p.depth[0]);
    (d1 - d0).store(p.depth[1]);
    (d2 - d0).store(p.depth[2]);
    for (std::size_t i = 0; i < 3; ++i) {
        (real(-1.0f) * real::load(depth[i])).store(p.inverse_w[i]);
    }
    const whole level = Block::select(least == most, whole(1), whole(0));
    (orthographic ? whole(1) : level).store(p.affine);
    const std::uint32_t affine = orthographic ? ~0u : (least == most).bits();
    const std::uint32_t used = (1u << count) - 1;
    p.all_affine = (affine & used) == used;
    p.any_affine = (affine & used) != 0;
}

// d1, d2: what vertices 1 and 2 add to depth.
HWY_INLINE void find_slack(const DoubleEach& d1, const DoubleEach& d2, PlaneBatch& p)
{
    alignas(64) DoubleEach largest1, largest2;
    find_largest_weights(p.weight1, p, largest1);
    find_largest_weights(p.weight2, p, largest2);
    for (std::size_t k = 0; k < Block::kCount; ++k) {
        p.slack[k] =
            depth_slack({static_cast<float>(p.depth_dx[k]), static_cast<float>(p.depth_dy[k]),
                         p.least[k], p.most[k], 0, 0, 0, 0},
                        std::abs(d1[k]) * largest1[k] + std::abs(d2[k]) * largest2[k]);
    }
}

// `count` triangles; `depth`: of each vertex. `rect`: the tile's pixels in the picture.
HWY_INLINE void set_up_planes(const CornerBatch& t, const RealEach (&depth)[3], std::size_t count,
                              const PixelRect& rect, bool orthographic, PlaneBatch& p)
{
    EdgeVectors e0, e2;
    make_edge_vectors(t, 0, 1, rect, e0);
    make_edge_vectors(t, 2, 0, rect, e2);
    find_inverse_areas(e0, e2, count, p);
    make_weights(e2, p.precise_inverse_area, p.weight1);
    make_weights(e0, p.precise_inverse_area, p.weight2);
    set_up_depth(depth, count, orthographic, p);
    alignas(64) DoubleEach d1, d2;
    for (std::size_t k = 0; k < Block::kCount; ++k) {
        const double d0 = static_cast<double>(depth[0][k]);
        d1[k] = static_cast<double>(depth[1][k]) - d0;
        d2[k] = static_cast<double>(depth[2][k]) - d0;
    }
    for (std::size_t k = 0; k < Block::kCount; ++k) {
        const double area = p.precise_inverse_area[k], scale = area * kSubpixels;
        p.depth_dx[k] =
            -(static_cast<double>(e2.dy[k]) * d1[k] + static_cast<double>(e0.dy[k]) * d2[k]) *
            scale;
        p.depth_dy[k] =
            (static_cast<double>(e2.dx[k]) * d1[k] + static_cast<double>(e0.dx[k]) * d2[k]) * scale;
        p.depth_at[k] = static_cast<double>(depth[0][k]) +
                        (e2.at_first_center[k] * d1[k] + e0.at_first_center[k] * d2[k]) * area;
    }
    find_slack(d1, d2, p);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_PLANE_BATCH_INL_H
