// Chooses what is drawn of each object.
#include "geometry/drawn_objects.h"

#include <map>

#include "geometry/ribbons.h"
#include "geometry/tangents.h"

namespace sheer {

DrawnObjects::DrawnObjects(const Scene& scene, const Projection& projection, int height)
{
    // By the mesh and its set of coordinates.
    std::map<std::pair<std::uint32_t, std::size_t>, const std::vector<Float4>*> tangents_of;
    const auto tangents = [&](const Object& object) -> const std::vector<Float4>* {
        const Mesh& mesh = scene.meshes[object.mesh];
        const auto& texture = material_of(scene, object).normal_texture;
        if (!texture) return nullptr;
        if (!mesh.tangents.empty()) return &mesh.tangents;
        if (mesh.texcoords[texture->set].empty()) return nullptr;
        const auto [entry, is_new] = tangents_of.try_emplace({object.mesh, texture->set}, nullptr);
        if (is_new) {
            tangents_.push_back(make_tangents(mesh, texture->set));
            entry->second = &tangents_.back();
        }
        return entry->second;
    };
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        if (mesh.topology == Topology::triangles) {
            objects_.push_back({&mesh, object.transform, material_of(scene, object).double_sided,
                                tangents(object)});
            continue;
        }
        const RibbonView view{projection, height};
        made_.push_back(mesh.topology == Topology::lines
                            ? make_ribbons(mesh, object.transform, view)
                            : make_squares(mesh, object.transform, view));
        objects_.push_back({&made_.back(), kIdentity, true, nullptr});
    }
}

}  // namespace sheer
