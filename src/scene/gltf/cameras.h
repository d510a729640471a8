// Cameras, each where a node of the scene puts it.
#pragma once

#include <vector>

#include "scene/gltf/import.h"
#include "scene/gltf/nodes.h"

namespace sheer::gltf {

// One Camera for each node that has one, in the nodes' order, under the camera's name or, where it
// has none, the node's.
void place_cameras(Import& import, const std::vector<PlacedNode>& nodes);

}  // namespace sheer::gltf
