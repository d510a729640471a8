// Boxes are divided where rays are likely to meet few triangles (Wald. On fast Construction of
// SAH-based Bounding Volume Hierarchies. RT 2007), slabs for boxes, and for triangles: Moeller and
// Trumbore. Fast, Minimum Storage Ray-Triangle Intersection. Journal of Graphics Tools 2(1), 1997.
#include "geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
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
    void add(const Box& other)
    {
        for (const auto axis : kAxes) {
            low.*axis = std::min(low.*axis, other.low.*axis);
            high.*axis = std::max(high.*axis, other.high.*axis);
        }
    }
    // Half of its surface, to which the rays that meet it are proportional.
    double area() const
    {
        const Vec3d side = high - low;
        return side.x * side.y + side.y * side.z + side.z * side.x;
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

// What a ray's way through boxes needs, once: dividing takes most of the time of meeting one.
struct Slabs {
    Vec3d from, inverse;
    double least, most;

    explicit Slabs(const Ray& ray) : from(ray.from), least(ray.least), most(ray.most)
    {
        for (const auto axis : kAxes) inverse.*axis = 1 / ray.direction.*axis;
    }
    // Along an axis that the ray does not move by, ends are infinite; or no numbers, where it
    // starts in a box without extent: as second operands of min and max these are not taken.
    bool meet(const Vec3d& low, const Vec3d& high) const
    {
        double begin = least, end = most;
        for (const auto axis : kAxes) {
            const double a = (low.*axis - from.*axis) * inverse.*axis;
            const double b = (high.*axis - from.*axis) * inverse.*axis;
            begin = std::max(begin, std::min(a, b));
            end = std::min(end, std::max(a, b));
        }
        // A few roundings, of what may be far.
        return begin <= end * (1 + 1e-14);
    }
};

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

constexpr std::size_t kBins = 16;
// From here on by halves, which leave at most 32 levels more.
constexpr int kMostCuts = 32;

// Triangles are cut where those whose middle lies in the first bins end.
struct Cut {
    std::uint32_t axis = 0;
    std::size_t bins = 0;
    double cost = std::numeric_limits<double>::infinity();
};

// Of middles from `from` to `to`: which bin one is in.
struct Bins {
    double from, scale;

    Bins(double first, double last) : from(first), scale(kBins / (last - first)) {}
    std::size_t of(double at) const
    {
        const double bin = (at - from) * scale;
        return bin < kBins - 1 ? static_cast<std::size_t>(bin) : kBins - 1;
    }
};

void find_cut(const std::vector<TriangleCorners>& triangles, std::span<const std::uint32_t> numbers,
              std::uint32_t axis, const Bins& bins, Cut& best)
{
    std::array<Box, kBins> boxes;
    std::array<double, kBins> counts = {};
    for (const std::uint32_t i : numbers) {
        const std::size_t bin = bins.of(middle(triangles[i], kAxes[axis]));
        for (const Vec3d& p : triangles[i]) boxes[bin].add(p);
        counts[bin] += 1;
    }
    std::array<double, kBins> before = {};  // costs of all bins before
    Box box;
    double count = 0;
    for (std::size_t i = 0; i + 1 < kBins; ++i) {
        box.add(boxes[i]);
        count += counts[i];
        before[i + 1] = count > 0 ? count * box.area() : -1;
    }
    box = Box();
    count = 0;
    for (std::size_t i = kBins - 1; i > 0; --i) {
        box.add(boxes[i]);
        count += counts[i];
        if (!(count > 0) || before[i] < 0) continue;
        const double cost = before[i] + count * box.area();
        if (cost < best.cost) best = {axis, i, cost};
    }
}

// Rearranges numbers of triangles; the axis that they are divided along, and how many come first.
std::pair<std::uint32_t, std::uint32_t> divide(const std::vector<TriangleCorners>& triangles,
                                               std::span<std::uint32_t> numbers, int depth)
{
    Box middles;
    for (const std::uint32_t i : numbers) {
        const TriangleCorners& t = triangles[i];
        middles.add({middle(t, &Vec3d::x), middle(t, &Vec3d::y), middle(t, &Vec3d::z)});
    }
    const auto bins = [&](std::uint32_t a) {
        return Bins(middles.low.*kAxes[a], middles.high.*kAxes[a]);
    };
    const auto extent = [&](std::uint32_t a) {
        return middles.high.*kAxes[a] - middles.low.*kAxes[a];
    };
    Cut best;
    std::uint32_t longest = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        if (extent(axis) > extent(longest)) longest = axis;
        if (extent(axis) > 0 && depth < kMostCuts)
            find_cut(triangles, numbers, axis, bins(axis), best);
    }
    if (best.bins > 0) {
        const Bins of_axis = bins(best.axis);
        const auto is_before = [&](std::uint32_t i) {
            return of_axis.of(middle(triangles[i], kAxes[best.axis])) < best.bins;
        };
        const auto half = std::partition(numbers.begin(), numbers.end(), is_before);
        return {best.axis, static_cast<std::uint32_t>(half - numbers.begin())};
    }
    const std::size_t half = numbers.size() / 2;
    // Ties by number, so that the halves are the same whatever the algorithm.
    std::nth_element(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(half),
                     numbers.end(), [&](std::uint32_t a, std::uint32_t b) {
                         const double at_a = middle(triangles[a], kAxes[longest]);
                         const double at_b = middle(triangles[b], kAxes[longest]);
                         return at_a < at_b || (at_a == at_b && a < b);
                     });
    return {longest, static_cast<std::uint32_t>(half)};
}

}  // namespace

TriangleTree::TriangleTree(std::vector<TriangleCorners> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size()), place_(triangles_.size())
{
    std::iota(order_.begin(), order_.end(), 0u);
    if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()), 0);
    std::vector<TriangleCorners> by_leaf;
    by_leaf.reserve(triangles_.size());
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
        by_leaf.push_back(triangles_[order_[i]]);
        place_[order_[i]] = i;
    }
    triangles_ = std::move(by_leaf);
}

void TriangleTree::build(std::uint32_t begin, std::uint32_t end, int depth)
{
    Box box;
    for (std::uint32_t i = begin; i < end; ++i) {
        for (const Vec3d& p : triangles_[order_[i]]) box.add(p);
    }
    box.grow();
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({box.low, box.high, begin, end - begin, 0});
    if (end - begin <= kLeaf) {
        std::sort(order_.begin() + begin, order_.begin() + end);
        return;
    }
    const auto [axis, half] = divide(triangles_, {order_.data() + begin, end - begin}, depth);
    nodes_[node].count = 0;
    nodes_[node].axis = axis;
    build(begin, begin + half, depth + 1);
    nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
    build(begin + half, end, depth + 1);
}

void TriangleTree::trace(const Ray& ray, const std::function<bool(const RayHit&)>& hit) const
{
    if (nodes_.empty()) return;
    // Each level has one node that waits.
    std::array<std::uint32_t, kMostCuts + 34> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    const Slabs slabs(ray);
    while (count > 0) {
        const std::uint32_t number = waiting[--count];
        const Node& node = nodes_[number];
        if (!slabs.meet(node.low, node.high)) continue;
        if (node.count == 0) {
            // The nearer one is next.
            const bool turned = ray.direction.*kAxes[node.axis] < 0;
            waiting[count++] = turned ? number + 1 : node.first;
            waiting[count++] = turned ? node.first : number + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            RayHit found{order_[i], 0, 0, 0};
            if (meets(triangles_[i], ray, found) && !hit(found)) return;
        }
    }
}

}  // namespace sheer
