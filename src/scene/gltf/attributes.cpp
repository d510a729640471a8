// Vertex attributes (glTF 2.0, section 3.7.2.1). Integers are taken for every attribute that
// KHR_mesh_quantization allows them for, whether the file names it or not.

#include "scene/gltf/attributes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sheer::gltf {

namespace {

Accessor open(const VertexSource& source, const std::string& name, const Value& reference)
{
    if (source.draco) {
        const auto decoded = source.draco->attributes.find(name);
        if (decoded != source.draco->attributes.end()) return decoded->second.accessor;
    }
    return open_accessor(source.import, reference, source.places());
}

// Sorting the indices costs less than reading more than a few times as many vertices.
constexpr std::size_t kFew = 4;

void choose_vertices(VertexSource& source)
{
    const auto indices = source.primitive.find("indices");
    if (source.draco || !indices) return;
    Import& import = source.import;
    const Value position = import.document.item("accessors", source.attributes.member("POSITION"));
    const std::uint64_t vertices = position.member("count").whole();
    if (vertices > UINT32_MAX) return;  // which is refused soon
    const std::uint64_t used = import.document.item("accessors", *indices).member("count").whole();
    if (used >= vertices / kFew) return;
    source.order =
        read_indices(open_accessor(import, *indices), static_cast<std::size_t>(vertices));
    Places& chosen = source.chosen.emplace(source.order);
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    for (std::uint32_t& index : source.order) {
        const auto found = std::lower_bound(chosen.begin(), chosen.end(), index);
        index = static_cast<std::uint32_t>(found - chosen.begin());
    }
}

void read_positions(VertexSource& source, Mesh& mesh)
{
    const Accessor accessor = open(source, "POSITION", source.attributes.member("POSITION"));
    if (accessor.width != 3) accessor.value.fail("POSITION must be VEC3");
    mesh.positions = read_vectors<3>(accessor);
    require_finite(accessor, mesh.positions);
    source.count = mesh.positions.size();
    source.total = accessor.total;
}

void read_normals(const VertexSource& source, Mesh& mesh)
{
    const auto accessor = open_attribute(source, "NORMAL");
    if (!accessor) return;
    if (accessor->width != 3) accessor->value.fail("NORMAL must be VEC3");
    mesh.normals = read_vectors<3>(*accessor);
}

void read_tangents(const VertexSource& source, Mesh& mesh)
{
    const auto accessor = open_attribute(source, "TANGENT");
    if (!accessor) return;
    if (accessor->width != 4) accessor->value.fail("TANGENT must be VEC4");
    mesh.tangents = read_vectors<4>(*accessor);
}

void read_colors(const VertexSource& source, Mesh& mesh)
{
    const auto accessor = open_attribute(source, "COLOR_0");
    if (!accessor) return;
    const bool is_integer = accessor->component != ComponentType::float32;
    if ((accessor->width != 3 && accessor->width != 4) || (is_integer && !accessor->normalized)) {
        accessor->value.fail("COLOR_0 must be VEC3 or VEC4 of floats or normalized integers");
    }
    mesh.colors = read_vectors<4>(*accessor, 1.0f);
    require_finite(*accessor, mesh.colors);
    for (Float4& color : mesh.colors) {
        for (float& component : color) component = std::clamp(component, 0.0f, 1.0f);
    }
}

void read_texcoords(const VertexSource& source, std::size_t set, Mesh& mesh)
{
    const std::string name = "TEXCOORD_" + std::to_string(set);
    const auto accessor = open_attribute(source, name);
    if (!accessor) return;
    if (accessor->width != 2) accessor->value.fail(name + " must be VEC2");
    mesh.texcoords[set] = read_vectors<2>(*accessor);
    // Exporters make such where a face has no area in the texture.
    std::size_t broken = 0;
    for (Float2& uv : mesh.texcoords[set]) {
        if (std::isfinite(uv[0]) && std::isfinite(uv[1])) continue;
        uv = {0, 0};
        ++broken;
    }
    source.import.notes.add("texture coordinates that are infinite or not a number", "taken as 0",
                            broken);
}

}  // namespace

template <std::size_t N>
void require_finite(const Accessor& accessor, const std::vector<std::array<float, N>>& elements)
{
    for (std::size_t i = 0; i < elements.size(); ++i) {
        for (const float component : elements[i]) {
            if (!std::isfinite(component)) {
                accessor.value.fail("vertex " + std::to_string(place_of(accessor.chosen, i)) +
                                    " is infinite or not a number");
            }
        }
    }
}

template void require_finite(const Accessor&, const std::vector<Float3>&);
template void require_finite(const Accessor&, const std::vector<Float4>&);

VertexSource open_vertices(Import& import, const Value& primitive)
{
    VertexSource source{.import = import,
                        .primitive = primitive,
                        .attributes = primitive.member("attributes"),
                        .draco = decode_draco(import, primitive)};
    choose_vertices(source);
    return source;
}

std::optional<Accessor> open_attribute(const VertexSource& source, const std::string& name)
{
    const auto reference = source.attributes.find(name);
    if (!reference) return std::nullopt;
    Accessor accessor = open(source, name, *reference);
    if (accessor.total != source.total) {
        reference->fail("has " + std::to_string(accessor.total) + " elements, POSITION has " +
                        std::to_string(source.total));
    }
    return accessor;
}

void read_vertices(VertexSource& source, Mesh& mesh)
{
    read_positions(source, mesh);
    read_normals(source, mesh);
    read_tangents(source, mesh);
    read_colors(source, mesh);
    for (std::size_t set = 0; set < std::size(mesh.texcoords); ++set) {
        read_texcoords(source, set, mesh);
    }
    if (source.attributes.find("TEXCOORD_2")) {
        source.import.notes.add("primitives with more than two sets of texture coordinates",
                                "the first two are read");
    }
    if (source.attributes.find("COLOR_1")) {
        source.import.notes.add("primitives with more than one set of colors", "the first is read");
    }
}

std::vector<std::uint32_t> read_vertex_order(const VertexSource& source)
{
    if (source.draco) return source.draco->indices;
    if (source.chosen) return source.order;
    if (const auto reference = source.primitive.find("indices")) {
        return read_indices(open_accessor(source.import, *reference), source.count);
    }
    std::vector<std::uint32_t> indices(source.count);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

}  // namespace sheer::gltf
