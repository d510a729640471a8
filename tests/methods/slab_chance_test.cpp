// How often layers are kept, and the moments of pictures: stochastic layered alpha blending against
// the paper's formulas and against exact moments (src/reference/slab.h), to a stated confidence
// (statistics.h).
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lanes/lone.h"
#include "methods/statistics.h"
#include "methods/stochastic_fixture.h"
#include "methods/texts_alone.h"
#include "reference/slab.h"

namespace sheer {

namespace {

using Text = test::Texts<Lone<float>>;
using Keep = reference::SlabKeep;
using reference::SlabResolve;

// Two layers of which the second's green tells whether it is kept.
double kept_behind(const std::string& method, double alpha_a, double alpha_b, int tiles,
                   const DrivenTile::Fault& fault = {})
{
    DrivenTile tile("slab:layers=4:depth-based=off:" + method, 1);
    const StochasticLayers layers = {{alpha_a, {1, 0, 0}, 1}, {alpha_b, {0, 1, 0}, 2}};
    double kept = 0;
    for (int t = 0; t < tiles; ++t) {
        const SampleColors& colors = tile.draw(layers, {32 * t, 0, 77}, fault);
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            kept += colors.channel(pixel, 1)[0] > 0 ? 1 : 0;
        }
    }
    return kept;
}

std::string bits_of(int b, const std::string& more)
{
    return "bits=" + std::to_string(b) + ":" + more;
}

}  // namespace

// Behind a layer of beta_A bits one of beta_B is kept with the chance 1 - C(beta_A, beta_B) /
// C(b, beta_B), whether bits are there or not. A pixel is a trial.
TEST(SlabChance, OfStratifiedBits)
{
    for (int b = 1; b <= 16; ++b) {
        for (int beta_a = 1; beta_a <= b; ++beta_a) {
            for (int beta_b = 1; beta_b <= b; ++beta_b) {
                const double chance = reference::slab_stratified_chance(b, beta_a, beta_b);
                for (const char* coverage : {"coverage=implicit", "coverage=explicit"}) {
                    const double kept = kept_behind(bits_of(b, coverage), double(beta_a) / b,
                                                    double(beta_b) / b, 1);
                    EXPECT_TRUE(count_agrees(kept, kTilePixels, chance))
                        << "b " << b << ", beta_A " << beta_a << ", beta_B " << beta_b << ", "
                        << coverage;
                }
            }
        }
    }
}

TEST(SlabChance, OfNaiveBits)
{
    for (const int b : {1, 3, 8, 16, 32}) {
        for (int beta_a = 1; beta_a <= b; beta_a += (b + 3) / 4) {
            for (const double alpha_b : {0.05, 0.3, 0.9}) {
                const double chance =
                    reference::slab_naive_chance(b, beta_a, static_cast<double>(float(alpha_b)));
                // The first must have a bit as well, which only then hides.
                const double alpha_a = double(beta_a) / b;
                const double none = std::pow(1 - alpha_a, b);
                const double alone = reference::slab_naive_chance(b, 0, alpha_b);
                const double kept = kept_behind(bits_of(b, "coverage=implicit:probability=naive"),
                                                alpha_a, alpha_b, 8);
                EXPECT_TRUE(
                    count_agrees(kept, 8.0 * kTilePixels, (1 - none) * chance + none * alone))
                    << "b " << b << ", beta_A " << beta_a << ", alpha_B " << alpha_b;
            }
        }
    }
}

// An opacity that is 5 % too small does not go by unnoticed.
TEST(SlabChance, FaultsAreFound)
{
    const DrivenTile::Fault fainter = [](FragmentStream& f) {
        for (int i = 0; i < f.size; ++i) f.opacity[i] *= 0.95f;
    };
    const double chance = reference::slab_stratified_chance(16, 12, 4);
    for (const char* coverage : {"coverage=implicit", "coverage=explicit"}) {
        const std::string method = bits_of(16, coverage);
        EXPECT_TRUE(count_agrees(kept_behind(method, 0.75, 0.25, 16), 16 * kTilePixels, chance));
        EXPECT_FALSE(
            count_agrees(kept_behind(method, 0.75, 0.25, 16, fainter), 16 * kTilePixels, chance));
    }
}

// Over numbers evenly spread over [0, 1) each count is off by less than one of them.
TEST(SlabChance, IsThatOfTheLimit)
{
    constexpr int kNumbers = 2000;
    for (const int b : {1, 2, 7, 16, 33, 64, 128}) {
        for (int beta_b = 0; beta_b <= b; beta_b += (b + 7) / 8) {
            std::vector<double> seen(static_cast<std::size_t>(b) + 1);
            const float opacity = static_cast<float>(beta_b) / static_cast<float>(b);
            for (int i = 0; i < kNumbers; ++i) {
                const float random = (static_cast<float>(i) + 0.5f) / kNumbers;
                const float count = Text::slab_seen_behind(true, random, opacity, 0.5f, b);
                for (int beta = 0; static_cast<float>(beta) < count; ++beta) {
                    seen[static_cast<std::size_t>(beta)] += 1;
                }
            }
            for (int beta = 0; beta <= b; ++beta) {
                EXPECT_NEAR(seen[static_cast<std::size_t>(beta)] / kNumbers,
                            reference::slab_stratified_chance(b, beta, beta_b), 1.0 / kNumbers)
                    << "b " << b << ", beta_A " << beta << ", beta_B " << beta_b;
            }
        }
    }
}

// What hides half a bit more hides one more half of the time.
TEST(SlabChance, InDepthIsTheMeanOverRounding)
{
    for (const bool stratified : {true, false}) {
        for (const int b : {1, 5, 16, 128}) {
            const auto expected =
                reference::slab_chance({b, stratified, reference::SlabRounding::random,
                                        reference::SlabRounding::random, !stratified});
            for (int i = 0; i <= 20; ++i) {
                for (int j = 0; j <= 20; ++j) {
                    const float alpha_a = static_cast<float>(i) / 20, alpha_b = float(j) / 20;
                    // b products, each off by 2 u, of which 1 is taken off; and where b alpha is
                    // off by b u, chances that change by 1 for each.
                    EXPECT_NEAR(
                        static_cast<double>(Text::slab_chance(stratified, alpha_a, alpha_b, b)),
                        expected(static_cast<double>(alpha_a), static_cast<double>(alpha_b)),
                        (2 * b + 2 * b + 8) * 0x1p-24)
                        << stratified << " " << b << " " << i << " " << j;
                }
            }
        }
    }
}

namespace {

constexpr reference::Rgba kBackdrop = {0, 0, 1, 1};

StochasticLayers three_layers()
{
    return {{0.3, {1, 0.25, 0}, 2}, {0.55, {0, 0.75, 0.5}, 1}, {0.7, {0.5, 0, 1}, 3}};
}

struct Variant {
    SlabResolve resolve;
    const char* parameters;
};

constexpr Variant kVariants[] = {
    {SlabResolve::depth_corrected, ":correction=on"},
    {SlabResolve::depth_based, ""},
    {SlabResolve::color_corrected, ":depth-based=off:correction=on"},
    {SlabResolve::color, ":depth-based=off"},
};

using Expected = std::array<reference::Moments, 4>;

void expect_moments(const std::string& method, const StochasticLayers& layers,
                    const Expected& expected)
{
    SCOPED_TRACE(method);
    DrivenTile tile(method, 1);
    const Image image = tile.draw_picture(layers, 160, {}, [](int x, int y) {
        return TilePlace{x, y, 12345};
    });
    for (std::size_t c = 0; c < 3; ++c) {
        const Observed observed = observe(channel_of(image, c));
        reference::Moments moments = expected[c];
        // What is left of differences of numbers around 1: a chance that counts makes far more.
        if (moments.variance < 1e-15) moments.variance = 0;
        EXPECT_TRUE(mean_agrees(observed, moments)) << "channel " << c;
        EXPECT_TRUE(variance_agrees(observed, moments)) << "channel " << c;
    }
}

const char* name_of(Keep keep)
{
    return keep == Keep::purged ? "purged" : keep == Keep::visible ? "visible" : "nearest";
}

}  // namespace

TEST(SlabMoments, OfExplicitCoverage)
{
    const auto fragments = fragments_of(three_layers());
    for (const Variant& variant : kVariants) {
        for (const int bits : {1, 3, 5}) {
            for (const int layers : {1, 2, 3}) {
                for (const Keep keep : {Keep::purged, Keep::visible, Keep::nearest}) {
                    const auto expected = reference::slab_moments(fragments, layers, bits, keep,
                                                                  reference::stratified_chance,
                                                                  variant.resolve, kBackdrop);
                    expect_moments("slab:layers=" + std::to_string(layers) +
                                       ":bits=" + std::to_string(bits) + ":keep=" + name_of(keep) +
                                       variant.parameters,
                                   three_layers(), expected.channels);
                }
            }
        }
    }
}

// Decided once, when they arrive.
TEST(SlabMoments, OfImplicitCoverage)
{
    const auto fragments = fragments_of(three_layers());
    using reference::SlabRounding;
    for (const Variant& variant : kVariants) {
        for (const bool stratified : {true, false}) {
            for (const int bits : {2, 8, 128}) {
                const auto chance = reference::slab_chance(
                    {bits, stratified, SlabRounding::random, SlabRounding::random, !stratified});
                const auto expected = reference::slab_implicit_moments(fragments, 2, chance,
                                                                       variant.resolve, kBackdrop);
                expect_moments(
                    "slab:layers=2:coverage=implicit:keep=visible:bits=" + std::to_string(bits) +
                        ":probability=" + (stratified ? "stratified" : "naive") +
                        variant.parameters,
                    three_layers(), expected.channels);
            }
        }
    }
}

TEST(SlabMoments, OfSamplingInDepth)
{
    const auto fragments = fragments_of(three_layers());
    using reference::SlabRounding;
    for (const Variant& variant : kVariants) {
        for (const bool stratified : {true, false}) {
            for (const int bits : {2, 8}) {
                const auto chance = reference::slab_chance(
                    {bits, stratified, SlabRounding::random, SlabRounding::random, !stratified});
                const auto expected = reference::slab_systematic_moments(
                    fragments, 2, chance, variant.resolve, kBackdrop);
                expect_moments("slab:layers=2:coverage=implicit:sampling=in-depth:bits=" +
                                   std::to_string(bits) + ":probability=" +
                                   (stratified ? "stratified" : "naive") + variant.parameters,
                               three_layers(), expected.channels);
            }
        }
    }
}

// Layers that are asked again when others arrive before them are those of the order from near to
// far, in which no one is asked twice.
TEST(SlabMoments, OfPurgedImplicitCoverageNearToFar)
{
    StochasticLayers layers = three_layers();
    std::swap(layers[0], layers[1]);
    using reference::SlabRounding;
    const auto chance =
        reference::slab_chance({8, true, SlabRounding::random, SlabRounding::random, false});
    const auto expected = reference::slab_implicit_moments(fragments_of(layers), 3, chance,
                                                           SlabResolve::depth_based, kBackdrop);
    expect_moments("slab:layers=3:coverage=implicit:bits=8", layers, expected.channels);
}

// Explicit and uncorrected, with as many layers as bits: the mean is the truth.
TEST(SlabMoments, UncorrectedWithAsManyLayersAsBitsIsUnbiased)
{
    const StochasticLayers layers = {{0.3, {1, 0.25, 0}, 1},    {0.5, {0, 0.75, 0.5}, 2},
                                     {0.25, {0.5, 0, 0.25}, 3}, {0.5, {0.25, 1, 0}, 4},
                                     {0.9, {1, 0, 0.5}, 5},     {0.4, {0, 1, 0}, 6}};
    const reference::Rgba truth = reference::composite(fragments_of(layers), kBackdrop);
    const double colors[] = {truth.r, truth.g, truth.b};
    for (const int bits : {4, 8}) {
        for (const char* more : {"", ":depth-based=off"}) {
            const std::string same = std::to_string(bits);
            DrivenTile tile("slab:layers=" + same + ":bits=" + same + more, 1);
            const Image image = tile.draw_picture(layers, 320, {}, [](int x, int y) {
                return TilePlace{x, y, 99};
            });
            for (std::size_t c = 0; c < 3; ++c) {
                const Observed observed = observe(channel_of(image, c));
                EXPECT_TRUE(mean_agrees(observed, {colors[c], observed.variance, 0}))
                    << "bits " << bits << more << ", channel " << c;
            }
        }
    }
    // With fewer layers than bits it is not.
    DrivenTile tile("slab:layers=2:bits=8", 1);
    const Image image = tile.draw_picture(layers, 320, {}, [](int x, int y) {
        return TilePlace{x, y, 99};
    });
    const Observed observed = observe(channel_of(image, 1));
    EXPECT_FALSE(mean_agrees(observed, {colors[1], observed.variance, 0}));
}

}  // namespace sheer
