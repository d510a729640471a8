// What a primitive says of its vertices, as it stands in the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/accessor.h"
#include "scene/gltf/draco.h"
#include "scene/gltf/import.h"

namespace sheer::gltf {

// Where a primitive's vertices come from. Lives while they are read.
struct VertexSource {
    Import& import;
    Value primitive;
    Value attributes;
    std::optional<DracoMesh> draco;  // where it has an attribute, the file's accessors have no say
    // Of the vertices in the file, where the primitive uses few of them: those that it reads, and
    // its indices into these. Else all are read, and the indices when they are needed.
    std::optional<Places> chosen = {};
    std::vector<std::uint32_t> order = {};
    std::size_t count = 0;  // of vertices that are read, once positions are
    std::size_t total = 0;  // and of those in the file

    const Places* places() const { return chosen ? &*chosen : nullptr; }
    std::size_t number_of(std::size_t vertex) const { return place_of(places(), vertex); }
};

// The primitive must have POSITION. Its indices are read where it uses but a part of the vertices:
// the time that it takes is that of the vertices that are used.
VertexSource open_vertices(Import& import, const Value& primitive);

// Nothing when there is no such attribute; else one of as many elements as there are positions.
std::optional<Accessor> open_attribute(const VertexSource& source, const std::string& name);

// Positions, normals, colours, texture coordinates and tangents. Normals and tangents may have any
// length still, or none.
void read_vertices(VertexSource& source, Mesh& mesh);

// The primitive's indices, or 0, 1, 2, ... where it has none.
std::vector<std::uint32_t> read_vertex_order(const VertexSource& source);

// Fails with the number of the first vertex of which a component is infinite or not a number.
template <std::size_t N>
void require_finite(const Accessor& accessor, const std::vector<std::array<float, N>>& elements);

extern template void require_finite(const Accessor&, const std::vector<Float3>&);
extern template void require_finite(const Accessor&, const std::vector<Float4>&);

}  // namespace sheer::gltf
