// One function for each kind of light.
#include "reference/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sheer::reference {

namespace {

// Nearer than a centimetre a light shines no brighter.
constexpr double kLeastSquaredDistance = 1e-4;  // square metres

// Cones whose edge is sharper are softened to it.
constexpr double kSharpestCone = 1e-3;  // difference of cosines

double in_range(double distance, double range)
{
    return range > 0 ? std::clamp(1 - std::pow(distance / range, 4), 0.0, 1.0) : 1;
}

double in_cone(const Light& light, const Vec3& to_light)
{
    const double outer = std::cos(double{light.outer_cone});
    const double inner = std::cos(double{light.inner_cone});
    const double cosine = dot(to_vec3(light.direction), -1.0 * to_light);
    const double q =
        std::clamp((cosine - outer) / std::max(inner - outer, kSharpestCone), 0.0, 1.0);
    return q * q;
}

}  // namespace

Arrival arrival_from(const Sun& sun)
{
    return {to_vec3(sun.to_light), std::numbers::pi * to_vec3(sun.color)};
}

Arrival arrival_from(const Light& light, const Vec3& position)
{
    const Vec3 intensity = to_vec3(light.intensity);
    if (light.kind == LightKind::directional) {
        return {-1.0 * to_vec3(light.direction), intensity};
    }
    const Vec3 way = to_vec3(light.position) - position;
    const double squared = dot(way, way);
    const Vec3 to_light = normalized(way);
    double scale =
        in_range(std::sqrt(squared), light.range) / std::max(squared, kLeastSquaredDistance);
    if (light.kind == LightKind::spot) {
        scale *= in_cone(light, to_light);
    }
    return {to_light, scale * intensity};
}

std::vector<Arrival> arrivals_at(const Scene& scene, const Vec3& position)
{
    std::vector<Arrival> arrivals = {arrival_from(scene.sun)};
    for (const Light& light : scene.lights) {
        arrivals.push_back(arrival_from(light, position));
    }
    return arrivals;
}

Vec3 sky_radiance(const Sky& sky, const Vec3& normal)
{
    const double up = 0.5 + 0.5 * normal[1];
    return (1 - up) * to_vec3(sky.down) + up * to_vec3(sky.up);
}

}  // namespace sheer::reference
