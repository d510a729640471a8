// Mipmaps of textures whose alpha is opacity: levels that keep the part that passes an alpha test,
// straight ones, and fewer of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <sheer/error.h>

#include "raster/sample_pattern.h"
#include "reference/coverage_mips.h"
#include "reference/mipmap.h"
#include "shade/coverage_scale.h"
#include "shade/mip_chain.h"
#include "shade/textured_wall.h"

namespace sheer::test {
namespace {

using reference::passing_part;

// Leaves on nothing: in three quarters of the texels alpha is 0, in the others 1, or between at
// the edges of blocks.
TextureImage leaves(int side)
{
    std::mt19937 random(5);
    std::vector<Rgba8> texels(static_cast<std::size_t>(side * side), Rgba8{0, 255, 0, 0});
    for (int leaf = 0; leaf < side * side / 24; ++leaf) {
        const int x = static_cast<int>(random() % static_cast<unsigned>(side));
        const int y = static_cast<int>(random() % static_cast<unsigned>(side));
        for (int i = 0; i < 9; ++i) {
            const auto at =
                static_cast<std::size_t>((y + i / 3) % side * side + (x + i % 3) % side);
            const int alpha = i == 4 ? 255 : texels[at][3] + static_cast<int>(random() % 160);
            texels[at] = {255, 255, 255, static_cast<std::uint8_t>(std::min(alpha, 255))};
        }
    }
    return image_of(side, side, std::move(texels));
}

// Of a level, as doubles of multiples of 1/65535.
std::vector<double> alphas_of(const MipChain& chain, std::uint32_t level)
{
    std::vector<double> alphas;
    const std::size_t first = chain.first[level];
    const std::size_t count = std::size_t{chain.width[level]} * chain.height[level];
    for (std::size_t i = first; i < first + count; ++i) {
        alphas.push_back((chain.words[2 * i + 1] >> 16) / 65535.0);
    }
    return alphas;
}

TEST(CoverageScale, IsTheOracles)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int round = 0; round < 300; ++round) {
        std::vector<double> alphas(1 + random() % 40);
        // Many are equal in every other round.
        for (double& a : alphas) {
            a = round % 2 == 0 ? std::floor(9 * uniform(random)) / 8 : uniform(random);
        }
        const double part = uniform(random), threshold = 0.1 + 0.8 * uniform(random);
        const double scale = coverage_scale(alphas, part, threshold);
        const auto expected = reference::scaled_for_part(alphas, part, threshold);
        for (std::size_t i = 0; i < alphas.size(); ++i) {
            EXPECT_NEAR(std::min(1.0, scale * alphas[i]), expected[i], 1e-12);
        }
    }
}

// How many of them are the same, at most, of those above 0.
int most_equal(std::vector<double> alphas)
{
    std::sort(alphas.begin(), alphas.end());
    int most = 1, equal = 1;
    for (std::size_t i = 1; i < alphas.size(); ++i) {
        equal = alphas[i] == alphas[i - 1] && alphas[i] > 0 ? equal + 1 : 1;
        most = std::max(most, equal);
    }
    return most;
}

// The nearest part that a level of n texels can have is within m / (2 n), where m of them are equal
// and pass together; and rounding to 16 bits may take those with it that are within a step of the
// threshold.
TEST(CoverageMips, EveryLevelPassesAsTheImageDoes)
{
    const TextureImage image = leaves(64);
    std::vector<double> own;
    for (const auto& texel : image.texels) own.push_back(texel[3] / 255.0);
    for (const float threshold : {0.25f, 0.5f, 0.7f}) {
        const auto cutoff = static_cast<double>(threshold);
        const double part = passing_part(own, cutoff);
        ASSERT_GT(part, 0.04);
        ASSERT_LT(part, 0.6);
        const MipChain chain = make_mip_chain(image, {TexelUse::color_with_alpha, threshold});
        const MipChain plain = make_mip_chain(image, {TexelUse::color_with_alpha});
        ASSERT_EQ(chain.level_count, 7u);
        EXPECT_EQ(passing_part(alphas_of(chain, 0), cutoff), part);
        double worst_plain = 0;
        for (std::uint32_t level = 1; level < chain.level_count; ++level) {
            SCOPED_TRACE(testing::Message() << threshold << ", level " << level);
            const std::vector<double> kept = alphas_of(chain, level);
            const auto n = static_cast<double>(kept.size());
            const auto doubtful = std::count_if(kept.begin(), kept.end(), [&](double alpha) {
                return std::abs(alpha - cutoff) < 2 / 65535.0;
            });
            EXPECT_LE(
                std::abs(passing_part(kept, cutoff) - part),
                (0.5 * most_equal(alphas_of(plain, level)) + static_cast<double>(doubtful)) / n +
                    1e-12);
            worst_plain = std::max(
                worst_plain, std::abs(passing_part(alphas_of(plain, level), cutoff) - part) * n);
        }
        EXPECT_GT(worst_plain, 10);  // texels that a plain mipmap loses, or wins
    }
}

// A threshold for each level is Castaño's scale the other way round: alphas stay, and what passes
// is the same but for what is rounded to 16 bits within a step of the threshold.
TEST(CoverageMips, ThresholdsPassAsScaledLevelsDo)
{
    const TextureImage image = leaves(64);
    for (const float threshold : {0.25f, 0.5f, 0.7f}) {
        const MipChain scaled = make_mip_chain(image, {TexelUse::color_with_alpha, threshold});
        const MipChain plain = make_mip_chain(image, {TexelUse::color_with_alpha});
        const MipChain chain =
            make_mip_chain(image, {TexelUse::color_with_alpha, threshold, 0, true});
        EXPECT_TRUE(chain.has_thresholds);
        EXPECT_FALSE(scaled.has_thresholds);
        EXPECT_EQ(chain.words, plain.words);
        EXPECT_EQ(chain.threshold[0], 1);
        const auto cutoff = static_cast<double>(threshold);
        for (std::uint32_t level = 0; level < chain.level_count; ++level) {
            const std::vector<double> alphas = alphas_of(chain, level);
            const double own = cutoff * static_cast<double>(chain.threshold[level]);
            const auto doubtful = std::count_if(alphas.begin(), alphas.end(), [&](double alpha) {
                return std::abs(alpha - own) < 2 / 65535.0;
            });
            EXPECT_NEAR(passing_part(alphas, own), passing_part(alphas_of(scaled, level), cutoff),
                        static_cast<double>(doubtful) / static_cast<double>(alphas.size()) + 1e-12)
                << threshold << ", level " << level;
        }
    }
}

TEST(CoverageMips, ColorsStayAsTheyAreUnderAlpha)
{
    // A third is white, the rest absent: alpha grows, and colour with it.
    const TextureImage image = image_of(2, 2,
                                        {{255, 255, 255, 255},
                                         {0, 255, 0, 0},  //
                                         {0, 255, 0, 0},
                                         {255, 255, 255, 160}});
    const MipChain chain = make_mip_chain(image, {TexelUse::color_with_alpha, 0.5f});
    ASSERT_EQ(chain.level_count, 2u);
    const std::uint32_t rg = chain.words[8], ba = chain.words[9];
    // Half of the texels pass, one or none are as near; of those the larger.
    EXPECT_GE(ba >> 16, 32768u);
    EXPECT_EQ(rg & 0xffff, ba >> 16);
    EXPECT_EQ(rg >> 16, ba >> 16);
    EXPECT_EQ(ba & 0xffff, ba >> 16);
}

TEST(AlphaMips, StraightOnesAverageWhatIsAbsentToo)
{
    const TextureImage image = image_of(2, 1, {{255, 0, 0, 255}, {0, 255, 0, 0}});
    const MipChain straight = make_mip_chain(image, {TexelUse::straight_color});
    EXPECT_EQ(straight.words[4], 32768u | 32768u << 16);  // half red and half green
    EXPECT_EQ(straight.words[5], 32768u << 16);
    const MipChain times = make_mip_chain(image, {TexelUse::color_with_alpha});
    EXPECT_EQ(times.words[4], 32768u);
    EXPECT_EQ(times.words[5], 32768u << 16);
}

TEST(AlphaMips, FewerLevelsAreTheFirstOfAll)
{
    const TextureImage image = leaves(16);
    const MipChain all = make_mip_chain(image, {TexelUse::color_with_alpha});
    for (std::uint32_t levels = 1; levels <= 6; ++levels) {
        const MipRecipe recipe{TexelUse::color_with_alpha, 0, levels};
        const MipChain some = make_mip_chain(image, recipe);
        EXPECT_EQ(some.level_count, std::min(levels, 5u));
        EXPECT_EQ(some.words,
                  std::vector(all.words.begin(),
                              all.words.begin() + static_cast<std::ptrdiff_t>(some.words.size())));
        EXPECT_EQ(mip_chain_bytes(image, recipe).kept, 4 * some.words.size());
    }
}

// White leaves whose absent texels are green, far away: mean colours over opacity.
TEST(AlphaMips, HalosAreOfStraightOnes)
{
    const auto mean = [](AlphaMips mips) {
        Wall wall(leaves(64), 0, 0, 40, 40);
        wall.material().alpha_mode = AlphaMode::blend;
        wall.view.alpha_mips = mips;
        Float4 sum = {0, 0, 0, 0};
        for (const Float4& pixel : wall.draw().pixels) {
            for (std::size_t c = 0; c < 4; ++c) sum[c] += pixel[c];
        }
        return Float3{sum[0] / sum[3], sum[1] / sum[3], sum[3] / 256};
    };
    const Float3 none = mean(AlphaMips::premultiplied), halo = mean(AlphaMips::straight);
    EXPECT_NEAR(none[0], 1, 1e-3f);
    EXPECT_NEAR(none[1], 1, 1e-3f);
    // Of the image's colours, whatever their alphas.
    float white = 0;
    for (const auto& texel : leaves(64).texels) white += texel[0] / 255.0f / (64 * 64);
    EXPECT_NEAR(halo[0], white, 1e-3f);
    EXPECT_LT(halo[0], 0.7f);
    EXPECT_NEAR(halo[1], 1, 1e-3f);
    EXPECT_NEAR(halo[2], none[2], 1e-4f);
}

// Far away the mean is below the cutoff, and nothing passes.
TEST(AlphaMips, ATestOfTheImageItselfLosesNothing)
{
    const auto coverage = [](const View& how) {
        Wall wall(leaves(64), 0.013f, 0.007f, 32.013f, 32.007f);
        wall.material().alpha_mode = AlphaMode::mask;
        wall.sampler() = {Wrap::repeat, Wrap::repeat, TexelFilter::nearest, TexelFilter::nearest,
                          MipFilter::nearest};
        wall.view.alpha_mips = how.alpha_mips;
        wall.view.texture_levels = how.texture_levels;
        wall.view.width = wall.view.height = 97;
        wall.view.samples = how.samples == 64 ? 64 : 1;
        wall.view.shade_at = how.shade_at;
        double sum = 0;
        for (const Float4& pixel : wall.draw().pixels) sum += static_cast<double>(pixel[3]);
        return sum / (97 * 97);
    };
    std::vector<double> own;
    for (const auto& texel : leaves(64).texels) own.push_back(texel[3] / 255.0);
    const double part = passing_part(own, 0.5);
    View plain, first, castano, thresholds, samples;
    first.texture_levels = 1;
    castano.alpha_mips = AlphaMips::coverage;
    thresholds.alpha_mips = AlphaMips::thresholds;
    samples.texture_levels = 1;
    samples.shade_at = ShadeAt::sample;
    samples.samples = 64;
    EXPECT_EQ(coverage(plain), 0);
    // Texels here and there, no worse than if they were independent: 4.5 standard errors.
    const double sampling = 4.5 * std::sqrt(part * (1 - part)) / 97;
    EXPECT_NEAR(coverage(first), part, sampling);
    // A pixel sees 21 texels across: level 4, which has 16 texels, and passes in sixteenths.
    EXPECT_NEAR(coverage(castano), part, sampling + 1. / 32);
    EXPECT_EQ(coverage(thresholds), coverage(castano));
    // As many more, evenly spread.
    EXPECT_NEAR(coverage(samples), part, sampling / 8);
}

// What is not tested at a fixed threshold has nothing to do with thresholds.
TEST(AlphaMips, ThresholdsChangeNoOpacity)
{
    Wall wall(leaves(64), 0.1f, 0.2f, 9.1f, 9.2f);
    wall.material().alpha_mode = AlphaMode::mask;
    wall.view.width = wall.view.height = 64;
    const auto draw = [&](AlphaMips mips, const char* method) {
        wall.view.alpha_mips = mips;
        Options options;
        options.method = method;
        return render(wall.scene, wall.view, options).image.pixels;
    };
    for (const char* method : {"hashed-alpha-test", "alpha-test-then-blend"}) {
        EXPECT_EQ(draw(AlphaMips::thresholds, method), draw(AlphaMips::premultiplied, method));
    }
    EXPECT_NE(draw(AlphaMips::thresholds, "alpha-test"),
              draw(AlphaMips::premultiplied, "alpha-test"));
    wall.material().alpha_mode = AlphaMode::blend;
    EXPECT_EQ(draw(AlphaMips::thresholds, "exact"), draw(AlphaMips::premultiplied, "exact"));
}

// Texels a little wider than samples are apart, read at each: the mean of what is there.
TEST(ShadeAtSamples, EverySampleHasATexelOfItsOwn)
{
    const TextureImage image = leaves(64);
    for (const int samples : {2, 8, 64}) {
        Wall wall(image, 0.0031f, 0.0017f, 0.9f, 0.8f);
        wall.material().alpha_mode = AlphaMode::blend;
        wall.sampler() = {Wrap::repeat, Wrap::repeat, TexelFilter::nearest, TexelFilter::nearest,
                          MipFilter::none};
        wall.view.samples = samples;
        const Image whole = wall.draw();
        wall.view.shade_at = ShadeAt::sample;
        const Image image_at_samples = wall.draw();
        const std::vector<SamplePoint> points = sample_pattern(samples, SamplePositions::standard);
        double most = 0, most_whole = 0;
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) {
                double sum = 0;
                for (const SamplePoint& p : points) {
                    const double u = 0.0031 + (x + p.x / 256.0) / 16 * (0.9 - 0.0031);
                    const double v = 0.0017 + (y + p.y / 256.0) / 16 * (0.8 - 0.0017);
                    const int column = static_cast<int>(u * 64), row = static_cast<int>(v * 64);
                    sum += image.texels[static_cast<std::size_t>(row * 64 + column)][3] / 255.0;
                }
                const double expected = sum / samples;
                const auto off = [&](const Image& got) {
                    return std::abs(static_cast<double>(got.at(x, y)[3]) - expected);
                };
                most = std::max(most, off(image_at_samples));
                most_whole = std::max(most_whole, off(whole));
            }
        }
        // Alphas have 16 bits; no sample lies on a texel's edge to floats' rounding.
        EXPECT_LT(most, 1e-4) << samples;
        EXPECT_GT(most_whole, 0.2) << samples;
    }
}

// Sixteen samples are a fourth of a pixel apart: two levels finer.
TEST(ShadeAtSamples, TexturesAreAsSharpAsSamplesAreDense)
{
    const auto lost = [](int samples, ShadeAt where) {
        Wall wall(leaves(64), 0.013f, 0.007f, 4.013f, 4.007f);  // 4 texels a pixel
        wall.material().alpha_mode = AlphaMode::mask;
        wall.view.width = wall.view.height = 64;
        wall.view.samples = samples;
        wall.view.shade_at = where;
        double sum = 0;
        for (const Float4& pixel : wall.draw().pixels) sum += static_cast<double>(pixel[3]);
        return sum / (64 * 64);
    };
    // As by one sample a pixel of a picture four times as wide and high: level 0, within what 2^16
    // independent samples differ by, 4.5 standard errors.
    Wall large(leaves(64), 0.013f, 0.007f, 4.013f, 4.007f);
    large.material().alpha_mode = AlphaMode::mask;
    large.view.width = large.view.height = 256;
    large.view.samples = 1;
    double part = 0;
    for (const Float4& pixel : large.draw().pixels) part += static_cast<double>(pixel[3]);
    part /= 256 * 256;
    EXPECT_NEAR(lost(16, ShadeAt::sample), part, 4.5 * std::sqrt(part * (1 - part)) / 256);
    EXPECT_LT(lost(16, ShadeAt::fragment), 0.5 * part);
}

TEST(ShadeAtSamples, AtOnePointItIsTheFragments)
{
    Wall wall(leaves(64), 0.1f, 0.2f, 3.1f, 3.2f);
    wall.material().alpha_mode = AlphaMode::mask;
    for (const SamplePositions positions : {SamplePositions::center, SamplePositions::standard}) {
        wall.view.positions = positions;
        wall.view.samples = positions == SamplePositions::center ? 8 : 1;
        wall.view.shade_at = ShadeAt::fragment;
        const Image expected = wall.draw();
        wall.view.shade_at = ShadeAt::sample;
        EXPECT_EQ(wall.draw().pixels, expected.pixels);
    }
}

TEST(AlphaMips, RefusesLevelsThatNoTextureHas)
{
    Wall wall(checkers(4), 0, 0, 1, 1);
    for (const int levels : {-1, 17}) {
        wall.view.texture_levels = levels;
        EXPECT_THROW(wall.draw(), Error);
    }
}

}  // namespace
}  // namespace sheer::test
