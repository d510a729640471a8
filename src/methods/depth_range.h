// How depth becomes the place of shaders/sheer/transmittance.glsl.
#pragma once

#include "methods/method.h"

namespace sheer {

struct DepthRange {
    bool is_distance;  // depth is the distance, not -1 / distance
    float from, scale;
};

// From near to far: of what is transparent in the picture, where that is known, or of the camera.
DepthRange depth_range(const EyeSpace& eye, bool of_drawn);

// By the parameter `range`: `drawn` or `planes`.
DepthRange depth_range(const StoreShape& shape);

}  // namespace sheer
