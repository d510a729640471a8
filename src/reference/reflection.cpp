// D: B. Walter et al., "Microfacet models for refraction through rough surfaces", 2007. V: E.
// Heitz, "Understanding the masking-shadowing function in microfacet-based BRDFs", 2014. F: C.
// Schlick, "An inexpensive BRDF model for physically-based rendering", 1994.
#include "reference/reflection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "reference/light.h"

namespace sheer::reference {

namespace {

using std::numbers::pi;

// Seen from the side, the surface is seen at this much of an angle.
constexpr double kLeastCosine = 1e-4;

double distribution(double a, const Vec3& n, const Vec3& h)
{
    const Vec3 across = cross(n, h);
    const double along = dot(n, h);
    const double d = dot(across, across) + a * a * along * along;
    return a * a / (pi * d * d);
}

double visibility(double a, double nl, double nv)
{
    const double a2 = a * a;
    return 0.5 /
           (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
}

double cosine_to_eye(const Reflector& reflector)
{
    return std::max(dot(reflector.normal, reflector.to_eye), kLeastCosine);
}

}  // namespace

Vec3 reflectance(const Reflector& reflector, const Vec3& to_light)
{
    const double nl = dot(reflector.normal, to_light);
    const Vec3 h = normalized(to_light + reflector.to_eye);
    if (nl <= 0) {
        return {0, 0, 0};
    }
    const double a = reflector.roughness * reflector.roughness;
    // A light exactly opposite to the eye has no halfway vector and makes no highlight.
    const bool has_half = dot(h, h) > 0;
    const double lobe = has_half ? distribution(a, reflector.normal, h) *
                                       visibility(a, nl, cosine_to_eye(reflector))
                                 : 0;
    const double grazing = std::pow(1 - dot(reflector.to_eye, h), 5);
    Vec3 result;
    for (std::size_t c = 0; c < 3; ++c) {
        const double f = reflector.specular[c] + (1 - reflector.specular[c]) * grazing;
        result[c] = (1 - f) * reflector.diffuse[c] / pi + lobe * f;
    }
    return result;
}

Vec3 reflected_sky(const Reflector& reflector, const Sky& sky)
{
    const double cosine = dot(reflector.normal, reflector.to_eye);
    const Vec3 mirrored = 2 * cosine * reflector.normal - reflector.to_eye;
    const double a = reflector.roughness * reflector.roughness;
    // A Lambertian surface's radiance has 2/3 of the sky's own slope.
    const double slope = (1.5 - a / 2) * mirrored[1];
    const double grazing = std::pow(1 - cosine_to_eye(reflector), 5);
    const Vec3 around = sky_radiance(sky, reflector.normal);
    const Vec3 up = to_vec3(sky.up);
    const Vec3 down = to_vec3(sky.down);
    Vec3 result;
    for (std::size_t c = 0; c < 3; ++c) {
        const double f0 = reflector.specular[c];
        const double r = f0 + (std::max(1 - reflector.roughness, f0) - f0) * grazing;
        const double seen = (up[c] + down[c]) / 2 + (up[c] - down[c]) / 2 * slope;
        result[c] = (1 - r) * reflector.diffuse[c] * around[c] + r * std::max(0.0, seen);
    }
    return result;
}

}  // namespace sheer::reference
