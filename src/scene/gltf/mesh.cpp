// Meshes and their primitives (glTF 2.0, section 3.7.2).
//
// A primitive without normals keeps none: the scene means flat normals by that, which is what glTF
// asks for. Other attributes (tangents, texture coordinates, joints) are not read.

#include "scene/gltf/mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/gltf/accessor.h"
#include "scene/gltf/materials.h"
#include "scene/gltf/triangles.h"

namespace sheer::gltf {

namespace {

Mode read_mode(const Value& primitive)
{
    const std::uint64_t mode =
        whole_or(primitive, "mode", static_cast<std::uint64_t>(Mode::triangles));
    if (mode > static_cast<std::uint64_t>(Mode::triangle_fan)) {
        primitive.member("mode").fail("there is no mode " + std::to_string(mode));
    }
    return static_cast<Mode>(mode);
}

template <std::size_t N>
void require_finite(const Value& where, const std::vector<std::array<float, N>>& elements)
{
    for (std::size_t i = 0; i < elements.size(); ++i) {
        for (const float component : elements[i]) {
            if (!std::isfinite(component)) {
                where.fail("vertex " + std::to_string(i) + " is infinite or not a number");
            }
        }
    }
}

// An attribute of `width` components, as many elements as the mesh has positions.
std::optional<Accessor> open_attribute(Import& import, const Mesh& mesh,
                                       const std::optional<Value>& reference)
{
    if (!reference) return std::nullopt;
    Accessor accessor = open_accessor(import, *reference);
    if (accessor.count != mesh.positions.size()) {
        reference->fail("has " + std::to_string(accessor.count) + " elements, POSITION has " +
                        std::to_string(mesh.positions.size()));
    }
    return accessor;
}

void read_positions(Import& import, const Value& reference, Mesh& mesh)
{
    const Accessor accessor = open_accessor(import, reference);
    if (accessor.width != 3) accessor.value.fail("POSITION must be VEC3");
    mesh.positions = read_vectors<3>(accessor);
    require_finite(accessor.value, mesh.positions);
}

void read_normals(Import& import, const Value& attributes, Mesh& mesh)
{
    const auto accessor = open_attribute(import, mesh, attributes.find("NORMAL"));
    if (!accessor) return;
    if (accessor->width != 3) accessor->value.fail("NORMAL must be VEC3");
    mesh.normals = read_vectors<3>(*accessor);
}

void read_colors(Import& import, const Value& attributes, Mesh& mesh)
{
    const auto accessor = open_attribute(import, mesh, attributes.find("COLOR_0"));
    if (!accessor) return;
    const bool is_integer = accessor->component != ComponentType::float32;
    if ((accessor->width != 3 && accessor->width != 4) || (is_integer && !accessor->normalized)) {
        accessor->value.fail("COLOR_0 must be VEC3 or VEC4 of floats or normalized integers");
    }
    mesh.colors = read_vectors<4>(*accessor, 1.0f);
    require_finite(accessor->value, mesh.colors);
    for (Float4& color : mesh.colors) {
        for (float& component : color) component = std::clamp(component, 0.0f, 1.0f);
    }
}

std::vector<std::uint32_t> read_or_count_indices(Import& import, const Value& primitive,
                                                 std::size_t vertex_count)
{
    if (const auto reference = primitive.find("indices")) {
        return read_indices(open_accessor(import, *reference), vertex_count);
    }
    std::vector<std::uint32_t> indices(vertex_count);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

// Its accessors may be empty where the compressed data is meant to fill them.
void refuse_compressed(const Import& import, const Value& primitive, const Value& position)
{
    constexpr std::string_view draco = "KHR_draco_mesh_compression";
    const bool is_empty = !import.document.item("accessors", position).find("bufferView");
    if (is_empty && extension(primitive, draco)) {
        primitive.fail("the extension " + std::string(draco) + " is not supported");
    }
}

Mesh read_triangles(Import& import, const Value& primitive, const Value& position)
{
    const Value attributes = primitive.member("attributes");
    Mesh mesh;
    refuse_compressed(import, primitive, position);
    read_positions(import, position, mesh);
    read_normals(import, attributes, mesh);
    read_colors(import, attributes, mesh);
    const auto indices = read_or_count_indices(import, primitive, mesh.positions.size());
    mesh.indices = triangulate(read_mode(primitive), indices);
    if (mesh.indices.empty() ||
        (read_mode(primitive) == Mode::triangles && indices.size() % 3 != 0)) {
        import.notes.add("primitives with vertices left over", "which make no triangle");
    }
    drop_unused_vertices(mesh);
    if (const std::size_t broken = repair_normals(mesh); broken != 0) {
        import.notes.add("normals without a direction", "made from their triangles", broken);
    }
    mesh.material = material_of(import, primitive);
    return mesh;
}

}  // namespace

std::vector<std::uint32_t> read_mesh(Import& import, const Value& mesh)
{
    std::vector<std::uint32_t> numbers;
    const Value primitives = mesh.member("primitives");
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const Value primitive = primitives[i];
        const Mode mode = read_mode(primitive);
        const auto position = primitive.member("attributes").find("POSITION");
        note_extensions(import, primitive, "primitives");
        if (primitive.find("targets")) {
            import.notes.add("primitives with morph targets", "drawn in their base shape");
        }
        if (mode == Mode::points) {
            import.notes.add("primitives of points", "not drawn");
        } else if (mode < Mode::triangles) {
            import.notes.add("primitives of lines", "not drawn");
        } else if (!position) {
            import.notes.add("primitives without POSITION", "not drawn");
        } else {
            Mesh triangles = read_triangles(import, primitive, *position);
            if (triangles.indices.empty()) continue;
            triangles.name = name_of(mesh);
            numbers.push_back(static_cast<std::uint32_t>(import.scene.meshes.size()));
            import.scene.meshes.push_back(std::move(triangles));
        }
    }
    return numbers;
}

}  // namespace sheer::gltf
