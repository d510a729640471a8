// glTF 2.0, section 3.7.2.1: the order of vertices in loops, strips and fans is its formula.

#include "scene/gltf/topology.h"

#include <algorithm>

namespace sheer::gltf {

namespace {

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

// How many triangles, lines or points there are.
std::size_t count_of(Mode mode, std::size_t vertices)
{
    switch (mode) {
        case Mode::points: return vertices;
        case Mode::lines: return vertices / 2;
        case Mode::line_loop: return vertices < 2 ? 0 : vertices;
        case Mode::line_strip: return vertices < 2 ? 0 : vertices - 1;
        case Mode::triangles: return vertices / 3;
        case Mode::triangle_strip:
        case Mode::triangle_fan: break;
    }
    return vertices < 3 ? 0 : vertices - 2;
}

}  // namespace

Topology topology_of(Mode mode)
{
    if (mode == Mode::points) return Topology::points;
    return mode < Mode::triangles ? Topology::lines : Topology::triangles;
}

std::vector<std::uint32_t> plain_indices(Mode mode, const std::vector<std::uint32_t>& indices)
{
    const std::size_t count = count_of(mode, indices.size());
    std::vector<std::uint32_t> plain;
    plain.reserve(count * vertices_of_one(topology_of(mode)));
    const auto add = [&](std::initializer_list<std::size_t> places) {
        for (const std::size_t place : places) plain.push_back(indices[place]);
    };
    for (std::size_t i = 0; i < count; ++i) {
        switch (mode) {
            case Mode::points: add({i}); break;
            case Mode::lines: add({2 * i, 2 * i + 1}); break;
            case Mode::line_loop: add({i, (i + 1) % count}); break;
            case Mode::line_strip: add({i, i + 1}); break;
            case Mode::triangles: add({3 * i, 3 * i + 1, 3 * i + 2}); break;
            case Mode::triangle_strip: add({i, i + 1 + i % 2, i + 2 - i % 2}); break;
            case Mode::triangle_fan: add({i + 1, i + 2, 0}); break;
        }
    }
    return plain;
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
    keep(mesh.tangents, new_index, count);
    for (auto& set : mesh.texcoords) keep(set, new_index, count);
    for (std::uint32_t& index : mesh.indices) index = new_index[index];
}

}  // namespace sheer::gltf
