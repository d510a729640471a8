// Each attribute is interpolated with the same weights; a texture's footprint is those weights'
// derivatives.
#include "reference/spot.h"

#include <algorithm>
#include <cmath>

#include <cstddef>

#include "reference/texture_filter.h"

namespace sheer::reference {

Vec3 Spot::normal() const
{
    Vec3 n;
    for (std::size_t k = 0; k < 3; ++k) {
        n[k] = interpolate(interpolation.at, vertices[0]->normal[k], vertices[1]->normal[k],
                           vertices[2]->normal[k]);
    }
    return normalized(n);
}

Vec3 Spot::tangent() const
{
    Vec3 t;
    for (std::size_t k = 0; k < 3; ++k) {
        t[k] = interpolate(interpolation.at, texture_vertices[0].tangent[k],
                           texture_vertices[1].tangent[k], texture_vertices[2].tangent[k]);
    }
    return t;
}

std::array<double, 4> Spot::vertex_color() const
{
    std::array<double, 4> color;
    for (std::size_t k = 0; k < 4; ++k) {
        color[k] = interpolate(interpolation.at, vertices[0]->color[k], vertices[1]->color[k],
                               vertices[2]->color[k]);
    }
    return color;
}

Texel Spot::read(const std::optional<Texture>& texture, TexelUse use)
{
    if (!texture) {
        return {1, 1, 1, 1};
    }
    Footprint footprint;
    for (std::size_t k = 0; k < 2; ++k) {
        const double at0 = texture_vertices[0].texcoords[texture->set][k];
        const double at1 = texture_vertices[1].texcoords[texture->set][k];
        const double at2 = texture_vertices[2].texcoords[texture->set][k];
        footprint.at[k] = interpolate(interpolation.at, at0, at1, at2);
        footprint.at[k] += coordinates_off[k] * std::max(1.0, std::abs(footprint.at[k]));
        footprint.per_x[k] = change_of(interpolation.per_x, at0, at1, at2);
        footprint.per_y[k] = change_of(interpolation.per_y, at0, at1, at2);
    }
    const Filtered filtered = filter_texture(shader.textures.chain(*texture, use), texture->sampler,
                                             transformed(texture->transform, footprint));
    discontinuities |= filtered.discontinuities;
    return filtered.texel;
}

Spot spot_at(const Shader& shader, const TriangleChunk& chunk, const Triangle& triangle,
             const Weights& affine)
{
    const Scene& scene = shader.scene;
    const Geometry& geometry = shader.geometry;
    const Material& material = material_of(scene, scene.objects[triangle.object]);
    const auto attributes = [&](int i) {
        return &geometry.attributes_of(chunk, triangle.vertex[i]);
    };
    const auto texture_attributes = [&](int i) {
        return geometry.texture_attributes_of(chunk, triangle.vertex[i]);
    };
    return {shader,
            triangle,
            material,
            {attributes(0), attributes(1), attributes(2)},
            {texture_attributes(0), texture_attributes(1), texture_attributes(2)},
            interpolation_at(triangle, affine, geometry.orthographic),
            place_at(triangle, affine, geometry.eye)};
}

}  // namespace sheer::reference
