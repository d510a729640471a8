// Meshes that are compressed as a whole: KHR_draco_mesh_compression.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/accessor.h"
#include "scene/gltf/import.h"

namespace sheer::gltf {

struct DracoAttribute {
    Bytes bytes;
    Accessor accessor;  // of these bytes
};

struct DracoMesh {
    std::vector<std::uint32_t> indices;  // three for each triangle, all below the vertices' number
    std::map<std::string, DracoAttribute> attributes;
};

// Nothing when the primitive is not compressed.
std::optional<DracoMesh> decode_draco(Import& import, const Value& primitive);

}  // namespace sheer::gltf
