// Meshes of triangles that follow on one another and have one material, in the world's space.
#include "compare/reproduce/sorted_triangles.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "scene/camera.h"
#include "scene/gltf/matrix.h"
#include "support/vec3.h"

namespace sheer {

namespace {

struct PlacedTriangle {
    double distance;
    std::uint32_t object, first;  // index of its mesh
};

// What an object's transform does to places and normals.
struct Placement {
    gltf::Matrix matrix;
    bool mirrors;

    explicit Placement(const Mat4& m)
    {
        std::copy(m.begin(), m.end(), matrix.begin());
        mirrors = gltf::determinant(matrix) < 0;
    }
    Vec3d place(const Float3& p) const { return to_vec3d(gltf::transform_point(matrix, p)); }
    Vec3d normal(const Float3& n) const
    {
        return normalized(to_vec3d(gltf::transform_normal(matrix, n)));
    }
    static Vec3d to_vec3d(const gltf::Vec3& v) { return {v[0], v[1], v[2]}; }
};

std::vector<PlacedTriangle> find_triangles(const Scene& scene, const View& view)
{
    const Projection projection = resolve_camera(scene, view);
    const auto& m = projection.world_to_view;
    std::vector<PlacedTriangle> triangles;
    for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
        const Object& object = scene.objects[o];
        const Mesh& mesh = scene.meshes[object.mesh];
        const Placement placement(object.transform);
        for (std::uint32_t first = 0; first < mesh.indices.size(); first += 3) {
            Vec3d sum{0, 0, 0};
            for (std::uint32_t i = 0; i < 3; ++i) {
                sum = sum + placement.place(mesh.positions[mesh.indices[first + i]]);
            }
            const double distance = -(m[2] * sum.x + m[6] * sum.y + m[10] * sum.z);
            triangles.push_back({distance, o, first});
        }
    }
    return triangles;
}

template <class Value>
void copy_attribute(const std::vector<Value>& from, std::uint32_t vertex, std::vector<Value>& to)
{
    if (!from.empty()) to.push_back(from[vertex]);
}

void append(const Mesh& mesh, const Placement& placement, std::uint32_t first, Mesh& to)
{
    for (std::uint32_t i = 0; i < 3; ++i) {
        // Seen from the front they stay counter-clockwise.
        const std::uint32_t corner = placement.mirrors ? 2 - i : i;
        const std::uint32_t vertex = mesh.indices[first + corner];
        to.indices.push_back(static_cast<std::uint32_t>(to.positions.size()));
        to.positions.push_back(to_float3(placement.place(mesh.positions[vertex])));
        if (!mesh.normals.empty()) {
            to.normals.push_back(to_float3(placement.normal(mesh.normals[vertex])));
        }
        copy_attribute(mesh.colors, vertex, to.colors);
        copy_attribute(mesh.texcoords[0], vertex, to.texcoords[0]);
    }
}

}  // namespace

Scene with_sorted_triangles(const Scene& scene, const View& view, TriangleOrder order)
{
    std::vector<PlacedTriangle> triangles = find_triangles(scene, view);
    std::stable_sort(triangles.begin(), triangles.end(),
                     [&](const PlacedTriangle& a, const PlacedTriangle& b) {
                         return order == TriangleOrder::near_to_far ? a.distance < b.distance
                                                                    : a.distance > b.distance;
                     });
    std::vector<Placement> placements;
    for (const Object& object : scene.objects) placements.emplace_back(object.transform);
    Scene sorted = scene;
    sorted.meshes.clear();
    sorted.objects.clear();
    for (const PlacedTriangle& triangle : triangles) {
        const Object& source = scene.objects[triangle.object];
        const std::uint32_t material = material_number(scene, source);
        if (sorted.meshes.empty() || sorted.meshes.back().material != material) {
            Object object;
            object.mesh = object.id = static_cast<std::uint32_t>(sorted.meshes.size());
            sorted.objects.push_back(object);
            sorted.meshes.emplace_back().material = material;
        }
        append(scene.meshes[source.mesh], placements[triangle.object], triangle.first,
               sorted.meshes.back());
    }
    return sorted;
}

}  // namespace sheer
