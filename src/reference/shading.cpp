// A fragment's colour and opacity: perspective-correct attributes, one sun, one sky.
//
// Interpolation: J. Blinn, "Hyperbolic interpolation", 1992. The formulas are docs/numerics.md,
// "Fragments" and "Shading".
#include <algorithm>
#include <cmath>

#include "reference/fragments.h"

namespace sheer::reference {

namespace {

// A float knows an opacity near 1 to 6e-8 and the renderer rounds a few times on the way to it.
constexpr double kCutoffRounding = 1e-6;

// Shorter normals have no direction that could be trusted; docs/numerics.md makes them 0.
constexpr double kShortestNormal = 1e-10;

Weights perspective_correct(const Triangle& triangle, const Weights& affine, bool orthographic)
{
    if (orthographic) {
        return affine;
    }
    Weights weights;
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        weights.b[i] = affine.b[i] * -double{triangle.depth[i]};  // depth is -1/w
        sum += weights.b[i];
    }
    for (double& weight : weights.b) {
        weight /= sum;
    }
    return weights;
}

// As steps from the first value, so that what is equal at the vertices stays exactly so between
// them.
double interpolate(const Weights& weights, double at0, double at1, double at2)
{
    return at0 + weights.b[1] * (at1 - at0) + weights.b[2] * (at2 - at0);
}

struct Direction {
    double x, y, z;
};

Direction facing_normal(const Weights& weights, const Attributes* const vertices[3], bool back)
{
    double n[3];
    for (std::size_t k = 0; k < 3; ++k) {
        n[k] = interpolate(weights, vertices[0]->normal[k], vertices[1]->normal[k],
                           vertices[2]->normal[k]);
    }
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length < kShortestNormal) {
        return {0, 0, 0};
    }
    const double scale = (back ? -1 : 1) / length;
    return {n[0] * scale, n[1] * scale, n[2] * scale};
}

// Radiance of a white surface.
double light(const Scene& scene, const Direction& n, std::size_t channel)
{
    const double up = 0.5 + 0.5 * n.y;
    const double sky = scene.sky.down[channel] * (1 - up) + scene.sky.up[channel] * up;
    const Float3& l = scene.sun.to_light;
    const double cosine = n.x * l[0] + n.y * l[1] + n.z * l[2];
    return sky + scene.sun.color[channel] * std::max(0.0, cosine);
}

void set_presence(Surface& surface, const Material& material)
{
    switch (material.alpha_mode) {
        case AlphaMode::opaque: surface.presence = Presence::opaque; break;
        case AlphaMode::mask:
            surface.presence =
                surface.opacity >= material.alpha_cutoff ? Presence::opaque : Presence::absent;
            surface.at_cutoff = std::abs(surface.opacity - material.alpha_cutoff) < kCutoffRounding;
            break;
        case AlphaMode::blend:
            surface.presence = surface.opacity > 0 ? Presence::transparent : Presence::absent;
            break;
    }
    if (material.alpha_mode != AlphaMode::blend) {
        surface.opacity = 1;
    }
}

}  // namespace

Surface shade(const Scene& scene, const Geometry& geometry, const TriangleChunk& chunk,
              const Triangle& triangle, const Weights& affine, double exposure_scale)
{
    const Object& object = scene.objects[triangle.object];
    const Material& material = scene.materials[scene.meshes[object.mesh].material];
    const Weights weights = perspective_correct(triangle, affine, geometry.orthographic);
    const Attributes* const vertices[3] = {&geometry.attributes_of(chunk, triangle.vertex[0]),
                                           &geometry.attributes_of(chunk, triangle.vertex[1]),
                                           &geometry.attributes_of(chunk, triangle.vertex[2])};
    const Direction normal = facing_normal(weights, vertices, triangle.back_facing != 0);

    Surface surface;
    for (std::size_t k = 0; k < 3; ++k) {
        const double vertex_color = interpolate(weights, vertices[0]->color[k],
                                                vertices[1]->color[k], vertices[2]->color[k]);
        const double lit = material.shading == Shading::unlit ? 1.0 : light(scene, normal, k);
        surface.color[k] = material.base_color[k] * vertex_color * lit * exposure_scale;
    }
    const double vertex_alpha =
        interpolate(weights, vertices[0]->color[3], vertices[1]->color[3], vertices[2]->color[3]);
    surface.opacity = std::clamp(material.opacity * vertex_alpha, 0.0, 1.0);
    set_presence(surface, material);
    return surface;
}

}  // namespace sheer::reference
