// Levels are averaged in doubles, each from the one before, and rounded for keeping.
#include "shade/mip_chain.h"

#include <algorithm>

#include "image/color.h"
#include "shade/coverage_scale.h"

namespace sheer {

namespace {

using Texel = std::array<double, 4>;

std::array<double, 256> decoding_table(TexelUse use)
{
    std::array<double, 256> table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double encoded = static_cast<double>(i) / 255;
        table[i] = use == TexelUse::data ? encoded : linear_from_srgb(encoded);
    }
    return table;
}

// Where texel i of `count` begins and ends in a row of `source` texels, and what its first and last
// texel count for; those between count for 1.
struct Span {
    std::size_t first, last;
    double first_part, last_part;
};

std::vector<Span> spans(std::size_t source, std::size_t count)
{
    std::vector<Span> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t begin = i * source, end = begin + source;  // in 1/count texels
        Span& span = result[i];
        span.first = begin / count;
        span.last = (end - 1) / count;
        span.first_part = static_cast<double>(std::min((span.first + 1) * count, end) - begin) /
                          static_cast<double>(count);
        span.last_part = static_cast<double>(end - span.last * count) / static_cast<double>(count);
    }
    return result;
}

double part_of(const Span& span, std::size_t i)
{
    if (i == span.first) return span.first_part;
    return i == span.last ? span.last_part : 1.0;
}

struct Level {
    std::size_t width, height;
    std::vector<Texel> texels;
};

// `at(x, y)`: the source's texels. Differences from the first one are averaged: what is the same
// everywhere stays so to the last bit.
template <class At>
Level halved(std::size_t width, std::size_t height, At&& at)
{
    Level level{std::max<std::size_t>(1, width / 2), std::max<std::size_t>(1, height / 2), {}};
    const std::vector<Span> columns = spans(width, level.width), rows = spans(height, level.height);
    const double area = static_cast<double>(width) / static_cast<double>(level.width) *
                        (static_cast<double>(height) / static_cast<double>(level.height));
    level.texels.reserve(level.width * level.height);
    for (const Span& row : rows) {
        for (const Span& column : columns) {
            const Texel base = at(column.first, row.first);
            Texel sum = {0, 0, 0, 0};
            for (std::size_t y = row.first; y <= row.last; ++y) {
                for (std::size_t x = column.first; x <= column.last; ++x) {
                    const Texel texel = at(x, y);
                    const double part = part_of(row, y) * part_of(column, x);
                    for (std::size_t c = 0; c < 4; ++c) sum[c] += part * (texel[c] - base[c]);
                }
            }
            for (std::size_t c = 0; c < 4; ++c) sum[c] = base[c] + sum[c] / area;
            level.texels.push_back(sum);
        }
    }
    return level;
}

// To the nearest; the middle, which doubles may miss a little, goes upwards.
std::uint32_t to_16_bits(double value)
{
    return static_cast<std::uint32_t>(std::clamp(value * 65535 + (0.5 + 1e-6), 0.0, 65535.0));
}

void keep(MipChain& chain, TexelUse use, const Texel& texel)
{
    if (use == TexelUse::data) {
        for (const double c : texel) chain.floats.push_back(static_cast<float>(c));
        return;
    }
    chain.words.push_back(to_16_bits(texel[0]) | to_16_bits(texel[1]) << 16);
    chain.words.push_back(to_16_bits(texel[2]) | to_16_bits(texel[3]) << 16);
}

void begin_level(MipChain& chain, std::size_t width, std::size_t height)
{
    chain.width[chain.level_count] = static_cast<std::uint32_t>(width);
    chain.height[chain.level_count] = static_cast<std::uint32_t>(height);
    chain.first[chain.level_count] =
        static_cast<std::uint32_t>(chain.words.size() / 2 + chain.floats.size() / 4);
    ++chain.level_count;
}

// Of the `most` largest levels; 0: of all.
std::size_t texels_of_levels(std::size_t width, std::size_t height, std::uint32_t most)
{
    std::size_t sum = width * height;
    for (std::uint32_t levels = 1; (width > 1 || height > 1) && levels != most; ++levels) {
        width = std::max<std::size_t>(1, width / 2);
        height = std::max<std::size_t>(1, height / 2);
        sum += width * height;
    }
    return sum;
}

double part_that_reaches(const TextureImage& image, float alpha)
{
    // What the levels' 16 bits and floats make of an alpha is off by less.
    const double least = 255 * (static_cast<double>(alpha) - 1e-6);
    const auto reaching =
        std::count_if(image.texels.begin(), image.texels.end(),
                      [&](const auto& texel) { return static_cast<double>(texel[3]) >= least; });
    return static_cast<double>(reaching) / static_cast<double>(image.texels.size());
}

// The scale of a level's alphas, and of what has been multiplied by them.
double scale_of(const Level& level, const MipRecipe& recipe, double part)
{
    if (!(recipe.keeps_coverage_at > 0)) return 1;
    std::vector<double> alphas;
    alphas.reserve(level.texels.size());
    for (const Texel& texel : level.texels) alphas.push_back(texel[3]);
    return coverage_scale(std::move(alphas), part, static_cast<double>(recipe.keeps_coverage_at));
}

Texel scaled(const Texel& texel, double scale)
{
    const double own = std::min(scale, texel[3] > 0 ? 1 / texel[3] : scale);
    return {own * texel[0], own * texel[1], own * texel[2], own * texel[3]};
}

}  // namespace

MipChain make_mip_chain(const TextureImage& image, const MipRecipe& recipe)
{
    const TexelUse use = recipe.use;
    const std::array<double, 256> decoded = decoding_table(use);
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    const auto at = [&](std::size_t x, std::size_t y) {
        const auto& texel = image.texels[y * width + x];
        const bool counts = use == TexelUse::color_with_alpha || use == TexelUse::straight_color;
        const double alpha = counts ? static_cast<double>(texel[3]) / 255 : 1;
        const double times = use == TexelUse::straight_color ? 1 : alpha;
        return Texel{decoded[texel[0]] * times, decoded[texel[1]] * times,
                     decoded[texel[2]] * times, alpha};
    };
    MipChain chain;
    if (use == TexelUse::data) {
        chain.floats.reserve(4 * texels_of_levels(width, height, recipe.levels));
    } else {
        chain.words.reserve(2 * texels_of_levels(width, height, recipe.levels));
    }
    begin_level(chain, width, height);
    chain.has_thresholds = recipe.by_thresholds;
    chain.threshold[0] = 1;
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) keep(chain, use, at(x, y));
    }
    if ((width == 1 && height == 1) || recipe.levels == 1) return chain;
    const bool keeps_coverage = recipe.keeps_coverage_at > 0;
    const bool scales = keeps_coverage && !recipe.by_thresholds;
    const double part = keeps_coverage ? part_that_reaches(image, recipe.keeps_coverage_at) : 0;
    Level level = halved(width, height, at);
    for (;;) {
        begin_level(chain, level.width, level.height);
        const double scale = scale_of(level, recipe, part);
        chain.threshold[chain.level_count - 1] = static_cast<float>(1 / scale);
        for (const Texel& texel : level.texels) {
            keep(chain, use, scales ? scaled(texel, scale) : texel);
        }
        const bool last = level.width == 1 && level.height == 1;
        if (last || chain.level_count == recipe.levels) return chain;
        level = halved(level.width, level.height, [&](std::size_t x, std::size_t y) {
            return level.texels[y * level.width + x];
        });
    }
}

MipChainBytes mip_chain_bytes(const TextureImage& image, const MipRecipe& recipe)
{
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    const std::uint64_t texel_bytes =
        recipe.use == TexelUse::data ? 4 * sizeof(float) : 2 * sizeof(std::uint32_t);
    const std::size_t all = texels_of_levels(width, height, recipe.levels);
    // Two of the smaller levels at a time, in doubles; and a level's alphas, to be sorted.
    const std::uint64_t making_bytes =
        sizeof(Texel) + (recipe.keeps_coverage_at > 0 ? sizeof(double) : 0);
    return {all * texel_bytes, (all - width * height) * making_bytes};
}

}  // namespace sheer
