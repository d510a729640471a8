// The nodes of a file's scene, each with its place in the world.
#pragma once

#include <optional>
#include <vector>

#include "scene/gltf/import.h"
#include "scene/gltf/matrix.h"

namespace sheer::gltf {

struct PlacedNode {
    std::size_t number;  // in the file's list
    Matrix world;
    std::int32_t parent;  // among the placed nodes; -1: none
    // To the space of what moves as one: of the nearest node among this and those above that an
    // animation moves. None: nothing does.
    std::optional<Matrix> whole = std::nullopt;
};

// The default scene's nodes, a node before its children, children in their order.
std::vector<PlacedNode> place_nodes(Import& import);

}  // namespace sheer::gltf
