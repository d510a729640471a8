// Reads a glTF 2.0 scene: the stages, in order. Each stands in a file of its own beside this one.
//
// Khronos Group. glTF 2.0 Specification, version 2.0.1, 2021.
// https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
//
// Files are taken as strangers' work: every fault in them ends in an Error that says where, and
// what they ask for in memory is bounded by their own size or by a stated limit.

#include "scene/gltf.h"

#include <new>

#include <sheer/error.h>

#include "scene/gltf/cameras.h"
#include "scene/gltf/images.h"
#include "scene/gltf/import.h"
#include "scene/gltf/lights.h"
#include "scene/gltf/materials.h"
#include "scene/gltf/nodes.h"
#include "scene/gltf/objects.h"

namespace sheer {

namespace {

Scene read_document(const std::string& path, Bytes content, const LoadOptions& options)
{
    gltf::Import import{.document = gltf::Document(path, std::move(content)), .options = options};
    check_asset(import.document);
    read_materials(import);
    import.poses = read_poses(import);
    const std::vector<gltf::PlacedNode> nodes = place_nodes(import);
    place_objects(import, nodes);
    place_cameras(import, nodes);
    place_lights(import, nodes);
    load_images(import);
    if (!options.time) {
        import.notes.add("animations", "not played", import.document.count("animations"));
    }
    import.scene.ignored = import.notes.lines();
    return std::move(import.scene);
}

}  // namespace

Scene read_gltf(const std::string& path, const LoadOptions& options)
{
    return read_gltf(path, read_file(path), options);
}

Scene read_gltf(const std::string& path, Bytes content, const LoadOptions& options)
{
    try {
        return read_document(path, std::move(content), options);
    } catch (const std::bad_alloc&) {
        throw Error(Fault::work, path + ": there is not enough memory to read it");
    }
}

}  // namespace sheer
