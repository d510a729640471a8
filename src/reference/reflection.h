// What metallic-roughness surfaces reflect: docs/numerics.md, "Metallic-roughness" (glTF 2.0,
// appendix B).
#pragma once

#include <sheer/scene.h>

#include "reference/vector.h"

namespace sheer::reference {

struct Reflector {
    Vec3 normal;       // n, unit length
    Vec3 to_eye;       // v, unit length
    Vec3 diffuse;      // c_d: the colour of what is not reflected at the surface
    Vec3 specular;     // F0: what is reflected at the surface, seen straight on
    double roughness;  // r: perceptual, above 0
};

// The BRDF: (1 - F) c_d / pi + D V F, for light from the unit vector `to_light`. Zero where the
// light is behind the surface.
Vec3 reflectance(const Reflector& reflector, const Vec3& to_light);

// The radiance that the whole sky makes of it: S. Lagarde, "Adopting a physically based shading
// model", 2011, as docs/numerics.md has it.
Vec3 reflected_sky(const Reflector& reflector, const Sky& sky);

}  // namespace sheer::reference
