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
    mesh.material = material_of(import, primitive);
    if (mesh.topology != Topology::triangles) mesh.material = material_of_line(import, mesh);
    return mesh;
}

}  // namespace

std::vector<std::uint32_t> read_mesh(Import& import, const Value& mesh, const Shape& shape)
{
    std::vector<std::uint32_t> numbers;
    const Value primitives = mesh.member("primitives");
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const Value primitive = primitives[i];
        note_extensions(import, primitive, "primitives");
        if (!primitive.member("attributes").find("POSITION")) {
            import.notes.add("primitives without POSITION", "not drawn");
            continue;
        }
        Mesh read = read_primitive(import, primitive, shape);
        if (read.indices.empty()) continue;
        read.name = name_of(mesh);
        numbers.push_back(static_cast<std::uint32_t>(import.scene.meshes.size()));
        import.scene.meshes.push_back(std::move(read));
    }
    return numbers;
}

}  // namespace sheer::gltf
