// Images for textures, texel by texel.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sheer/scene.h>

namespace sheer::reference {

using Bytes4 = std::array<std::uint8_t, 4>;

// A colour as levels keep it (docs/numerics.md, "Mipmaps").
inline double in_16_bits(double value)
{
    return std::floor(value * 65535 + 0.5 + 1e-6) / 65535;
}

inline TextureImage image_of(int width, int height, const std::vector<Bytes4>& texels)
{
    TextureImage image;
    image.width = width;
    image.height = height;
    image.texels = texels;
    return image;
}

// One row of opaque greys.
inline TextureImage row_of(const std::vector<std::uint8_t>& grays)
{
    std::vector<Bytes4> texels;
    for (const std::uint8_t gray : grays) {
        texels.push_back({gray, gray, gray, 255});
    }
    return image_of(static_cast<int>(grays.size()), 1, texels);
}

// Bytes without a pattern, from a linear congruence (D. Knuth's MMIX).
inline TextureImage noise_of(int width, int height)
{
    std::vector<Bytes4> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::uint64_t state = 1;
    for (Bytes4& texel : texels) {
        for (std::uint8_t& byte : texel) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            byte = static_cast<std::uint8_t>(state >> 56);
        }
    }
    return image_of(width, height, texels);
}

}  // namespace sheer::reference
