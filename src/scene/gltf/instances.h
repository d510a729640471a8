// Many copies of a node's mesh: EXT_mesh_gpu_instancing.
#pragma once

#include <optional>
#include <vector>

#include "scene/gltf/import.h"
#include "scene/gltf/matrix.h"

namespace sheer::gltf {

// Where each of the node's copies stands, seen from the node; at most LoadOptions::most_objects.
// Nothing where the node is not one of many.
std::optional<std::vector<Matrix>> read_instances(Import& import, const Value& node);

}  // namespace sheer::gltf
