// Animations (glTF 2.0, section 3.11): where nodes are, and how far meshes are morphed, at a time.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "scene/gltf/matrix.h"

namespace sheer::gltf {

struct Import;

// What an animation says of a node, in place of what the node says itself.
struct NodePose {
    std::optional<std::array<double, 3>> translation = {}, scale = {};
    std::optional<std::array<double, 4>> rotation = {};  // a unit quaternion
    std::optional<std::vector<double>> weights = {};

    bool moves() const { return translation || scale || rotation; }
    void replace(Placement& placement) const  // what it says
    {
        if (translation) placement.translation = *translation;
        if (scale) placement.scale = *scale;
        if (rotation) placement.rotation = *rotation;
    }
};

using Poses = std::map<std::size_t, NodePose>;  // by node

// Those of LoadOptions::animation at LoadOptions::time; none without a time.
Poses read_poses(Import& import);

}  // namespace sheer::gltf
