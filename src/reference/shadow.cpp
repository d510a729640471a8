// A product over all triangles that lie in the way.
#include "reference/shadow.h"

#include <algorithm>
#include <optional>

#include "reference/texture_filter.h"

namespace sheer::reference {

namespace {

struct Crossing {
    double distance;
    Vec3 weights;  // of the three corners
    bool from_front;
};

Vec3 to_world(const Mat4& m, const Float3& p)
{
    Vec3 r;
    for (std::size_t i = 0; i < 3; ++i) {
        r[i] = double{m[i]} * p[0] + double{m[4 + i]} * p[1] + double{m[8 + i]} * p[2] + m[12 + i];
    }
    return r;
}

// Where the way meets the triangle's plane, and whether that is inside: the triangles that the
// point makes with two corners each have areas that are its weights.
std::optional<Crossing> crossing(const std::array<Vec3, 3>& corner, const LightWay& way)
{
    const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double steepness = dot(normal, way.to_light);
    if (steepness == 0) {
        return std::nullopt;
    }
    Crossing c;
    c.distance = dot(normal, corner[0] - way.from) / steepness;
    const Vec3 at = way.from + c.distance * way.to_light;
    const double area = dot(normal, normal);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& next = corner[(i + 1) % 3];
        const Vec3& last = corner[(i + 2) % 3];
        c.weights[i] = dot(normal, cross(last - next, at - next)) / area;
        if (c.weights[i] < 0) {
            return std::nullopt;
        }
    }
    // The light goes against the way: it meets the front where the normal leans towards it.
    c.from_front = steepness > 0;
    return c;
}

struct CrossedTriangle {
    const Mesh& mesh;
    const std::uint32_t* indices;
    Vec3 weights;
};

Texel read(const CrossedTriangle& t, const Textures& textures,
           const std::optional<Texture>& texture, TexelUse use)
{
    if (!texture) {
        return {1, 1, 1, 1};
    }
    // Without any change from pixel to pixel the finest level is read.
    Footprint footprint{{0, 0}, {0, 0}, {0, 0}};
    const auto& set = t.mesh.texcoords[texture->set];
    for (std::size_t i = 0; i < 3 && !set.empty(); ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            footprint.at[k] += t.weights[i] * set[t.indices[i]][k];
        }
    }
    return filter_texture(textures.chain(*texture, use), texture->sampler,
                          transformed(texture->transform, footprint))
        .texel;
}

Vec3 passing(const CrossedTriangle& t, const Textures& textures, const Material& material,
             double object_opacity)
{
    const Texel texel = read(t, textures, material.base_color_texture, base_color_use(material));
    std::array<double, 4> vertex = {0, 0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
            vertex[c] +=
                t.weights[i] * (t.mesh.colors.empty() ? 1 : t.mesh.colors[t.indices[i]][c]);
        }
    }
    double opacity = std::clamp(material.opacity * vertex[3] * texel[3], 0.0, 1.0);
    if (material.alpha_mode == AlphaMode::opaque) {
        opacity = 1;
    }
    if (material.alpha_mode == AlphaMode::mask) {
        opacity = opacity >= material.alpha_cutoff ? 1 : 0;
    }
    opacity *= opacity > 0 ? object_opacity : 1;
    Vec3 result = {1 - opacity, 1 - opacity, 1 - opacity};
    if (!transmits(material)) {
        return result;
    }
    const double metallic =
        material.metallic *
        read(t, textures, material.metallic_roughness_texture, TexelUse::data)[2];
    const double tau =
        material.transmission * read(t, textures, material.transmission_texture, TexelUse::data)[0];
    for (std::size_t c = 0; c < 3; ++c) {
        const double straight = texel[3] > 0 ? texel[c] / texel[3] : 0;
        const double color = material.base_color[c] * vertex[c] * straight;
        result[c] = std::min(1.0, result[c] + opacity * tau * (1 - metallic) * 0.96 * color);
    }
    return result;
}

bool is_mirrored(const Mat4& m)
{
    const Vec3 x = {m[0], m[1], m[2]}, y = {m[4], m[5], m[6]}, z = {m[8], m[9], m[10]};
    return dot(x, cross(y, z)) < 0;
}

}  // namespace

Vec3 light_along(const Scene& scene, const Textures& textures, const LightWay& way)
{
    Vec3 light = {1, 1, 1};
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const Object& object = scene.objects[o];
        const Mesh& mesh = scene.meshes[object.mesh];
        const Material& material = material_of(scene, object);
        if (mesh.topology != Topology::triangles || material.shading == Shading::unlit) {
            continue;
        }
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            if (o == way.own_object && i / 3 == way.own_triangle) {
                continue;
            }
            const std::uint32_t* indices = &mesh.indices[i];
            std::array<Vec3, 3> corner;
            for (std::size_t k = 0; k < 3; ++k) {
                corner[k] = to_world(object.transform, mesh.positions[indices[k]]);
            }
            const std::optional<Crossing> c = crossing(corner, way);
            if (!c || c->distance <= way.least || c->distance >= way.most) {
                continue;
            }
            const bool front = c->from_front != is_mirrored(object.transform);
            if (front || material.double_sided) {
                light = light *
                        passing({mesh, indices, c->weights}, textures, material, object.opacity);
            }
        }
    }
    return light;
}

}  // namespace sheer::reference
