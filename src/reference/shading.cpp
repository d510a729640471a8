// A fragment's colour, opacity and transmittance from its material, textures and lights. The
// formulas are docs/numerics.md, "Shading".
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "reference/fragments.h"
#include "reference/light.h"
#include "reference/reflection.h"
#include "reference/spot.h"
#include "reference/vector.h"

namespace sheer::reference {

namespace {

// A float knows an opacity near 1 to 6e-8 and the renderer rounds a few times on the way to it.
constexpr double kCutoffRounding = 1e-6;

// The renderer's texels are multiples of 1/65535, and its coordinates are floats: 6e-8 of a texture
// 1024 texels wide is 6e-5 of a texel, over which alpha may go from 0 to 1.
constexpr double kTexturedCutoffRounding = 1e-4;

// Floats know a texture coordinate near 1, a sum of three terms, to two units in its last place,
// and a unit normal after a dozen of operations to four. A quarter of what two pictures may differ
// by (1e-4) is what such a step may take.
constexpr double kCoordinateStep = 0x1p-23;  // of the coordinate, or of 1 where it is smaller
constexpr double kNormalStep = 0x1p-21;
constexpr double kSteepChange = 0.25e-4;

constexpr double kLeastRoughness = 0.1;
constexpr double kDielectricReflectance = 0.04;  // glTF 2.0, appendix B: of an index of 1.5
constexpr double kLeastOpacityOfGlass = 1e-6;

// Base colour, straight, and the opacity before the alpha mode decides.
struct Base {
    Vec3 color;
    double opacity;
};

Base base_of(Spot& spot)
{
    const Material& material = spot.material;
    const std::array<double, 4> vertex = spot.vertex_color();
    const Texel texel = spot.read(material.base_color_texture, base_color_use(material));
    Base base;
    for (std::size_t c = 0; c < 3; ++c) {
        const double straight = texel[3] > 0 ? texel[c] / texel[3] : 0;
        base.color[c] = material.base_color[c] * vertex[c] * straight;
    }
    base.opacity = material.alpha_mode == AlphaMode::opaque
                       ? 1
                       : std::clamp(material.opacity * vertex[3] * texel[3], 0.0, 1.0);
    return base;
}

// The vertices' normal, bent by the normal texture.
Vec3 bent_normal(Spot& spot)
{
    const Material& material = spot.material;
    const Vec3 n = spot.normal();
    const Vec3 interpolated = spot.tangent();
    const Vec3 t = normalized(interpolated - dot(n, interpolated) * n);
    if (!material.normal_texture || dot(n, n) == 0 || dot(t, t) == 0) {
        return n;
    }
    const double side = spot.texture_vertices[0].tangent[3];
    const Vec3 b = side * cross(n, t);
    const Texel texel = spot.read(material.normal_texture, TexelUse::data);
    const double s = material.normal_scale;
    return normalized(s * (2 * texel[0] - 1) * t + s * (2 * texel[1] - 1) * b +
                      (2 * texel[2] - 1) * n);
}

Vec3 facing_normal(Spot& spot)
{
    return (spot.triangle.back_facing != 0 ? -1.0 : 1.0) * bent_normal(spot);
}

Vec3 emission_of(Spot& spot)
{
    const Texel texel = spot.read(spot.material.emission_texture, TexelUse::opaque_color);
    return to_vec3(spot.material.emission) * Vec3{texel[0], texel[1], texel[2]};
}

Vec3 diffuse_radiance(const Spot& spot, const Vec3& color, const Vec3& normal)
{
    const Scene& scene = spot.shader.scene;
    Vec3 light = sky_radiance(scene.sky, normal);
    for (const Arrival& arrival : arrivals_at(scene, spot.place.position)) {
        const double cosine = std::max(0.0, dot(normal, arrival.to_light));
        light = light + (cosine / std::numbers::pi) * arrival.irradiance;
    }
    return color * light;
}

struct MetallicRoughness {
    double metallic, roughness, transmission;
};

MetallicRoughness metallic_roughness_of(Spot& spot)
{
    const Material& material = spot.material;
    const Texel texel = spot.read(material.metallic_roughness_texture, TexelUse::data);
    const Texel transmission = spot.read(material.transmission_texture, TexelUse::data);
    return {material.metallic * texel[2],
            std::clamp(material.roughness * texel[1], kLeastRoughness, 1.0),
            material.transmission * transmission[0]};
}

Vec3 at_most_one(const Vec3& v)
{
    return {std::min(1.0, v[0]), std::min(1.0, v[1]), std::min(1.0, v[2])};
}

Vec3 metallic_roughness_radiance(const Spot& spot, const Vec3& color, const Vec3& normal,
                                 const MetallicRoughness& values)
{
    const Scene& scene = spot.shader.scene;
    const double m = values.metallic;
    const Vec3 diffuse = (1 - m) * (1 - values.transmission) * color;
    if (dot(normal, normal) == 0) {
        return diffuse * sky_radiance(scene.sky, normal);
    }
    const Vec3 dielectric = {kDielectricReflectance, kDielectricReflectance,
                             kDielectricReflectance};
    const Reflector reflector{normal, spot.place.to_eye, diffuse,
                              at_most_one(dielectric + m * (color - dielectric)), values.roughness};
    Vec3 radiance = reflected_sky(reflector, scene.sky);
    for (const Arrival& arrival : arrivals_at(scene, spot.place.position)) {
        const double cosine = std::max(0.0, dot(normal, arrival.to_light));
        radiance =
            radiance + cosine * (arrival.irradiance * reflectance(reflector, arrival.to_light));
    }
    return radiance;
}

// A surface through which nothing but its opacity's rest is seen.
void set_plain(Surface& surface, const Vec3& radiance, double opacity)
{
    surface.opacity = opacity;
    for (std::size_t c = 0; c < 3; ++c) {
        surface.color[c] = radiance[c];
        surface.transmittance[c] = 1 - opacity;
    }
    surface.presence = opacity > 0 ? Presence::transparent : Presence::absent;
}

// docs/numerics.md, "Transmission".
void set_glass(Surface& surface, const Vec3& radiance, double opacity, const Vec3& color,
               const MetallicRoughness& values)
{
    const double through =
        values.transmission * (1 - values.metallic) * (1 - kDielectricReflectance);
    const Vec3 t =
        at_most_one(Vec3{1 - opacity, 1 - opacity, 1 - opacity} + opacity * through * color);
    surface.opacity = 1 - mean(t);
    if (surface.opacity < kLeastOpacityOfGlass) {
        return;
    }
    for (std::size_t c = 0; c < 3; ++c) {
        surface.color[c] = opacity * radiance[c] / surface.opacity;
        surface.transmittance[c] = t[c];
    }
    surface.presence = Presence::transparent;
}

Vec3 tilted(const Vec3& normal, const Vec3& tilt)
{
    return dot(normal, normal) == 0 ? normal : normalized(normal + tilt);
}

// `tilt` is added to the unit normal.
Surface shade_spot(Spot& spot, const Vec3& tilt)
{
    const Material& material = spot.material;
    const double object_opacity = spot.shader.scene.objects[spot.triangle.object].opacity;

    // Read what the material needs, and no more: unread textures have no discontinuities.
    const Base base = base_of(spot);
    MetallicRoughness values{0, 1, 0};
    Vec3 radiance = base.color;
    if (material.shading == Shading::diffuse) {
        radiance = diffuse_radiance(spot, base.color, facing_normal(spot)) + emission_of(spot);
    } else if (material.shading == Shading::metallic_roughness) {
        values = metallic_roughness_of(spot);
        radiance = metallic_roughness_radiance(spot, base.color, tilted(facing_normal(spot), tilt),
                                               values) +
                   emission_of(spot);
    }
    radiance = spot.shader.exposure_scale * radiance;

    // What passes the mask is opaque.
    Surface surface;
    surface.discontinuities = spot.discontinuities;
    double opacity = base.opacity;
    if (material.alpha_mode == AlphaMode::mask) {
        const double rounding =
            material.base_color_texture ? kTexturedCutoffRounding : kCutoffRounding;
        if (std::abs(opacity - material.alpha_cutoff) < rounding) {
            surface.discontinuities |= kOpacityAtCutoff;
        }
        if (opacity < material.alpha_cutoff) {
            return surface;
        }
        opacity = 1;
    }

    opacity *= object_opacity;
    if (transmits(material)) {
        set_glass(surface, radiance, opacity, base.color, values);
    } else {
        set_plain(surface, radiance, opacity);
        if (material.alpha_mode != AlphaMode::blend && object_opacity >= 1) {
            surface.presence = Presence::opaque;
        }
    }
    return surface;
}

// Whether the colour hangs on more digits of a coordinate than a float has.
bool is_steep(const Surface& surface, const Surface& beside)
{
    for (std::size_t c = 0; c < 3; ++c) {
        const double difference = std::abs(surface.color[c] - beside.color[c]);
        if (difference > kSteepChange * std::max(1.0, std::abs(surface.color[c]))) return true;
    }
    return false;
}

}  // namespace

Surface shade(const Shader& shader, const TriangleChunk& chunk, const Triangle& triangle,
              const Weights& affine)
{
    Spot spot = spot_at(shader, chunk, triangle, affine);
    Surface surface = shade_spot(spot, {});
    if (spot.material.shading != Shading::metallic_roughness) {
        return surface;
    }
    const auto look_beside = [&](double u, double v, const Vec3& tilt) {
        Spot beside = spot_at(shader, chunk, triangle, affine);
        beside.coordinates_off = {u, v};
        if (is_steep(surface, shade_spot(beside, tilt))) {
            surface.discontinuities |= kSteepColor;
        }
    };
    look_beside(kCoordinateStep, 0, {});
    look_beside(0, kCoordinateStep, {});
    look_beside(0, 0, {kNormalStep, 0, 0});
    look_beside(0, 0, {0, kNormalStep, 0});
    look_beside(0, 0, {0, 0, kNormalStep});
    return surface;
}

}  // namespace sheer::reference
