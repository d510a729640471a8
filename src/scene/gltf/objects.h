// What the nodes of the scene show.
#pragma once

#include <vector>

#include "scene/gltf/import.h"
#include "scene/gltf/nodes.h"

namespace sheer::gltf {

// One Object for each primitive of each node's mesh and each of the node's instances, numbered in
// that order. Objects share a Mesh where they have the same shape; one with a skin has a Mesh of
// its own, in the world.
void place_objects(Import& import, const std::vector<PlacedNode>& nodes);

}  // namespace sheer::gltf
