// Four boxes at a time (Wald, Benthin, Boulos. Getting Rid of Packets. RT 2008), slabs for boxes,
// and for triangles: Moeller and Trumbore. Fast, Minimum Storage Ray-Triangle Intersection. Journal
// of Graphics Tools 2(1), 1997.
#include "geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sheer {

namespace {

constexpr std::uint32_t kLeaf = 4;                // triangles: what one node holds
constexpr std::uint32_t kTriangle = 0x80000000u;  // of a node's child: the rest is its place

float not_above(double x)
{
    const auto f = static_cast<float>(x);
    return static_cast<double>(f) > x ? std::nextafter(f, -2.0f) : f;
}

float not_below(double x)
{
    return -not_above(-x);
}

double largest(const Vec3d& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

bool is_finite(const TriangleCorners& t)
{
    return std::all_of(t.begin(), t.end(), [](const Vec3d& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

float later(float a, float b)
{
    return b > a ? b : a;
}

float sooner(float a, float b)
{
    return b < a ? b : a;
}

}  // namespace

// Most triangles are rejected before the division, and never one that the quotients below would
// have accepted: more than `size` by the last bit is more than 1 after rounding, a quotient of
// -2^-60 does not become -0, and 2^-40 is more than three roundings.
bool meets(const TriangleEdges& t, const Ray& ray, RayHit& hit)
{
    const Vec3d p = cross(ray.direction, t.edge2);
    const double determinant = dot(t.edge1, p);
    if (determinant == 0) return false;
    const double sign = determinant < 0 ? -1 : 1, size = sign * determinant;
    const Vec3d off = ray.from - t.corner;
    const double part1 = sign * dot(off, p);
    if (part1 > size || part1 < -0x1p-60 * size) return false;
    const Vec3d q = cross(off, t.edge1);
    const double part2 = sign * dot(ray.direction, q);
    if (part1 + part2 > size * (1 + 0x1p-40) || part2 < -0x1p-60 * size) return false;
    const double length = sign * dot(t.edge2, q);
    if (!(length > 0)) return false;
    hit.w1 = part1 / size;
    if (!(hit.w1 >= 0 && hit.w1 <= 1)) return false;
    hit.w2 = part2 / size;
    if (!(hit.w2 >= 0 && hit.w1 + hit.w2 <= 1)) return false;
    hit.at = length / size;
    return hit.at > ray.least && hit.at < ray.most;
}

// A ray in the units of the boxes, from where it comes near them; each number four times.
//
// Boxes grow by `pad`, so that none is missed whose triangle is met. With e = 2^-24, what a float
// rounds by, and u = 2^-53: boxes lie within 1 of the middle, so the ray is within 2 steps (of
// `way`, whose largest part is 1) of the point nearest to it where it meets one, and begins within
// 4 of it: as floats its places are off by 2 e. What doubles round is below 8 u (1 + |from|), and a
// part of the way that is taken for 2^-40 moves the ray by 2^-38. All this is less than 2^-22 +
// 2^-48 |from|. The test for triangles is off by some 8 u |from| over the sines of the angles of
// ray, plane and edges: the pad leaves room down to sines of 2^-14.
struct TriangleTree::BoxRay {
    struct Axis {
        std::size_t near, far;  // which sides it meets first and last
        float from_near[4], from_far[4], inverse[4];
    };
    Axis x, y, z;
    float length[4];

    BoxRay(const Ray& ray, const Vec3d& middle, double scale)
    {
        const double most = largest(ray.direction);
        const Vec3d way = {ray.direction.x / most, ray.direction.y / most, ray.direction.z / most};
        const Vec3d from = scale * (ray.from - middle);
        const double nearest = -dot(from, way) / dot(way, way);
        const double begin = std::max(ray.least * most * scale, nearest - 2);
        const double end = std::min(ray.most * most * scale, nearest + 2);
        const double pad = 0x1p-20 + 0x1p-36 * largest(from);
        x = axis(0, from.x + begin * way.x, way.x, pad);
        y = axis(1, from.y + begin * way.y, way.y, pad);
        z = axis(2, from.z + begin * way.z, way.z, pad);
        std::fill_n(length, 4, static_cast<float>(end - begin + pad));
    }

    static Axis axis(std::size_t number, double at, double slope, double pad)
    {
        Axis axis;
        const bool down = slope < 0;
        axis.near = down ? number + 3 : number;
        axis.far = down ? number : number + 3;
        std::fill_n(axis.from_near, 4, static_cast<float>(down ? at - pad : at + pad));
        std::fill_n(axis.from_far, 4, static_cast<float>(down ? at + pad : at - pad));
        const double steep = std::max(std::abs(slope), 0x1p-40);  // no infinities, nor 0 * those
        std::fill_n(axis.inverse, 4, static_cast<float>((down ? -1 : 1) / steep));
        return axis;
    }

    // How much of the ray is in each box: less than 0 where they don't meet. Each end is rounded
    // three times, thus by less than 4 e; of two boxes, one in the other, the larger never has
    // less. One plain loop in a function of its own becomes vector instructions; inlined, it would
    // not.
    [[gnu::noinline]] void meet(const Node& node, float (&part)[4]) const
    {
        const float *x0 = node.sides[x.near], *x1 = node.sides[x.far];
        const float *y0 = node.sides[y.near], *y1 = node.sides[y.far];
        const float *z0 = node.sides[z.near], *z1 = node.sides[z.far];
        float parts[4];
        for (std::size_t i = 0; i < 4; ++i) {
            float begin = 0, end = length[i];
            begin = later(begin, (x0[i] - x.from_near[i]) * x.inverse[i]);
            begin = later(begin, (y0[i] - y.from_near[i]) * y.inverse[i]);
            begin = later(begin, (z0[i] - z.from_near[i]) * z.inverse[i]);
            end = sooner(end, (x1[i] - x.from_far[i]) * x.inverse[i]);
            end = sooner(end, (y1[i] - y.from_far[i]) * y.inverse[i]);
            end = sooner(end, (z1[i] - z.from_far[i]) * z.inverse[i]);
            parts[i] = end * (1 + 0x1p-20f) - begin;
        }
        for (std::size_t i = 0; i < 4; ++i) part[i] = parts[i];
    }
};

TriangleTree::TriangleTree(std::vector<TriangleCorners> triangles)
    : corners_(std::move(triangles)), place_(corners_.size())
{
    // No ray meets what is not finite, which would leave the boxes no size.
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
        if (is_finite(corners_[i])) order_.push_back(i);
    }
    if (order_.empty()) return;
    const Part all = part_of(0, static_cast<std::uint32_t>(order_.size()), 0);
    middle_ = 0.5 * all.box.low + 0.5 * all.box.high;
    int exponent = 0;
    std::frexp(std::max(largest(all.box.high - middle_), largest(middle_ - all.box.low)),
               &exponent);
    scale_ = std::ldexp(1, std::clamp(-exponent, -1024, 1000));
    add_node(all);
    triangles_.reserve(order_.size());
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
        triangles_.emplace_back(corners_[order_[i]]);
        place_[order_[i]] = i;
    }
    corners_ = {};
}

TriangleTree::Part TriangleTree::part_of(std::uint32_t begin, std::uint32_t end, int depth) const
{
    return {begin, end, depth, box_of(corners_, {order_.data() + begin, end - begin})};
}

// By number if they are no more than a node holds, else with those parts divided that most rays
// meet.
TriangleTree::Parts TriangleTree::divide_in_four(const Part& all)
{
    Parts parts = {{all}, 1};
    if (all.end - all.begin <= kLeaf) {
        std::sort(order_.begin() + all.begin, order_.begin() + all.end);
        parts.count = all.end - all.begin;
        for (std::uint32_t i = 0; i < parts.count; ++i)
            parts.part[i] = part_of(all.begin + i, all.begin + i + 1, 0);
        return parts;
    }
    while (parts.count < 4) {
        Part* widest = nullptr;
        for (std::size_t i = 0; i < parts.count; ++i) {
            Part& part = parts.part[i];
            if (part.end - part.begin <= kLeaf) continue;
            if (!widest || part.box.area() > widest->box.area()) widest = &part;
        }
        if (!widest) break;
        const auto [begin, end, depth, box] = *widest;
        const auto first = static_cast<std::uint32_t>(
            divide_triangles(corners_, {order_.data() + begin, end - begin}, depth));
        *widest = part_of(begin, begin + first, depth + 1);
        parts.part[parts.count++] = part_of(begin + first, end, depth + 1);
    }
    return parts;
}

std::uint32_t TriangleTree::add_node(const Part& all)
{
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Parts parts = divide_in_four(all);
    // Last, thus looked into first, comes what hides most: in the scenes measured, rays that need
    // not go on end there sooner than with the nearest first.
    std::stable_sort(parts.part.begin(),
                     parts.part.begin() + static_cast<std::ptrdiff_t>(parts.count),
                     [](const Part& a, const Part& b) { return a.box.area() < b.box.area(); });
    Node node = {};
    for (std::size_t i = 0; i < 4; ++i) {
        set_box(node, i, Box());
        if (i >= parts.count) continue;
        const Part& part = parts.part[i];
        set_box(node, i, part.box);
        node.child[i] = part.end - part.begin == 1 ? kTriangle | part.begin : add_node(part);
    }
    nodes_[number] = node;
    return number;
}

void TriangleTree::set_box(Node& node, std::size_t lane, const Box& box) const
{
    const Vec3d low = scale_ * (box.low - middle_), high = scale_ * (box.high - middle_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        node.sides[axis][lane] = not_above(low.*kCoordinates[axis]);
        node.sides[axis + 3][lane] = not_below(high.*kCoordinates[axis]);
    }
}

Vec3d TriangleTree::normal(std::uint32_t triangle) const
{
    const TriangleEdges& t = triangles_[place_[triangle]];
    return cross(t.edge1, t.edge2);
}

void TriangleTree::trace(const Ray& ray, const HitFunction& hit) const
{
    if (nodes_.empty()) return;
    // Each level leaves three nodes that wait.
    std::array<std::uint32_t, 3 * (kMostCuts + 34) + 2> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    const BoxRay boxes(ray, middle_, scale_);
    while (count > 0) {
        const Node& node = nodes_[waiting[--count]];
        float part[4];
        boxes.meet(node, part);
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t child = node.child[i];
            // The root is no node's child: a lane without one.
            if (part[i] < 0 || child == 0) continue;
            if (!(child & kTriangle)) {
                waiting[count++] = child;
                continue;
            }
            const std::uint32_t place = child ^ kTriangle;
            RayHit found{order_[place], 0, 0, 0};
            if (meets(triangles_[place], ray, found) && !hit.call(hit.function, found)) return;
        }
    }
}

}  // namespace sheer
