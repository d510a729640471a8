// From a bag of faces to a mesh: equal corners become one vertex where their normals agree.
//
// A corner's normal is the sum, by area, of those faces around its point that turn from its own by
// less than the crease angle: cylinders come out smooth, shoulders and tooth edges sharp.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/builtin/shapes.h"

namespace sheer::shapes {
namespace {

constexpr double kCreaseCosine = 0.766;  // 40 degrees: between a bevel's 45 and a 12-gon's 30

struct Polygon {
    std::uint32_t point[4];
    std::uint32_t corners = 0;
    Vec area;  // along the normal, twice the area long
    Vec normal;
};

struct Welded {
    std::vector<Float3> points;
    std::vector<Polygon> polygons;
};

Float3 rounded(Vec v)
{
    // Adding 0 turns -0 into 0, so that equal points have equal bits.
    return {static_cast<float>(v.x) + 0.0f, static_cast<float>(v.y) + 0.0f,
            static_cast<float>(v.z) + 0.0f};
}

Vec widened(const Float3& v)
{
    return {v[0], v[1], v[2]};
}

// The points in the order in which the faces name them first: neighbours stay close in memory.
std::vector<std::uint32_t> weld(const std::vector<Float3>& corners, std::vector<Float3>& points)
{
    std::vector<std::uint32_t> order(corners.size()), first(corners.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return corners[a] != corners[b] ? corners[a] < corners[b] : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && corners[order[i]] == corners[order[i - 1]];
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    std::vector<std::uint32_t> point(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (first[i] == i) {
            point[i] = static_cast<std::uint32_t>(points.size());
            points.push_back(corners[i]);
        } else {
            point[i] = point[first[i]];
        }
    }
    return point;
}

Welded weld_faces(const Solid& solid)
{
    std::vector<Float3> corners;
    for (const Face& face : solid.faces)
        for (const Vec& corner : face.corner) corners.push_back(rounded(corner));
    Welded welded;
    const std::vector<std::uint32_t> point = weld(corners, welded.points);
    for (std::size_t f = 0; f < solid.faces.size(); ++f) {
        Polygon polygon;
        for (std::size_t i = 0; i < 4; ++i)
            if (point[4 * f + i] != point[4 * f + (i + 1) % 4])
                polygon.point[polygon.corners++] = point[4 * f + i];
        if (polygon.corners < 3) continue;
        const auto at = [&](std::uint32_t i) {
            return widened(welded.points[polygon.point[i % polygon.corners]]);
        };
        polygon.area = cross(at(2) - at(0), at(3) - at(1));
        polygon.normal = normalize(polygon.area);
        welded.polygons.push_back(polygon);
    }
    return welded;
}

// Polygons around each point: around[begin[p]] to around[begin[p + 1]].
struct Neighbours {
    std::vector<std::uint32_t> begin, around;
};

Neighbours find_neighbours(const Welded& welded)
{
    Neighbours n;
    n.begin.assign(welded.points.size() + 1, 0);
    for (const Polygon& polygon : welded.polygons)
        for (std::uint32_t i = 0; i < polygon.corners; ++i) ++n.begin[polygon.point[i] + 1];
    std::partial_sum(n.begin.begin(), n.begin.end(), n.begin.begin());
    n.around.resize(n.begin.back());
    std::vector<std::uint32_t> next(n.begin.begin(), n.begin.end() - 1);
    for (std::uint32_t f = 0; f < welded.polygons.size(); ++f)
        for (std::uint32_t i = 0; i < welded.polygons[f].corners; ++i)
            n.around[next[welded.polygons[f].point[i]]++] = f;
    return n;
}

}  // namespace

Mesh to_mesh(const Solid& solid, const std::string& name)
{
    const Welded welded = weld_faces(solid);
    const Neighbours neighbours = find_neighbours(welded);
    Mesh mesh;
    mesh.name = name;
    std::vector<std::vector<std::uint32_t>> vertices(welded.points.size());
    const auto vertex_of = [&](const Polygon& polygon, std::uint32_t point) {
        Vec sum;
        for (std::uint32_t i = neighbours.begin[point]; i < neighbours.begin[point + 1]; ++i) {
            const Polygon& other = welded.polygons[neighbours.around[i]];
            if (dot(polygon.normal, other.normal) >= kCreaseCosine) sum = sum + other.area;
        }
        const Float3 normal = rounded(normalize(sum));
        for (const std::uint32_t vertex : vertices[point])
            if (mesh.normals[vertex] == normal) return vertex;
        mesh.positions.push_back(welded.points[point]);
        mesh.normals.push_back(normal);
        vertices[point].push_back(static_cast<std::uint32_t>(mesh.positions.size() - 1));
        return vertices[point].back();
    };
    for (const Polygon& polygon : welded.polygons) {
        std::uint32_t vertex[4];
        for (std::uint32_t i = 0; i < polygon.corners; ++i)
            vertex[i] = vertex_of(polygon, polygon.point[i]);
        for (std::uint32_t i = 2; i < polygon.corners; ++i)
            mesh.indices.insert(mesh.indices.end(), {vertex[0], vertex[i - 1], vertex[i]});
    }
    return mesh;
}

}  // namespace sheer::shapes
