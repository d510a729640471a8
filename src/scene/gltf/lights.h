// Lights, each where a node of the scene puts it.
#pragma once

#include <vector>

#include "scene/gltf/import.h"
#include "scene/gltf/nodes.h"

namespace sheer::gltf {

// One Light for each node that has one, in the nodes' order. Where there are any, the sun that the
// scene would have without them is put out; the sky stays.
void place_lights(Import& import, const std::vector<PlacedNode>& nodes);

}  // namespace sheer::gltf
