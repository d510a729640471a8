// Multi-layer coverage blending: with enough layers it is stochastic layered alpha blending; with
// fewer it is what an oracle makes of its masks, and no bit is lost.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lanes/lone.h"
#include "methods/mlcb_settings.h"
#include "methods/rounding.h"
#include "methods/slab_answers.h"
#include "methods/texts_alone.h"
#include "methods/tile_fixture.h"
#include "reference/mlcb.h"

namespace sheer {

namespace {

using Text = test::Texts<Lone<float>>;

constexpr TilePlace kPlace = {64, 32, 0x1234567u};  // of resolve_plates

SampleSet one_sample()
{
    return make_sample_set(1, SamplePositions::center);
}

Plates random_plates(int count, unsigned seed)
{
    std::mt19937 random(seed);
    const SampleSet set = one_sample();
    return RandomPlates{set, random}.make(count);
}

reference::SlabMask mask_of(const Plate& plate, std::uint32_t pixel, int bits)
{
    const std::uint32_t seed =
        Text::fragment_seed(static_cast<std::uint32_t>(kPlace.x) + pixel % kTileSize,
                            static_cast<std::uint32_t>(kPlace.y) + pixel / kTileSize,
                            Text::identity_seed(plate.primitive, kPlace.key));
    const auto drawn = Text::slab_random_mask(seed, 0, 1u << 24, plate.color[3], bits);
    return reference::SlabMask(drawn.a) | reference::SlabMask(drawn.b) << 32;
}

double alpha_of(const std::vector<reference::Fragment>& fragments)
{
    double through = 1;
    for (const reference::Fragment& f : fragments) through *= 1 - f.opacity;
    return 1 - through;
}

}  // namespace

class MlcbOracle : public testing::TestWithParam<const char*> {};

TEST_P(MlcbOracle, PicturesAreThoseOfItsMasks)
{
    const SampleSet set = one_sample();
    const ChosenMethod method = choose_method(GetParam());
    const SlabSettings settings = mlcb_settings(method);
    const Plates plates = random_plates(40, 7);
    std::mt19937 random(8);
    const Colors backdrop = random_backdrop(set, random);
    const Colors result = resolve_plates({method, &set}, plates, backdrop);
    const double bound = rounding_bound(method, plates.size()).as_formula;
    for (std::size_t used = 0; used < kUsedPixels; ++used) {
        const std::uint32_t pixel = tile_pixel(used);
        const auto fragments = fragments_at(plates, set, used, 0);
        std::vector<reference::SlabMask> masks;
        for (const reference::Fragment& fragment : fragments) {
            masks.push_back(mask_of(plates[fragment.id], pixel, settings.bits));
        }
        const auto layers =
            reference::mlcb_layers(fragments, masks, settings.layers, test::slab_keep_of(settings));
        const auto behind = [&](std::size_t c) {
            return static_cast<double>(backdrop[color_index(set, pixel, 0, c)]);
        };
        const reference::Rgba back = {behind(0), behind(1), behind(2), behind(3)};
        const reference::Rgba expected =
            settings.corrects
                ? reference::mlcb_resolve(layers, settings.bits, alpha_of(fragments), back)
                : reference::mlcb_resolve_uncorrected(layers, settings.bits, back);
        const double channels[] = {expected.r, expected.g, expected.b};
        for (std::size_t c = 0; c < 3; ++c) {
            const float got = result[color_index(set, pixel, 0, c)];
            EXPECT_NEAR(static_cast<double>(got), channels[c], bound) << "pixel " << used;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Parameters, MlcbOracle,
                         testing::Values("mlcb", "mlcb:layers=1:bits=8",
                                         "mlcb:layers=2:bits=33:correction=off",
                                         "mlcb:layers=4:bits=64:keep=visible",
                                         "mlcb:layers=3:bits=16:keep=nearest:correction=off",
                                         "mlcb:layers=3:bits=64:keep=nearest"));

// Which has been shown to be stochastic transparency with the same masks.
TEST(Mlcb, WithAsManyLayersAsBitsItIsSlab)
{
    const SampleSet set = one_sample();
    const Plates plates = random_plates(30, 3);
    const Colors black(4 * kTilePixels);
    for (const char* more : {":correction=off", ":correction=on"}) {
        for (const char* size : {"layers=4:bits=4", "layers=32:bits=8", "layers=32:bits=32"}) {
            const auto result = [&](const std::string& method) {
                return resolve_plates({choose_method(method + ":" + size + more), &set}, plates,
                                      black);
            };
            const auto slab = resolve_plates(
                {choose_method(std::string("slab:depth-based=off:") + size + more), &set}, plates,
                black);
            EXPECT_TRUE(same_bits(result("mlcb"), slab)) << size << more;
        }
    }
}

// What all masks together cover, where layers are joined and where they are forgotten: the part
// that one layer keeps of the others' bits is what tells the two apart.
TEST(Mlcb, NoBitIsLost)
{
    const SampleSet set = one_sample();
    const Plates plates = random_plates(30, 5);
    const Colors black(4 * kTilePixels);
    const auto alpha_with = [&](const std::string& method) {
        const Colors result = resolve_plates({choose_method(method), &set}, plates, black);
        std::vector<double> alphas;
        for (std::size_t used = 0; used < kUsedPixels; ++used) {
            alphas.push_back(static_cast<double>(result[color_index(set, tile_pixel(used), 0, 3)]));
        }
        return alphas;
    };
    // Parts of 16 are floats; their sums are exact.
    const auto all = alpha_with("mlcb:layers=16:bits=16:correction=off");
    EXPECT_EQ(alpha_with("mlcb:layers=1:bits=16:correction=off"), all);
    EXPECT_EQ(alpha_with("mlcb:layers=3:bits=16:keep=visible:correction=off"), all);
    EXPECT_NE(alpha_with("slab:layers=1:bits=16:depth-based=off"), all);
}

// Joined again and again behind everything, as few layers are as good as many: nothing comes
// between. The other way round it is not so.
TEST(Mlcb, FromNearToFarOneLayerIsEnough)
{
    const SampleSet set = one_sample();
    Plates plates = random_plates(20, 9);
    for (std::size_t i = 0; i < plates.size(); ++i) {
        plates[i].depth = make_plane(1 + static_cast<double>(i), 0, 0);
    }
    const Colors black(4 * kTilePixels);
    const auto difference = [&] {
        const auto result = [&](const std::string& layers) {
            return resolve_plates(
                {choose_method("mlcb:bits=32:correction=off:layers=" + layers), &set}, plates,
                black);
        };
        return largest_difference(result("1"), result("32"));
    };
    EXPECT_LE(difference(),
              2 * rounding_bound(choose_method("mlcb:correction=off"), plates.size()).as_formula);
    std::reverse(plates.begin(), plates.end());
    EXPECT_GT(difference(), 0.01);
}

}  // namespace sheer
