// Light as it arrives at a point: the sun, the sky and a scene's lights (docs/numerics.md,
// "Lights"; KHR_lights_punctual).
#pragma once

#include <vector>

#include <sheer/scene.h>

#include "reference/vector.h"

namespace sheer::reference {

// From one light.
struct Arrival {
    Vec3 to_light;    // unit length; zero at the light itself
    Vec3 irradiance;  // of a surface that faces it
};

// From the sun: docs/numerics.md, "Lights".
Arrival arrival_from(const Sun& sun);

// At a place in the world, inverse squares, ranges and cones included: docs/numerics.md, "Lights".
Arrival arrival_from(const Light& light, const Vec3& position);

// From the sun and all lights of the scene.
std::vector<Arrival> arrivals_at(const Scene& scene, const Vec3& position);

// Radiance of a white Lambertian surface under the sky, halfway between up and down where the
// normal is zero: docs/numerics.md, "Diffuse".
Vec3 sky_radiance(const Sky& sky, const Vec3& normal);

}  // namespace sheer::reference
