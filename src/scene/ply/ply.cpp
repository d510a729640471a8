// The stages in order: the header, the rows, a scene. The first two stand beside this file.
#include "scene/ply.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "scene/gltf/directions.h"
#include "scene/notes.h"
#include "scene/gltf/topology.h"
#include "scene/mesh_files.h"
#include "scene/ply/header.h"
#include "scene/ply/model.h"
#include "scene/polygon.h"
#include "scene/text_scanner.h"
#include "support/text.h"

namespace sheer {

namespace ply {
namespace {

// Splats as their training writes them, and SuperSplat's compressed ones.
bool holds_splats(const Header& header)
{
    const Element* vertex = header.find("vertex");
    if (vertex == nullptr) return false;
    for (const Property& property : vertex->properties) {
        if (property.name == "f_dc_0" || property.name == "packed_position") return true;
    }
    return false;
}

std::vector<std::uint32_t> all_of(const std::vector<Float3>& positions)
{
    std::vector<std::uint32_t> indices(positions.size());
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

Mesh edges_of(const Mesh& mesh, std::vector<std::uint32_t> lines)
{
    Mesh edges;
    edges.name = mesh.name + " edges";
    edges.topology = Topology::lines;
    edges.positions = mesh.positions;
    edges.colors = mesh.colors;
    edges.indices = std::move(lines);
    gltf::drop_unused_vertices(edges);
    return edges;
}

bool is_known(const Element& element)
{
    for (const char* name : {"vertex", "face", "tristrips", "edge"}) {
        if (element.name == name) return true;
    }
    return false;
}

void note_what_is_skipped(const Header& header, Notes& notes)
{
    constexpr std::size_t kMostShown = 40;  // of a name
    for (const Element& element : header.elements) {
        const std::string name = in_one_line(element.name, kMostShown);
        if (!is_known(element)) {
            notes.add("elements called " + name, "not read",
                      static_cast<std::size_t>(element.count));
            continue;
        }
        for (const Property& property : element.properties) {
            if (property.use != Use::none) continue;
            notes.add("property " + in_one_line(property.name, kMostShown) + " of each " + name,
                      "not read");
        }
    }
}

// Properties that only their full number makes something of.
void note_incomplete(const Header& header, Notes& notes)
{
    struct Group {
        const char* what;
        std::vector<Use> needed, given;
    };
    static const Group kGroups[] = {
        {"normals without nx, ny and nz", {Use::nx, Use::ny, Use::nz}, {}},
        {"colours without red, green and blue", {Use::red, Use::green, Use::blue}, {}},
        {"alpha without red, green and blue", {Use::red, Use::green, Use::blue}, {Use::alpha}},
        {"texture coordinates of which one is missing", {Use::u, Use::v}, {}}};
    const Element& vertex = *header.find("vertex");
    const auto has = [&](Use use) { return vertex.has(use); };
    for (const auto& [what, needed, given] : kGroups) {
        const std::vector<Use>& any = given.empty() ? needed : given;
        if (std::any_of(any.begin(), any.end(), has) &&
            !std::all_of(needed.begin(), needed.end(), has)) {
            notes.add(what, "not read");
        }
    }
}

Scene to_scene(const std::string& path, Model model, const Header& header)
{
    Scene scene;
    const std::string name = name_of_file(path);
    Mesh& mesh = model.faces;
    mesh.name = name;
    const auto add_material = [&](Topology topology) {
        Material material = plain_material(name, !mesh.colors.empty(), topology);
        if (model.transparent) material.alpha_mode = AlphaMode::blend;
        scene.materials.push_back(std::move(material));
        return static_cast<std::uint32_t>(scene.materials.size() - 1);
    };
    if (mesh.indices.empty()) {
        // Lines and points face the camera.
        mesh.normals = {};
        mesh.texcoords[0] = {};
        mesh.topology = model.lines.empty() ? Topology::points : Topology::lines;
        mesh.indices = model.lines.empty() ? all_of(mesh.positions) : std::move(model.lines);
    } else if (!model.lines.empty()) {
        Mesh edges = edges_of(mesh, std::move(model.lines));
        edges.material = add_material(Topology::lines);
        place_mesh(scene, std::move(edges));
    }
    gltf::drop_unused_vertices(mesh);
    mesh.material = add_material(mesh.topology);
    Notes notes;
    note_what_is_skipped(header, notes);
    note_incomplete(header, notes);
    notes.add("textures that a comment names", "drawn without", header.textures);
    notes.add("faces of fewer than 3 corners", "not drawn", model.short_faces);
    notes.add(kUncutPolygons, kUncutBecause, model.uncut);
    gltf::repair_normals(mesh, notes);
    scene.ignored = notes.lines();
    place_mesh(scene, std::move(mesh));
    return scene;
}

}  // namespace
}  // namespace ply

Scene read_ply(const std::string& path, const Bytes& content)
{
    const ply::Header header = ply::read_header(path, as_text(content));
    if (ply::holds_splats(header)) {
        fail_in_file(path, "Gaussian splats are not supported yet");
    }
    const ply::Element* vertex = header.find("vertex");
    if (vertex == nullptr || vertex->count == 0) fail_in_file(path, "the file holds no vertices");
    return ply::to_scene(path, ply::read_model(path, content, header), header);
}

}  // namespace sheer
