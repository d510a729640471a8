// Decoded texels and mipmaps: by hand, and by what they must conserve.
#include <gtest/gtest.h>

#include <utility>

#include "reference/mipmap.h"
#include "small_images.h"

namespace sheer::reference {
namespace {

constexpr double kExact = 1e-12;
// Of what is rounded to multiples of 1/65535, the middle within 1e-6 upwards.
constexpr double kRounded = (0.5 + 2e-6) / 65535;

void expect_near(const Texel& actual, const Texel& expected, double tolerance = kRounded)
{
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(actual[c], expected[c], tolerance) << c;
    }
}

Texel mean_of(const MipChain& chain, int level)
{
    const TextureSize size = chain.size(level);
    Texel sum = {0, 0, 0, 0};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Texel texel = chain.texel(level, x, y);
            for (std::size_t c = 0; c < 4; ++c) {
                sum[c] += texel[c] / (size.width * size.height);
            }
        }
    }
    return sum;
}

TEST(ReferenceMipmap, DecodesWhatTheBytesMean)
{
    // IEC 61966-2-1: 10 / 255 lies on the line, 188 / 255 on the curve.
    const TextureImage image = image_of(1, 1, {{10, 188, 255, 51}});
    const double line = 10 / 255.0 / 12.92;
    const double curve = 0.50288645803251;  // ((188 / 255 + 0.055) / 1.055) ^ 2.4
    expect_near(MipChain(image, TexelUse::opaque_color).texel(0, 0, 0), {line, curve, 1, 1});
    expect_near(MipChain(image, TexelUse::premultiplied_color).texel(0, 0, 0),
                {0.2 * line, 0.2 * curve, 0.2, 0.2});
    expect_near(MipChain(image, TexelUse::data).texel(0, 0, 0), {10 / 255.0, 188 / 255.0, 1, 1},
                kExact);
}

TEST(ReferenceMipmap, SizesAreHalvedDownToOne)
{
    const TextureImage image = noise_of(13, 3);
    const MipChain chain(image, TexelUse::data);
    const std::pair<int, int> sizes[] = {{13, 3}, {6, 1}, {3, 1}, {1, 1}};
    ASSERT_EQ(chain.last_level(), 3);
    for (int level = 0; level <= 3; ++level) {
        EXPECT_EQ(chain.size(level).width, sizes[level].first);
        EXPECT_EQ(chain.size(level).height, sizes[level].second);
    }
    const TextureImage dot = noise_of(1, 1);
    EXPECT_EQ(MipChain(dot, TexelUse::data).last_level(), 0);
}

TEST(ReferenceMipmap, PartsOfTexelsCountInPart)
{
    // Each of two texels covers two and a half of five.
    const TextureImage row = row_of({51, 102, 153, 204, 255});
    const MipChain five(row, TexelUse::data);
    EXPECT_NEAR(five.texel(1, 0, 0)[0], (0.2 + 0.4 + 0.5 * 0.6) / 2.5, kExact);
    EXPECT_NEAR(five.texel(1, 1, 0)[0], (0.5 * 0.6 + 0.8 + 1) / 2.5, kExact);
    // Of three times three the middle one is a ninth.
    std::vector<Bytes4> texels(9, Bytes4{0, 0, 0, 255});
    texels[4] = {255, 255, 255, 255};
    const TextureImage square = image_of(3, 3, texels);
    EXPECT_NEAR(MipChain(square, TexelUse::data).texel(1, 0, 0)[0], 1.0 / 9, kExact);
}

TEST(ReferenceMipmap, NoMeanIsLost)
{
    for (const auto& [width, height] :
         {std::pair(5, 3), {7, 1}, {1, 9}, {13, 6}, {8, 8}, {31, 17}, {2, 1}}) {
        const TextureImage image = noise_of(width, height);
        for (const TexelUse use :
             {TexelUse::premultiplied_color, TexelUse::opaque_color, TexelUse::data}) {
            const MipChain chain(image, use);
            const Texel mean = mean_of(chain, 0);
            for (int level = 1; level <= chain.last_level(); ++level) {
                SCOPED_TRACE(testing::Message() << width << "x" << height << ", level " << level);
                // Both means are of rounded colours.
                expect_near(mean_of(chain, level), mean,
                            use == TexelUse::data ? kExact : 2 * kRounded);
            }
        }
    }
}

TEST(ReferenceMipmap, ColorsAreMultipliedByAlphaBeforeTheyAreMixed)
{
    const TextureImage image = image_of(2, 1, {{255, 0, 0, 255}, {0, 255, 0, 0}});
    expect_near(MipChain(image, TexelUse::premultiplied_color).texel(1, 0, 0), {0.5, 0, 0, 0.5});
    expect_near(MipChain(image, TexelUse::opaque_color).texel(1, 0, 0), {0.5, 0.5, 0, 1});
}

TEST(ReferenceMipmap, AlphaCountsWhereSomethingIsSeenThrough)
{
    Material material;
    material.shading = Shading::metallic_roughness;
    EXPECT_EQ(base_color_use(material), TexelUse::opaque_color);
    material.transmission = 0.5f;
    EXPECT_EQ(base_color_use(material), TexelUse::opaque_color);
    for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend}) {
        material.alpha_mode = mode;
        EXPECT_EQ(base_color_use(material), TexelUse::premultiplied_color);
    }
    material.alpha_mode = AlphaMode::mask;
    material.alpha_cutoff = 0;  // everything passes
    EXPECT_EQ(base_color_use(material), TexelUse::opaque_color);
}

}  // namespace
}  // namespace sheer::reference
