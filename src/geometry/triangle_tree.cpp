// Halves by the middle triangle along the longest side, slabs for boxes, and for triangles:
// Moeller and Trumbore. Fast, Minimum Storage Ray-Triangle Intersection. Journal of Graphics Tools
// 2(1), 1997.
#include "geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace sheer {

namespace {

constexpr std::uint32_t kLeaf = 4;  // triangles

constexpr double Vec3d::*kAxes[3] = {&Vec3d::x, &Vec3d::y, &Vec3d::z};

struct Box {
    Vec3d low, high;

    Box()
    {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        low = {kInfinity, kInfinity, kInfinity};
        high = {-kInfinity, -kInfinity, -kInfinity};
    }
    void add(const Vec3d& p)
    {
        for (const auto axis : kAxes) {
            low.*axis = std::min(low.*axis, p.*axis);
            high.*axis = std::max(high.*axis, p.*axis);
        }
    }
    // So that no rounding of the slabs loses what touches a side.
    void grow()
    {
        for (const auto axis : kAxes) {
            const double more = 1e-12 * std::max(std::abs(low.*axis), std::abs(high.*axis));
            low.*axis -= more;
            high.*axis += more;
        }
    }
};

bool meets(const Vec3d& low, const Vec3d& high, const Ray& ray)
{
    double from = ray.least, to = ray.most;
    for (const auto axis : kAxes) {
        const double start = ray.from.*axis, step = ray.direction.*axis;
        if (step == 0) {
            if (start < low.*axis || start > high.*axis) return false;
            continue;
        }
        const double a = (low.*axis - start) / step, b = (high.*axis - start) / step;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

bool meets(const TriangleCorners& t, const Ray& ray, RayHit& hit)
{
    const Vec3d edge1 = t[1] - t[0], edge2 = t[2] - t[0];
    const Vec3d p = cross(ray.direction, edge2);
    const double determinant = dot(edge1, p);
    if (determinant == 0) return false;
    const Vec3d off = ray.from - t[0];
    hit.w1 = dot(off, p) / determinant;
    if (!(hit.w1 >= 0 && hit.w1 <= 1)) return false;
    const Vec3d q = cross(off, edge1);
    hit.w2 = dot(ray.direction, q) / determinant;
    if (!(hit.w2 >= 0 && hit.w1 + hit.w2 <= 1)) return false;
    hit.at = dot(edge2, q) / determinant;
    return hit.at > ray.least && hit.at < ray.most;
}

double middle(const TriangleCorners& t, double Vec3d::*axis)
{
    return t[0].*axis + t[1].*axis + t[2].*axis;
}

}  // namespace

TriangleTree::TriangleTree(std::vector<TriangleCorners> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size())
{
    std::iota(order_.begin(), order_.end(), 0u);
    if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

void TriangleTree::build(std::uint32_t begin, std::uint32_t end)
{
    Box box, middles;
    for (std::uint32_t i = begin; i < end; ++i) {
        const TriangleCorners& t = triangles_[order_[i]];
        for (const Vec3d& p : t) box.add(p);
        middles.add({middle(t, &Vec3d::x), middle(t, &Vec3d::y), middle(t, &Vec3d::z)});
    }
    box.grow();
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({box.low, box.high, begin, end - begin});
    if (end - begin <= kLeaf) {
        std::sort(order_.begin() + begin, order_.begin() + end);
        return;
    }
    auto longest = kAxes[0];
    for (const auto axis : kAxes) {
        const auto extent = [&](auto a) { return middles.high.*a - middles.low.*a; };
        if (extent(axis) > extent(longest)) longest = axis;
    }
    const std::uint32_t half = begin + (end - begin) / 2;
    // Ties by number, so that the halves are the same whatever the algorithm.
    std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double at_a = middle(triangles_[a], longest);
                         const double at_b = middle(triangles_[b], longest);
                         return at_a < at_b || (at_a == at_b && a < b);
                     });
    nodes_[node].count = 0;
    build(begin, half);
    nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
    build(half, end);
}

void TriangleTree::trace(const Ray& ray, const std::function<bool(const RayHit&)>& hit) const
{
    if (nodes_.empty()) return;
    // Halves leave at most 32 levels, each with one node that waits.
    std::array<std::uint32_t, 64> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const std::uint32_t number = waiting[--count];
        const Node& node = nodes_[number];
        if (!meets(node.low, node.high, ray)) continue;
        if (node.count == 0) {
            waiting[count++] = node.first;
            waiting[count++] = number + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            RayHit found{order_[i], 0, 0, 0};
            if (meets(triangles_[order_[i]], ray, found) && !hit(found)) return;
        }
    }
}

}  // namespace sheer
