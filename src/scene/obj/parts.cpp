// OBJ numbers positions, texture coordinates and normals apart; a mesh has one vertex for each
// triple of them that occurs.
#include "scene/obj/parts.h"

#include <algorithm>
#include <utility>

#include "scene/gltf/directions.h"

namespace sheer::obj {

std::size_t Parts::number_of(const PartKey& key)
{
    const auto [entry, is_new] = numbers_.try_emplace(key, parts_.size());
    if (is_new) parts_.push_back({key, static_cast<std::uint32_t>(parts_.size() + 1), {}, {}});
    return entry->second;
}

Mesh to_mesh(Part& part, const Attributes& attributes, Notes& notes)
{
    const std::vector<Triple>& corners = part.corners.triples();
    const auto any = [&](std::size_t which) {
        return std::any_of(corners.begin(), corners.end(),
                           [which](const Triple& corner) { return corner[which] != 0; });
    };
    // Lines and points face the camera.
    const bool normals = part.key.topology == Topology::triangles && any(2);
    const bool texcoords = any(1);
    const bool colors = !attributes.colors.empty();

    Mesh mesh;
    mesh.topology = part.key.topology;
    mesh.indices = std::move(part.indices);
    mesh.positions.reserve(corners.size());
    if (normals) mesh.normals.reserve(corners.size());
    if (texcoords) mesh.texcoords[0].reserve(corners.size());
    if (colors) mesh.colors.reserve(corners.size());
    for (const auto& [position, texcoord, normal] : corners) {
        mesh.positions.push_back(attributes.positions[position - 1]);
        if (normals) {
            mesh.normals.push_back(normal == 0 ? Float3{} : attributes.normals[normal - 1]);
        }
        if (texcoords) {
            mesh.texcoords[0].push_back(texcoord == 0 ? Float2{}
                                                      : attributes.texcoords[texcoord - 1]);
        }
        if (colors) mesh.colors.push_back(attributes.colors[position - 1]);
    }
    part.corners = {};
    // Makes those that are missing.
    gltf::repair_normals(mesh, notes);
    return mesh;
}

}  // namespace sheer::obj
