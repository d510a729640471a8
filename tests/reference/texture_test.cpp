// Texture filtering: by hand, and by what every sampler must leave as it is.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/reference.h"
#include "reference/texture_filter.h"
#include "small_images.h"

namespace sheer::reference {
namespace {

constexpr double kExact = 1e-12;

std::vector<Sampler> all_samplers()
{
    std::vector<Sampler> samplers;
    for (const Wrap u : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
        for (const Wrap v : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
            for (const TexelFilter magnify : {TexelFilter::nearest, TexelFilter::linear}) {
                for (const TexelFilter minify : {TexelFilter::nearest, TexelFilter::linear}) {
                    for (const MipFilter mip :
                         {MipFilter::none, MipFilter::nearest, MipFilter::linear}) {
                        samplers.push_back({u, v, magnify, minify, mip});
                    }
                }
            }
        }
    }
    return samplers;
}

// Magnified, alike in all directions, long, far away, and at coordinates far off.
const Footprint kFootprints[] = {
    {{0.3, 0.4}, {0, 0}, {0, 0}},          {{-3.7, 12.01}, {0.01, 0}, {0, 0.01}},
    {{1, 0}, {0.5, 0.1}, {-0.1, 0.5}},     {{-1, -2}, {0.9, 0}, {0, 0.03}},
    {{0.5, 7.2}, {0.02, 0.3}, {0.1, 0}},   {{0.999999, 1e-9}, {2, 0}, {0, 1e-9}},
    {{1e30, -1e30}, {1e6, 3}, {-2, 1e30}}, {{-1e-20, -1e-20}, {0, 0}, {1, 1}}};

TEST(ReferenceTexture, ConstantsStayConstant)
{
    const TextureImage image = image_of(5, 3, std::vector<Bytes4>(15, {10, 255, 0, 51}));
    const MipChain chain(image, TexelUse::premultiplied_color);
    const Texel expected = {in_16_bits(0.2 * 10 / 255 / 12.92), 0.2, 0, 0.2};
    for (const Sampler& sampler : all_samplers()) {
        for (const Footprint& footprint : kFootprints) {
            const Texel texel = filter_texture(chain, sampler, footprint).texel;
            for (std::size_t c = 0; c < 4; ++c) {
                EXPECT_NEAR(texel[c], expected[c], kExact);
            }
        }
    }
}

TEST(ReferenceTexture, TransparentTexelsHaveNoColor)
{
    // The same holes, once black and once of all colours: no halo of them may show.
    TextureImage black = noise_of(6, 5);
    for (std::size_t i = 0; i < black.texels.size(); i += 3) {
        black.texels[i] = {0, 0, 0, 0};
    }
    TextureImage colored = black;
    for (std::size_t i = 0; i < colored.texels.size(); i += 3) {
        colored.texels[i] = {255, static_cast<std::uint8_t>(9 * i), 128, 0};
    }
    const MipChain a(black, TexelUse::premultiplied_color);
    const MipChain b(colored, TexelUse::premultiplied_color);
    for (const Sampler& sampler : all_samplers()) {
        for (const Footprint& footprint : kFootprints) {
            EXPECT_EQ(filter_texture(a, sampler, footprint).texel,
                      filter_texture(b, sampler, footprint).texel);
        }
    }
}

TEST(ReferenceTexture, EdgesOfHolesKeepTheirColor)
{
    const TextureImage image = image_of(2, 1, {{255, 0, 0, 255}, {0, 255, 0, 0}});
    const MipChain chain(image, TexelUse::premultiplied_color);
    for (int i = 0; i < 20; ++i) {
        const Texel texel =
            filter_texture(chain, {}, {{i / 20.0, 0.5}, {0.07 * i, 0}, {0, 0.1}}).texel;
        EXPECT_NEAR(texel[0], texel[3], kExact);
        EXPECT_EQ(texel[1], 0);
    }
}

TEST(ReferenceTexture, CheckerboardFarAwayIsItsLinearMean)
{
    std::vector<Bytes4> texels;
    for (int i = 0; i < 64; ++i) {
        const std::uint8_t gray = (i + i / 8) % 2 == 0 ? 0 : 255;
        texels.push_back({gray, gray, gray, 255});
    }
    const TextureImage image = image_of(8, 8, texels);
    const MipChain chain(image, TexelUse::opaque_color);
    for (const double texels_per_pixel : {2.0, 3.0, 8.0, 1000.0}) {
        const double d = texels_per_pixel / 8;
        for (const double at : {0.0, 0.1, 0.55, 7.9}) {
            const Texel texel = filter_texture(chain, {}, {{at, 0.3}, {d, 0}, {0, d}}).texel;
            EXPECT_NEAR(texel[0], in_16_bits(0.5), kExact);
        }
    }
}

TEST(ReferenceTexture, IsDecodedBeforeItIsFiltered)
{
    // Halfway between two texels.
    const TextureImage image = row_of({0, 188});
    const Footprint between{{0.5, 0.5}, {0, 0}, {0, 0}};
    const auto value = [&](TexelUse use) {
        return filter_texture(MipChain(image, use), {}, between).texel[0];
    };
    EXPECT_NEAR(value(TexelUse::opaque_color), in_16_bits(0.50288645803251) / 2, kExact);
    EXPECT_NEAR(value(TexelUse::data), 188 / 255.0 / 2, kExact);
}

struct Wrapped {
    Wrap wrap;
    double u;
    double nearest, linear;  // in thirds
};

TEST(ReferenceTexture, WrapsCoordinates)
{
    // Four texels, 0, 1/3, 2/3 and 1. Where u falls within [0, 1], u' say, the nearest is number
    // floor(4 u'); the linear value between the middles of the first and the last is (4 u' - 1/2)
    // thirds.
    const Wrapped rows[] = {
        {Wrap::repeat, 0.3, 1, 0.7},
        {Wrap::repeat, 1.3, 1, 0.7},
        {Wrap::repeat, -0.2, 3, 2.7},
        {Wrap::repeat, -0.05, 3, 2.1},  // 0.3 of the way from the last to the first
        {Wrap::repeat, 0, 0, 1.5},
        {Wrap::repeat, 1, 0, 1.5},
        {Wrap::mirrored_repeat, 0.3, 1, 0.7},
        {Wrap::mirrored_repeat, -0.3, 1, 0.7},
        {Wrap::mirrored_repeat, 1.3, 2, 2.3},  // at 0.7
        {Wrap::mirrored_repeat, -1.3, 2, 2.3},
        {Wrap::mirrored_repeat, 2.3, 1, 0.7},
        {Wrap::mirrored_repeat, 0, 0, 0},
        {Wrap::mirrored_repeat, 1, 3, 3},
        {Wrap::mirrored_repeat, 0.95, 3, 3},
        {Wrap::clamp_to_edge, 0.3, 1, 0.7},
        {Wrap::clamp_to_edge, -0.3, 0, 0},
        {Wrap::clamp_to_edge, 0.05, 0, 0},
        {Wrap::clamp_to_edge, 1.3, 3, 3}};
    const TextureImage wide = row_of({0, 85, 170, 255});
    const TextureImage high = image_of(1, 4, wide.texels);
    const MipChain along_u(wide, TexelUse::data);
    const MipChain along_v(high, TexelUse::data);
    for (const Wrapped& row : rows) {
        SCOPED_TRACE(testing::Message() << static_cast<int>(row.wrap) << " at " << row.u);
        for (const TexelFilter filter : {TexelFilter::nearest, TexelFilter::linear}) {
            const double expected = (filter == TexelFilter::nearest ? row.nearest : row.linear) / 3;
            const Sampler sampler{row.wrap, row.wrap, filter, filter, MipFilter::none};
            const Texel u = filter_texture(along_u, sampler, {{row.u, 0.2}, {0, 0}, {0, 0}}).texel;
            const Texel v = filter_texture(along_v, sampler, {{0.2, row.u}, {0, 0}, {0, 0}}).texel;
            EXPECT_NEAR(u[0], expected, kExact);
            EXPECT_NEAR(v[0], expected, kExact);
        }
    }
}

// Black and white columns by turns.
double stripes_at(const Sampler& sampler, double u, double texels_per_pixel)
{
    const TextureImage image = row_of({0, 255, 0, 255, 0, 255, 0, 255});
    const MipChain chain(image, TexelUse::data);
    const double d = texels_per_pixel;
    return filter_texture(chain, sampler, {{u, 0.5}, {d / 8, 0}, {0, d}}).texel[0];
}

TEST(ReferenceTexture, LevelsAndFilters)
{
    const double white = 1.5 / 8;  // the middle of texel 1
    const double edge = 1.0 / 8;   // of texels 0 and 1
    const auto sampler = [](TexelFilter magnify, TexelFilter minify, MipFilter mip) {
        return Sampler{Wrap::repeat, Wrap::repeat, magnify, minify, mip};
    };
    constexpr auto nearest = TexelFilter::nearest;
    constexpr auto linear = TexelFilter::linear;
    // One texel a pixel or less magnifies, more minifies.
    EXPECT_NEAR(stripes_at(sampler(linear, nearest, MipFilter::none), edge, 0.99), 0.5, kExact);
    EXPECT_NEAR(stripes_at(sampler(linear, nearest, MipFilter::none), edge, 1), 0.5, kExact);
    EXPECT_NEAR(stripes_at(sampler(linear, nearest, MipFilter::none), edge, 1.01), 1, kExact);
    EXPECT_NEAR(stripes_at(sampler(nearest, linear, MipFilter::none), edge, 0.99), 1, kExact);
    EXPECT_NEAR(stripes_at(sampler(nearest, linear, MipFilter::none), edge, 99), 0.5, kExact);
    // Level 1 is grey; the nearest is that from sqrt(2) = 1.414 texels a pixel on.
    EXPECT_NEAR(stripes_at(sampler(linear, nearest, MipFilter::none), white, 99), 1, kExact);
    EXPECT_NEAR(stripes_at(sampler(linear, nearest, MipFilter::nearest), white, 1.41), 1, kExact);
    EXPECT_NEAR(stripes_at(sampler(linear, nearest, MipFilter::nearest), white, 1.42), 0.5, kExact);
    // Between levels: a quarter of the way from 1 to 0.5.
    const double quarter = std::exp2(0.25);
    EXPECT_NEAR(stripes_at(sampler(nearest, nearest, MipFilter::linear), white, quarter), 0.875,
                kExact);
    EXPECT_NEAR(stripes_at(sampler(nearest, linear, MipFilter::linear), white, quarter), 0.875,
                kExact);
    EXPECT_NEAR(stripes_at(sampler(nearest, linear, MipFilter::linear), white, 1e9), 0.5, kExact);
}

TEST(ReferenceTexture, ProbesOnARampGiveItsMean)
{
    // Texel x is x / 255, at x + 1/2; means over texels lie on the same line, and so do means of
    // probes that lie symmetrically, wherever no edge is near.
    std::vector<std::uint8_t> ramp;
    for (int x = 0; x < 256; ++x) {
        ramp.push_back(static_cast<std::uint8_t>(x));
    }
    std::vector<Bytes4> texels;
    for (int y = 0; y < 256; ++y) {
        const std::vector<Bytes4> row = row_of(ramp).texels;
        texels.insert(texels.end(), row.begin(), row.end());
    }
    const TextureImage image = image_of(256, 256, texels);
    const MipChain chain(image, TexelUse::data);
    for (const double longer : {0.5, 1.0, 1.5, 4.0, 7.3, 20.0, 50.0}) {
        for (const double shorter : {0.01, 0.4, 1.0, 1.7, 6.0}) {
            for (const double x : {110.0, 127.3, 128.9}) {
                const Footprint along{{x / 256, 0.5}, {longer / 256, 0}, {0, shorter / 256}};
                const Footprint across{{x / 256, 0.5}, {0, shorter / 256}, {longer / 256, 0}};
                const double expected = (x - 0.5) / 255;
                EXPECT_NEAR(filter_texture(chain, {}, along).texel[0], expected, kExact);
                EXPECT_NEAR(filter_texture(chain, {}, across).texel[0], expected, kExact);
            }
        }
    }
}

TEST(ReferenceTexture, ProbesLieAlongTheLongerSide)
{
    // A white column in black, seen at its middle.
    std::vector<Bytes4> texels(64 * 64, Bytes4{0, 0, 0, 255});
    for (std::size_t y = 0; y < 64; ++y) {
        texels[64 * y + 32] = {255, 255, 255, 255};
    }
    const TextureImage image = image_of(64, 64, texels);
    const MipChain chain(image, TexelUse::data);
    const auto at_column = [&](double across, double along) {
        const Footprint footprint{{32.5 / 64, 0.5}, {across / 64, 0}, {0, along / 64}};
        return filter_texture(chain, {}, footprint).texel[0];
    };
    // Along the column all probes are white, at the level of the width across: 0.
    EXPECT_NEAR(at_column(1, 8), 1, kExact);
    EXPECT_NEAR(at_column(1, 3.5), 1, kExact);
    // Across it four probes lie 1/2 and 3/2 texels off: two of them see half of it. Three, for
    // 2.1 texels, lie 0 and 0.7 off: 1 and twice 0.3.
    EXPECT_NEAR(at_column(4, 1), 0.25, kExact);
    EXPECT_NEAR(at_column(2.1, 1), 1.6 / 3, kExact);
    // No more than eight: then the level is that of an eighth, here 1, whose texel 16 is half
    // white. We look 1/4 of a texel to the left of its middle, and the nearest probes, 1/2 to both
    // sides, are 3/4 and 1/4 away from it: (1/4 + 3/4) / 2 of eight.
    EXPECT_NEAR(at_column(16, 1), 0.0625, kExact);
    EXPECT_NEAR(at_column(16, 0), 0.0625, kExact);
    // One texel or less is one probe.
    EXPECT_NEAR(at_column(1, 0.1), 1, kExact);
    // Samplers that choose a level, or a texel, take one probe: here of level 2, of whose texel 8,
    // from 32 to 36, the middle is 1.5 texels off, 3/8 of its width: 5/8 of a quarter.
    const Sampler isotropic{Wrap::repeat, Wrap::repeat, TexelFilter::linear, TexelFilter::linear,
                            MipFilter::nearest};
    const Footprint footprint{{32.5 / 64, 0.5}, {4.0 / 64, 0}, {0, 1.0 / 64}};
    EXPECT_NEAR(filter_texture(chain, isotropic, footprint).texel[0], 0.625 * 0.25, kExact);
}

TEST(ReferenceTexture, TransformsCoordinatesAndTheirChanges)
{
    const Footprint footprint =
        transformed({0, 2, 0.5f, -1, 0, 0.25f}, {{0.1, 0.2}, {1, 3}, {10, 20}});
    EXPECT_NEAR(footprint.at[0], 0.9, kExact);
    EXPECT_NEAR(footprint.at[1], 0.15, kExact);
    EXPECT_EQ(footprint.per_x, (std::array<double, 2>{6, -1}));
    EXPECT_EQ(footprint.per_y, (std::array<double, 2>{40, -10}));
}

TEST(ReferenceTexture, NearestTexelsAreUncertainAtTheirEdges)
{
    const TextureImage image = row_of({0, 85, 170, 255});
    const MipChain chain(image, TexelUse::data);
    const auto flags = [&](double texels, Wrap wrap, TexelFilter filter) {
        const Sampler sampler{wrap, Wrap::clamp_to_edge, filter, filter, MipFilter::none};
        return filter_texture(chain, sampler, {{texels / 4, 0.5}, {0, 0}, {0, 0}}).discontinuities;
    };
    constexpr auto nearest = TexelFilter::nearest;
    EXPECT_EQ(flags(2.0005, Wrap::repeat, nearest), kNearestTexel);
    EXPECT_EQ(flags(1.9995, Wrap::clamp_to_edge, nearest), kNearestTexel);
    EXPECT_EQ(flags(2.002, Wrap::repeat, nearest), 0);
    EXPECT_EQ(flags(2.5, Wrap::repeat, nearest), 0);
    EXPECT_EQ(flags(2.0005, Wrap::repeat, TexelFilter::linear), 0);
    // At the ends only repeating has another texel.
    EXPECT_EQ(flags(0, Wrap::repeat, nearest), kNearestTexel);
    EXPECT_EQ(flags(3.9999, Wrap::repeat, nearest), kNearestTexel);
    EXPECT_EQ(flags(3.9999, Wrap::mirrored_repeat, nearest), 0);
    EXPECT_EQ(flags(-2, Wrap::clamp_to_edge, nearest), 0);
}

TEST(ReferenceTexture, LevelsAndProbesAreUncertainAtTheirSteps)
{
    const TextureImage image = noise_of(64, 64);
    const MipChain chain(image, TexelUse::data);
    const auto flags = [&](const Sampler& sampler, double longer, double shorter) {
        const Footprint footprint{{0.3, 0.3}, {longer / 64, 0}, {0, shorter / 64}};
        return filter_texture(chain, sampler, footprint).discontinuities;
    };
    constexpr auto linear = TexelFilter::linear;
    const Sampler by_level{Wrap::repeat, Wrap::repeat, linear, linear, MipFilter::nearest};
    EXPECT_EQ(flags(by_level, std::exp2(1.50005), 1), kNearestTexel);
    EXPECT_EQ(flags(by_level, std::exp2(0.49995), 1), kNearestTexel);
    EXPECT_EQ(flags(by_level, std::exp2(1.501), 1), 0);
    EXPECT_EQ(flags(by_level, std::exp2(9.5), 1), 0);  // there are six levels more, not nine
    const Sampler by_size{Wrap::repeat, Wrap::repeat, TexelFilter::nearest, linear,
                          MipFilter::linear};
    EXPECT_EQ(flags(by_size, 1.00001, 1.00001) & kNearestTexel, kNearestTexel);
    // The number of probes changes 1/64 beyond whole ratios up to seven, and where there is more
    // than one.
    const Sampler smooth;
    const auto beyond = [](int ratio) { return ratio + 1.0 / 64; };
    EXPECT_EQ(flags(smooth, beyond(3) * (1 + 5e-5) * 2, 2), kProbeCount);
    EXPECT_EQ(flags(smooth, beyond(3) * (1 - 5e-5) * 2, 2), kProbeCount);
    EXPECT_EQ(flags(smooth, beyond(1) * 2, 2), kProbeCount);
    EXPECT_EQ(flags(smooth, beyond(7) * 2, 2), kProbeCount);
    EXPECT_EQ(flags(smooth, beyond(3) * (1 + 2e-4) * 2, 2), 0);
    EXPECT_EQ(flags(smooth, 2, 2), 0);
    EXPECT_EQ(flags(smooth, 3 * 2, 2), 0);
    EXPECT_EQ(flags(smooth, 8 * 2, 2), 0);
    EXPECT_EQ(flags(smooth, 12 * 2, 2), 0);
    EXPECT_EQ(flags(smooth, 0.9, 0.3), 0);
    EXPECT_EQ(flags(smooth, 1 + 5e-5, 0.4), kProbeCount);
    EXPECT_EQ(flags(smooth, 1 - 5e-5, 0.4), kProbeCount);
    EXPECT_EQ(flags(by_level, 3 * 2, 2), 0);
}

}  // namespace
}  // namespace sheer::reference
