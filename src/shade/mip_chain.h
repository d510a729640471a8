// An image made ready to be filtered: linear, premultiplied where its alpha counts, with its
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
    straight_color,    // sRGB, its alpha beside it
    color,             // sRGB, alpha counts as 1
    data,              // linear, alpha counts as 1
};

// What is made of an image.
struct MipRecipe {
    TexelUse use;
    // Above 0, of color_with_alpha: of each level as large a part as can be reaches this alpha as
    // of the image (coverage_scale.h).
    float keeps_coverage_at = 0;
    std::uint32_t levels = 0;    // that are kept, the largest first; 0: all
    bool by_thresholds = false;  // coverage is kept by MipChain::threshold, alphas are as they are

    auto operator<=>(const MipRecipe&) const = default;
};

// Colours have 16 bits a channel: red and green in a texel's first word, blue and alpha in its
// second, the lower half first, 65535 for 1. Data have floats: a highlight hangs on a normal's
// sixth digit.
struct MipChain {
    static constexpr std::size_t kMostLevels = 16;  // of images up to 32768 texels wide
    std::uint32_t level_count = 0;
    // Of each level: its size and its first texel.
    std::array<std::uint32_t, kMostLevels> width = {}, height = {}, first = {};
    // Where a recipe asks for them: what is to be reached at each level, as a part of what is at
    // the first.
    bool has_thresholds = false;
    std::array<float, kMostLevels> threshold = {};
    // Rows from the top, level after level; one of the two is empty.
    std::vector<std::uint32_t> words;  // two for each texel
    std::vector<float> floats;         // four for each texel
};

MipChain make_mip_chain(const TextureImage& image, const MipRecipe& recipe);

// What an image's chain takes, and what making it takes besides.
struct MipChainBytes {
    std::uint64_t kept, making;
};
MipChainBytes mip_chain_bytes(const TextureImage& image, const MipRecipe& recipe);

}  // namespace sheer
