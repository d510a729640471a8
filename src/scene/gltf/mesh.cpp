// Meshes and their primitives (glTF 2.0, section 3.7.2).
//
// A primitive without normals keeps none: the scene means flat normals by that, which is what glTF
// asks for.

#include "scene/gltf/mesh.h"

#include <utility>

#include "scene/gltf/attributes.h"
#include "scene/gltf/directions.h"
#include "scene/gltf/materials.h"
#include "scene/gltf/morph.h"
#include "scene/gltf/topology.h"

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

void join_vertices(const VertexSource& source, Mesh& mesh)
{
    const Mode written = read_mode(source.primitive);
    if (source.draco && topology_of(written) != Topology::triangles) {
        source.primitive.fail("Draco meshes must be of triangles");
    }
    const Mode mode = source.draco ? Mode::triangles : written;  // which Draco makes of strips
    const auto order = read_vertex_order(source);
    mesh.topology = topology_of(mode);
    mesh.indices = plain_indices(mode, order);
    const std::size_t one = vertices_of_one(mesh.topology);
    const bool is_list = mode == Mode::triangles || mode == Mode::lines || mode == Mode::points;
    if (mesh.indices.empty() || (is_list && order.size() % one != 0)) {
        const std::string what = mesh.topology == Topology::lines ? "line" : "triangle";
        source.import.notes.add("primitives with vertices left over", "which make no " + what);
    }
}

// Where a node mirrors the world the other side of triangles is the front, even of those that a
// skin has put into the world already (glTF 2.0, section 3.7.4).
void turn_triangles(Mesh& mesh)
{
    if (mesh.topology != Topology::triangles) return;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
}

Mesh read_primitive(Import& import, const Value& primitive, const Shape& shape)
{
    VertexSource source = open_vertices(import, primitive);
    Mesh mesh;
    read_vertices(source, mesh);
    apply_morph(source, shape.weights, mesh);
    if (shape.skin != nullptr) apply_skin(source, *shape.skin, mesh);
    join_vertices(source, mesh);
    if (shape.mirrored) turn_triangles(mesh);
    drop_unused_vertices(mesh);
    repair_normals(mesh, import.notes);
    repair_tangents(mesh, import.notes);
    return mesh;
}

std::uint32_t material_for(Import& import, const Value& primitive, const Mesh& mesh)
{
    const std::uint32_t material = material_of(import, primitive);
    return mesh.topology == Topology::triangles ? material
                                                : material_of_line(import, mesh, material);
}

// Nothing where there is nothing to draw.
std::optional<Part> read_part(Import& import, const Value& primitive, const std::string& name,
                              const Shape& shape)
{
    auto& meshes = import.scene.meshes;
    const bool is_base = shape.weights.empty() && shape.skin == nullptr;
    const std::string json = is_base ? primitive.json_without("material") : "";
    if (const auto known = import.base_meshes.find(json); known != import.base_meshes.end()) {
        const Mesh& mesh = meshes[known->second];
        Part part{known->second, std::nullopt, std::nullopt};
        const std::uint32_t material = material_for(import, primitive, mesh);
        if (material != mesh.material) part.material = material;
        if (name != mesh.name) part.mesh_name = name;
        return part;
    }
    Mesh mesh = read_primitive(import, primitive, shape);
    if (mesh.indices.empty()) return std::nullopt;
    mesh.name = name;
    mesh.material = material_for(import, primitive, mesh);
    const auto number = static_cast<std::uint32_t>(meshes.size());
    meshes.push_back(std::move(mesh));
    if (is_base) import.base_meshes[json] = number;
    return Part{number, std::nullopt, std::nullopt};
}

}  // namespace

std::vector<Part> read_mesh(Import& import, const Value& mesh, const Shape& shape)
{
    std::vector<Part> parts;
    const std::string name = name_of(mesh);
    const Value primitives = mesh.member("primitives");
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const Value primitive = primitives[i];
        note_extensions(import, primitive, "primitives");
        if (!primitive.member("attributes").find("POSITION")) {
            import.notes.add("primitives without POSITION", "not drawn");
            continue;
        }
        if (auto part = read_part(import, primitive, name, shape)) parts.push_back(*part);
    }
    return parts;
}

}  // namespace sheer::gltf
