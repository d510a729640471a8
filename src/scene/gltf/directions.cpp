// glTF 2.0, section 3.7.2.1: what normals and tangents must be; files differ.

#include "scene/gltf/directions.h"

#include <cmath>

#include "scene/gltf/matrix.h"

namespace sheer::gltf {

namespace {

Vec3 cross_of_edges(const Float3& a, const Float3& b, const Float3& c)
{
    Vec3 u, v;
    for (std::size_t k = 0; k < 3; ++k) {
        u[k] = static_cast<double>(b[k]) - static_cast<double>(a[k]);
        v[k] = static_cast<double>(c[k]) - static_cast<double>(a[k]);
    }
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// False when there is no direction in it. `to` may be `from`.
template <class Vector>
bool normalize(const Vector& from, Float3& to)
{
    const auto unit = direction({from[0], from[1], from[2]});
    if (!unit) return false;
    for (std::size_t k = 0; k < 3; ++k) to[k] = static_cast<float>((*unit)[k]);
    return true;
}

// The vertices whose normals have no direction; all others are normalised.
std::vector<std::uint32_t> normalize_normals(Mesh& mesh)
{
    std::vector<std::uint32_t> broken;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        if (!normalize(mesh.normals[i], mesh.normals[i])) {
            broken.push_back(static_cast<std::uint32_t>(i));
        }
    }
    return broken;
}

}  // namespace

void repair_normals(Mesh& mesh, Notes& notes)
{
    const std::vector<std::uint32_t> broken = normalize_normals(mesh);
    if (broken.empty()) return;
    if (mesh.topology != Topology::triangles) {
        mesh.normals.clear();
        notes.add("lines and points with normals without a direction", "drawn without them");
        return;
    }
    notes.add("normals without a direction", "made from their triangles", broken.size());
    std::vector<Vec3> sums(mesh.positions.size());
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
        const std::uint32_t* v = &mesh.indices[t];
        const Vec3 normal =
            cross_of_edges(mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            for (std::size_t k = 0; k < 3; ++k) sums[v[corner]][k] += normal[k];
        }
    }
    for (const std::uint32_t i : broken) {
        // A vertex of nothing but degenerate triangles is not seen: any normal serves.
        if (!normalize(sums[i], mesh.normals[i])) mesh.normals[i] = {0, 1, 0};
    }
}

void repair_tangents(Mesh& mesh, Notes& notes)
{
    if (mesh.normals.empty()) mesh.tangents.clear();
    for (Float4& tangent : mesh.tangents) {
        Float3 direction = {tangent[0], tangent[1], tangent[2]};
        if (!normalize(direction, direction) || !(std::abs(tangent[3]) > 0)) {
            mesh.tangents.clear();
            notes.add("primitives with a tangent without direction or side",
                      "their tangents are made from texture coordinates");
            return;
        }
        tangent = {direction[0], direction[1], direction[2], tangent[3] < 0 ? -1.0f : 1.0f};
    }
}

}  // namespace sheer::gltf
