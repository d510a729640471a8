// What passes from a light to a point: every triangle of the scene, one after the other
// (docs/numerics.md, "Shadows"). Lines and points are left out.
#pragma once

#include <cstddef>
#include <limits>

#include <sheer/scene.h>

#include "reference/mipmap.h"
#include "reference/vector.h"

namespace sheer::reference {

// A way through the scene, from a point to the light.
struct LightWay {
    Vec3 from, to_light;  // world space; the second of unit length
    double least = 0;     // metres from the point on; nearer surfaces don't count
    double most = std::numeric_limits<double>::infinity();
    // The triangle that the point is on, which doesn't count either.
    std::size_t own_object = ~std::size_t{0}, own_triangle = 0;
};

// Of each channel, the part that arrives.
Vec3 light_along(const Scene& scene, const Textures& textures, const LightWay& way);

}  // namespace sheer::reference
