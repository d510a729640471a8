// An image made ready to be filtered: linear, premultiplied where its alpha counts, with all its
// mipmap levels (docs/numerics.md, "Textures").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sheer/scene.h>

namespace sheer {

// How a material reads an image.
enum class TexelUse {
    color_with_alpha,  // sRGB, multiplied by its alpha
    color,             // sRGB, alpha counts as 1
    data,              // linear, alpha counts as 1
};

// 16 bits a channel in [0, 1]; red and green in the first word, blue and alpha in the second, the
// lower half first.
struct MipChain {
    static constexpr std::size_t kMostLevels = 16;  // of images up to 32768 texels wide
    std::uint32_t level_count = 0;
    // Of each level: its size and its first texel.
    std::array<std::uint32_t, kMostLevels> width = {}, height = {}, first = {};
    std::vector<std::uint32_t> words;  // two for each texel, rows from the top, level after level
};

MipChain make_mip_chain(const TextureImage& image, TexelUse use);

// At most, while a chain is made of such an image.
std::uint64_t mip_chain_bytes(const TextureImage& image);

}  // namespace sheer
