// A bounding volume hierarchy over triangles, for rays.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "support/vec3.h"

namespace sheer {

using TriangleCorners = std::array<Vec3d, 3>;

struct Ray {
    Vec3d from, direction;  // of any length but 0
    double least, most;     // hits count between: multiples of the direction
};

struct RayHit {
    std::uint32_t triangle;
    double at;      // multiples of the direction
    double w1, w2;  // weights of the triangle's corners 1 and 2
};

// Doubles and plain loops: the same hits in the same order on every machine.
class TriangleTree {
public:
    TriangleTree() = default;
    explicit TriangleTree(std::vector<TriangleCorners> triangles);

    // Calls `hit` for each triangle that the ray meets from either side, in an order of the tree's
    // own, until it returns false.
    void trace(const Ray& ray, const std::function<bool(const RayHit&)>& hit) const;

    const TriangleCorners& corners(std::uint32_t triangle) const
    {
        return triangles_[place_[triangle]];
    }

private:
    struct Node {
        Vec3d low, high;
        // Of a leaf: triangles_[first .. first + count). Else count is 0 and the children are the
        // next node, whose triangles' middles are lower along the axis, and node `first`.
        std::uint32_t first, count, axis;
    };

    void build(std::uint32_t begin, std::uint32_t end, int depth);

    std::vector<TriangleCorners> triangles_;  // leaf by leaf
    std::vector<std::uint32_t> order_;        // their numbers
    std::vector<std::uint32_t> place_;        // of each number, among them
    std::vector<Node> nodes_;
};

}  // namespace sheer
