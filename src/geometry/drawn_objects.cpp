// Chooses what is drawn of each object.
#include "geometry/drawn_objects.h"

#include <map>

#include "geometry/ribbons.h"
#include "geometry/tangents.h"

namespace sheer {

DrawnObjects::DrawnObjects(const Scene& scene, const Projection& projection, int height)
{
    std::map<std::uint32_t, const std::vector<Float4>*> tangents_of;  // by mesh
    const auto tangents = [&](std::uint32_t number) -> const std::vector<Float4>* {
        const Mesh& mesh = scene.meshes[number];
        const auto& texture = scene.materials[mesh.material].normal_texture;
        if (!texture) return nullptr;
        if (!mesh.tangents.empty()) return &mesh.tangents;
        if (mesh.texcoords[texture->set].empty()) return nullptr;
        const auto known = tangents_of.find(number);
        if (known != tangents_of.end()) return known->second;
        tangents_.push_back(make_tangents(mesh, texture->set));
        return tangents_of[number] = &tangents_.back();
    };
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        if (mesh.topology == Topology::triangles) {
            objects_.push_back({&mesh, object.transform,
                                scene.materials[mesh.material].double_sided,
                                tangents(object.mesh)});
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
