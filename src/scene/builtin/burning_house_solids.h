// What stands in the scene burning-house.
#pragma once

#include <sheer/scene.h>

namespace sheer {

// Opaque: timbered walls, a roof that has burnt open, glowing windows.
void add_house(Scene& scene);

// Three bottles on a stone; their labels are opaque, and blended as the glass is.
void add_bottles(Scene& scene, double glass_opacity);

}  // namespace sheer
