// Trees: wood as tubes, leaves as cards on the twigs.
#pragma once

#include <vector>

#include <sheer/scene.h>

#include "scene/builtin/shapes.h"

namespace sheer {

struct TreeJob {
    shapes::Vec foot;
    double height = 8;       // metres, about
    int levels = 4;          // of branches, the trunk counted
    std::uint32_t kind = 1;  // another number, another tree
    int cards = 1000;        // leaves or twigs of leaves
    double card_size = 0.3;  // metres
    shapes::Vec wind = {};   // bends branches, more the thinner they are
};

// Adds to both meshes; the wood is white.
void add_tree(Mesh& wood, Mesh& leaves, const TreeJob& job);

}  // namespace sheer
