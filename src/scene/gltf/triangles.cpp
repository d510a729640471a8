// Topology and normals (glTF 2.0, section 3.7.2.1: the winding of strips and fans is its formula).

#include "scene/gltf/triangles.h"

#include <algorithm>
#include <cmath>

namespace sheer::gltf {

namespace {

using Double3 = std::array<double, 3>;

constexpr std::uint32_t kUnused = 0xFFFFFFFFu;

template <class T>
void keep(std::vector<T>& values, const std::vector<std::uint32_t>& new_index, std::size_t count)
{
    if (values.empty()) return;
    for (std::size_t i = 0; i < new_index.size(); ++i) {
        if (new_index[i] != kUnused) values[new_index[i]] = values[i];
    }
    values.resize(count);
    values.shrink_to_fit();
}

Double3 cross_of_edges(const Float3& a, const Float3& b, const Float3& c)
{
    Double3 u, v;
    for (std::size_t k = 0; k < 3; ++k) {
        u[k] = static_cast<double>(b[k]) - static_cast<double>(a[k]);
        v[k] = static_cast<double>(c[k]) - static_cast<double>(a[k]);
    }
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// False when there is no direction in it.
bool normalize(const Double3& from, Float3& to)
{
    const double largest = std::max({std::abs(from[0]), std::abs(from[1]), std::abs(from[2])});
    if (!(largest > 0) || !std::isfinite(largest)) return false;
    const double x = from[0] / largest, y = from[1] / largest, z = from[2] / largest;
    const double length = std::sqrt(x * x + y * y + z * z);
    to = {static_cast<float>(x / length), static_cast<float>(y / length),
          static_cast<float>(z / length)};
    return std::isfinite(length);
}

}  // namespace

std::vector<std::uint32_t> triangulate(Mode mode, const std::vector<std::uint32_t>& indices)
{
    std::vector<std::uint32_t> triangles;
    if (mode == Mode::triangles) {
        triangles.assign(indices.begin(),
                         indices.end() - static_cast<std::ptrdiff_t>(indices.size() % 3));
        return triangles;
    }
    const std::size_t count = indices.size() < 3 ? 0 : indices.size() - 2;
    triangles.reserve(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        if (mode == Mode::triangle_strip) {
            triangles.insert(triangles.end(),
                             {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
        } else {
            triangles.insert(triangles.end(), {indices[i + 1], indices[i + 2], indices[0]});
        }
    }
    return triangles;
}

void drop_unused_vertices(Mesh& mesh)
{
    std::vector<std::uint32_t> new_index(mesh.positions.size(), kUnused);
    for (const std::uint32_t index : mesh.indices) new_index[index] = 0;
    std::uint32_t count = 0;
    for (std::uint32_t& index : new_index) {
        if (index != kUnused) index = count++;
    }
    if (count == new_index.size()) return;
    keep(mesh.positions, new_index, count);
    keep(mesh.normals, new_index, count);
    keep(mesh.colors, new_index, count);
    for (std::uint32_t& index : mesh.indices) index = new_index[index];
}

std::size_t repair_normals(Mesh& mesh)
{
    std::vector<std::uint32_t> broken;
    std::vector<Double3> sums;  // made when the first broken one is met
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const Float3& n = mesh.normals[i];
        const bool finite = std::isfinite(n[0]) && std::isfinite(n[1]) && std::isfinite(n[2]);
        const Double3 wide = {n[0], n[1], n[2]};
        if (!finite || !normalize(wide, mesh.normals[i])) {
            broken.push_back(static_cast<std::uint32_t>(i));
        }
    }
    if (broken.empty()) return 0;
    sums.resize(mesh.positions.size());
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
        const std::uint32_t* v = &mesh.indices[t];
        const Double3 normal =
            cross_of_edges(mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            for (std::size_t k = 0; k < 3; ++k) sums[v[corner]][k] += normal[k];
        }
    }
    for (const std::uint32_t i : broken) {
        // A vertex of nothing but degenerate triangles is not seen: any normal serves.
        if (!normalize(sums[i], mesh.normals[i])) mesh.normals[i] = {0, 1, 0};
    }
    return broken.size();
}

}  // namespace sheer::gltf
