// Nodes with meshes (glTF 2.0, sections 3.5 and 3.7): which shape each has, and how often it is
// there.

#include "scene/gltf/objects.h"

#include <map>
#include <utility>

#include "scene/gltf/instances.h"
#include "scene/gltf/mesh.h"
#include "scene/gltf/morph.h"
#include "scene/gltf/skin.h"

namespace sheer::gltf {

namespace {

using Parts = std::vector<Part>;  // one for each primitive

Mat4 require_float(const Value& node, const Matrix& world)
{
    if (const auto matrix = to_float(world)) return *matrix;
    node.fail("its place in the world is infinite or not a number");
}

class ObjectLimits {
public:
    explicit ObjectLimits(const LoadOptions& options) : options_(options) {}

    void count(const Value& node, const Mesh& mesh)
    {
        if (++objects_ > options_.most_objects) {
            node.fail("more objects than --most-objects allows (" +
                      std::to_string(options_.most_objects) + ")");
        }
        triangles_ += mesh.indices.size() / 3;
        if (triangles_ > options_.most_triangles) {
            node.fail("more triangles, each node's counted, than --most-triangles allows (" +
                      std::to_string(options_.most_triangles) + ")");
        }
    }

    // Meshes are read again for other weights and for skins, whether anything of them is drawn.
    void count_read(const Value& node, const Value& mesh)
    {
        primitives_ += mesh.member("primitives").size();
        if (primitives_ > options_.most_objects) {
            node.fail(
                "more primitives, for each set of weights and each skin, than "
                "--most-objects allows (" +
                std::to_string(options_.most_objects) + ")");
        }
    }

private:
    const LoadOptions& options_;
    std::uint64_t objects_ = 0, primitives_ = 0;
    std::uint64_t triangles_ = 0;
};

class Objects {
public:
    Objects(Import& import, const std::vector<PlacedNode>& nodes)
        : import_(import), worlds_(import.document.count("nodes"), nullptr), limits_(import.options)
    {
        for (const PlacedNode& placed : nodes) worlds_[placed.number] = &placed.world;
    }

    void place(const PlacedNode& placed)
    {
        const Value node = import_.document.item("nodes", placed.number);
        const auto reference = node.find("mesh");
        if (!reference) return;
        const std::size_t mesh = import_.document.index_in("meshes", *reference);
        const auto instances = read_instances(import_, node);
        if (const Skin* skin = skin_of(node)) {
            if (instances) import_.notes.add("nodes with a skin and instances", "drawn once");
            std::vector<double> own;
            const Shape shape = {weights_of(placed.number, mesh, own), skin,
                                 determinant(placed.world) < 0};
            limits_.count_read(node, import_.document.item("meshes", mesh));
            const Parts parts = read_mesh(import_, import_.document.item("meshes", mesh), shape);
            add(node, placed.parent, parts, {kIdentityMatrix, std::nullopt});
            return;
        }
        const Parts& parts = shared_parts(placed.number, mesh);
        if (!instances) add(node, placed.parent, parts, {placed.world, placed.whole});
        for (std::size_t i = 0; instances && i < instances->size(); ++i) {
            const Matrix& own = (*instances)[i];
            Where where{multiply(placed.world, own), std::nullopt};
            if (placed.whole) where.whole = multiply(*placed.whole, own);
            add(node, placed.parent, parts, where);
        }
    }

private:
    struct Where {
        Matrix world;
        std::optional<Matrix> whole;
    };

    void add(const Value& node, std::int32_t group, const Parts& parts, const Where& where)
    {
        Scene& scene = import_.scene;
        for (const Part& part : parts) {
            limits_.count(node, scene.meshes[part.mesh]);
            Object object;
            object.name = name_of(node);
            object.group = group;
            object.mesh = part.mesh;
            object.material = part.material;
            object.mesh_name = part.mesh_name;
            object.transform = require_float(node, where.world);
            if (where.whole) object.to_whole = require_float(node, *where.whole);
            object.id = static_cast<std::uint32_t>(scene.objects.size());
            scene.objects.push_back(std::move(object));
        }
    }

    // Those that an animation gives, or null.
    const std::vector<double>* posed_weights(std::size_t node) const
    {
        const auto pose = import_.poses.find(node);
        const bool is_posed = pose != import_.poses.end() && pose->second.weights;
        return is_posed ? &*pose->second.weights : nullptr;
    }

    // An animation's, else the node's, which `own` then holds, else the mesh's, which are read
    // once.
    const std::vector<double>& weights_of(std::size_t number, std::size_t mesh,
                                          std::vector<double>& own)
    {
        if (const auto* posed = posed_weights(number)) return *posed;
        const Value node = import_.document.item("nodes", number);
        if (node.find("weights")) return own = morph_weights(node);
        const auto [entry, is_new] = mesh_weights_.try_emplace(mesh);
        if (is_new) entry->second = morph_weights(import_.document.item("meshes", mesh));
        return entry->second;
    }

    const Parts& shared_parts(std::size_t node_number, std::size_t number)
    {
        const Value node = import_.document.item("nodes", node_number);
        const bool is_plain = !node.find("weights") && posed_weights(node_number) == nullptr;
        if (const auto known = plain_parts_.find(number); is_plain && known != plain_parts_.end())
            return *known->second;
        const Value mesh = import_.document.item("meshes", number);
        std::vector<double> own;
        const auto [entry, is_new] =
            parts_.try_emplace({number, weights_of(node_number, number, own)});
        if (is_new) {
            limits_.count_read(node, mesh);
            entry->second = read_mesh(import_, mesh, {.weights = entry->first.second});
        }
        if (is_plain) plain_parts_[number] = &entry->second;
        return entry->second;
    }

    // Null when there is none that can be used.
    const Skin* skin_of(const Value& node)
    {
        const auto reference = node.find("skin");
        if (!reference) return nullptr;
        const std::size_t number = import_.document.index_in("skins", *reference);
        if (!skins_.contains(number)) {
            skins_[number] = read_skin(import_, import_.document.item("skins", number), worlds_);
        }
        return skins_[number] ? &*skins_[number] : nullptr;
    }

    Import& import_;
    std::vector<const Matrix*> worlds_;  // by the file's nodes
    // Of meshes by their numbers, with weights.
    std::map<std::pair<std::size_t, std::vector<double>>, Parts> parts_;
    std::map<std::size_t, const Parts*> plain_parts_;  // with the meshes' own weights
    std::map<std::size_t, std::vector<double>> mesh_weights_;
    std::map<std::size_t, std::optional<Skin>> skins_;
    ObjectLimits limits_;
};

}  // namespace

void place_objects(Import& import, const std::vector<PlacedNode>& nodes)
{
    for (const PlacedNode& placed : nodes) {
        import.scene.groups.push_back(
            {name_of(import.document.item("nodes", placed.number)), placed.parent});
    }
    Objects objects(import, nodes);
    for (const PlacedNode& placed : nodes) objects.place(placed);
}

}  // namespace sheer::gltf
