// Decoding by IEC 61966-2-1; each level's texels are means of the level before, parts of texels
// counted in part.
#include "reference/mipmap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace sheer::reference {

namespace {

double linear_of_srgb(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::array<double, 256> make_srgb_table()
{
    std::array<double, 256> table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = linear_of_srgb(static_cast<double>(i) / 255);
    }
    return table;
}

Texel decode(const std::array<std::uint8_t, 4>& bytes, TexelUse use)
{
    static const std::array<double, 256> from_srgb = make_srgb_table();
    if (use == TexelUse::data) {
        return {bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0, 1};
    }
    const double alpha = use == TexelUse::premultiplied_color ? bytes[3] / 255.0 : 1;
    return {alpha * from_srgb[bytes[0]], alpha * from_srgb[bytes[1]], alpha * from_srgb[bytes[2]],
            alpha};
}

// docs/numerics.md, "Mipmaps": to 16 bits; what doubles may get wrong goes upwards.
Texel rounded(const Texel& texel)
{
    Texel result;
    for (std::size_t c = 0; c < 4; ++c) {
        result[c] = std::floor(texel[c] * 65535 + 0.5 + 1e-6) / 65535;
    }
    return result;
}

// A texel of the larger level and its part of a smaller one's length; the parts' sum is 1.
struct Share {
    int index;
    double part;
};

// Texel `at` of `to` covers [at from / to, (at + 1) from / to) of the larger level. In units of
// 1 / to of its texels all ends are whole.
std::vector<Share> shares(int at, int from, int to)
{
    const std::int64_t begin = std::int64_t{at} * from;
    const std::int64_t end = begin + from;
    std::vector<Share> result;
    for (std::int64_t i = begin / to; i * to < end; ++i) {
        const std::int64_t overlap = std::min(end, (i + 1) * to) - std::max(begin, i * to);
        result.push_back({static_cast<int>(i), static_cast<double>(overlap) / from});
    }
    return result;
}

std::vector<std::vector<Share>> all_shares(int from, int to)
{
    std::vector<std::vector<Share>> result;
    for (int i = 0; i < to; ++i) {
        result.push_back(shares(i, from, to));
    }
    return result;
}

}  // namespace

MipChain::MipChain(const TextureImage& image, TexelUse use) : image_(&image), use_(use)
{
    TextureSize above{image.width, image.height};
    while (above.width > 1 || above.height > 1) {
        const TextureSize size{std::max(1, above.width / 2), std::max(1, above.height / 2)};
        const auto columns = all_shares(above.width, size.width);
        const auto rows = all_shares(above.height, size.height);
        const int level_above = last_level();
        Level level{size, {}};
        for (const auto& row : rows) {
            for (const auto& column : columns) {
                Texel sum = {0, 0, 0, 0};
                for (const Share& y : row) {
                    for (const Share& x : column) {
                        const Texel texel = unrounded_texel(level_above, x.index, y.index);
                        for (std::size_t c = 0; c < 4; ++c) {
                            sum[c] += x.part * y.part * texel[c];
                        }
                    }
                }
                level.texels.push_back(sum);
            }
        }
        smaller_.push_back(std::move(level));
        above = size;
    }
}

TextureSize MipChain::size(int level) const
{
    return level == 0 ? TextureSize{image_->width, image_->height}
                      : smaller_[static_cast<std::size_t>(level) - 1].size;
}

Texel MipChain::texel(int level, int x, int y) const
{
    const Texel texel = unrounded_texel(level, x, y);
    return use_ == TexelUse::data ? texel : rounded(texel);
}

Texel MipChain::unrounded_texel(int level, int x, int y) const
{
    const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(size(level).width) +
                       static_cast<std::size_t>(x);
    return level == 0 ? decode(image_->texels[index], use_)
                      : smaller_[static_cast<std::size_t>(level) - 1].texels[index];
}

bool transmits(const Material& material)
{
    return material.shading == Shading::metallic_roughness && material.transmission > 0;
}

TexelUse base_color_use(const Material& material)
{
    const bool all_pass = material.alpha_mode == AlphaMode::mask && material.alpha_cutoff <= 0;
    const bool alpha_counts = material.alpha_mode != AlphaMode::opaque && !all_pass;
    return alpha_counts ? TexelUse::premultiplied_color : TexelUse::opaque_color;
}

Textures::Textures(const Scene& scene)
{
    const auto add = [&](const std::optional<Texture>& texture, TexelUse use) {
        if (texture) {
            chains_.try_emplace({texture->image, use}, scene.images[texture->image], use);
        }
    };
    for (const Object& object : scene.objects) {
        const Material& material = material_of(scene, object);
        add(material.base_color_texture, base_color_use(material));
        add(material.emission_texture, TexelUse::opaque_color);
        add(material.metallic_roughness_texture, TexelUse::data);
        add(material.normal_texture, TexelUse::data);
        add(material.transmission_texture, TexelUse::data);
    }
}

}  // namespace sheer::reference
