// The place on a triangle where a fragment is shaded, and what is read there: interpolated
// attributes and textures (docs/numerics.md, "Fragments" and "Textures").
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "reference/fragments.h"
#include "reference/interpolation.h"
#include "reference/mipmap.h"
#include "reference/vector.h"

namespace sheer::reference {

struct Spot {
    const Shader& shader;
    const Triangle& triangle;
    const Material& material;
    const Attributes* vertices[3];
    TextureAttributes texture_vertices[3];
    Interpolation interpolation;
    Place place;
    // Added to texture coordinates, times their size where that is above 1.
    std::array<double, 2> coordinates_off = {0, 0};
    std::uint8_t discontinuities = 0;  // of what was read so far: kNearestTexel, kProbeCount

    // Interpolated, world space: of unit length, or zero (docs/numerics.md, "Normal").
    Vec3 normal() const;

    // Interpolated, world space, of any length.
    Vec3 tangent() const;

    // Interpolated, linear straight RGBA, not clamped.
    std::array<double, 4> vertex_color() const;

    // A texture of the material by docs/numerics.md, "Textures"; ones without it, for factors to
    // stay what they are.
    Texel read(const std::optional<Texture>& texture, TexelUse use);
};

// At affine weights on a triangle of the chunk.
Spot spot_at(const Shader& shader, const TriangleChunk& chunk, const Triangle& triangle,
             const Weights& affine);

}  // namespace sheer::reference
