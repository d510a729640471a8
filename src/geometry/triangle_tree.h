// A bounding volume hierarchy over triangles, for rays.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/divide_triangles.h"
#include "support/vec3.h"

namespace sheer {

struct Ray {
    Vec3d from, direction;  // of any length; 0 meets nothing
    double least, most;     // hits count between: multiples of the direction; 0 or more
};

struct RayHit {
    std::uint32_t triangle;
    double at;      // multiples of the direction
    double w1, w2;  // weights of the triangle's corners 1 and 2
};

struct TriangleEdges {
    Vec3d corner, edge1, edge2;  // of corner 0, and from it to the others

    explicit TriangleEdges(const TriangleCorners& t)
        : corner(t[0]), edge1(t[1] - t[0]), edge2(t[2] - t[0])
    {
    }
};

// Whether a ray meets the triangle from either side; if so, fills in all of `hit` but its number.
bool meets(const TriangleEdges& triangle, const Ray& ray, RayHit& hit);

// Plain loops, which round in the same way everywhere: the same hits in the same order on every
// machine. What is hit does not depend on how the tree is divided: who meets a box meets the boxes
// around it, roundings included.
class TriangleTree {
public:
    TriangleTree() = default;
    explicit TriangleTree(std::vector<TriangleCorners> triangles);

    // Calls `hit`, a function of a RayHit, for each triangle that the ray meets, in an order of the
    // tree's own, until it returns false.
    template <class Hit>
    void trace(const Ray& ray, const Hit& hit) const
    {
        trace(ray, {&hit, [](const void* function, const RayHit& at) {
                        return (*static_cast<const Hit*>(function))(at);
                    }});
    }

    // Its length is twice the triangle's area.
    Vec3d normal(std::uint32_t triangle) const;

private:
    // Four boxes, each around one triangle or another node. Aligned to lines of the cache.
    struct alignas(64) Node {
        float sides[6][4];  // low x, y, z, high x, y, z
        std::uint32_t child[4];
    };
    // Triangles in a row, that so many divisions left.
    struct Part {
        std::uint32_t begin, end;
        int depth;
        Box box;
    };
    struct Parts {
        std::array<Part, 4> part;
        std::size_t count;
    };
    struct BoxRay;
    struct HitFunction {
        const void* function;
        bool (*call)(const void* function, const RayHit& hit);
    };

    Part part_of(std::uint32_t begin, std::uint32_t end, int depth) const;
    Parts divide_in_four(const Part& all);
    std::uint32_t add_node(const Part& all);
    void set_box(Node& node, std::size_t lane, const Box& box) const;
    void trace(const Ray& ray, const HitFunction& hit) const;

    // Boxes lie within 1 of the middle, in units of 1 / scale metres.
    Vec3d middle_;
    double scale_ = 1;
    std::vector<Node> nodes_;
    std::vector<TriangleCorners> corners_;  // by number; while the tree is built
    std::vector<TriangleEdges> triangles_;  // as the nodes have them
    std::vector<std::uint32_t> order_;      // their numbers
    std::vector<std::uint32_t> place_;      // of each number, among them
};

}  // namespace sheer
