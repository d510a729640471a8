// Stochastic layered alpha blending at its two ends: as many layers as bits are stochastic
// transparency, with the same masks; bits without number are a k-buffer. And with the layers that
// its masks leave, by an oracle, in between.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "lanes/lone.h"
#include "methods/rounding.h"
#include "methods/slab_answers.h"
#include "methods/texts_alone.h"
#include "methods/tile_fixture.h"
#include "reference/slab.h"

namespace sheer {

namespace {

using Text = test::Texts<Lone<float>>;

SampleSet centered(int samples)
{
    return make_sample_set(samples, SamplePositions::center);
}

// At whole pixels: each plate covers half of those used, as a whole.
Plates random_plates(int count, std::uint32_t seed)
{
    std::mt19937 random(seed);
    const SampleSet set = centered(1);
    return RandomPlates{set, random}.make(count);
}
Plates at_all_samples(Plates plates, const SampleSet& set)
{
    for (Plate& plate : plates) {
        for (std::uint64_t& samples : plate.samples) samples = samples != 0 ? set.all() : 0;
    }
    return plates;
}

Colors black(const SampleSet& set)
{
    return Colors(4 * kTilePixels * static_cast<std::size_t>(set.count));
}

double mean_over_samples(const SampleSet& set, const Colors& colors, std::size_t used,
                         std::size_t channel)
{
    double sum = 0;
    for (std::size_t s = 0; s < static_cast<std::size_t>(set.count); ++s) {
        sum += static_cast<double>(colors[color_index(set, tile_pixel(used), s, channel)]);
    }
    return sum / set.count;
}

// How many of `bits` samples or bits each plate is seen through, in each used pixel: by pictures in
// which it alone has a colour. 0 where it is not there.
std::vector<double> visible_counts(const std::string& method, const SampleSet& set, int bits,
                                   const Plates& plates)
{
    std::vector<double> counts(plates.size() * kUsedPixels);
    for (std::size_t first = 0; first < plates.size(); first += 3) {
        Plates colored = at_all_samples(plates, set);
        for (std::size_t i = 0; i < plates.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) colored[i].color[c] = i == first + c ? 1.0f : 0.0f;
        }
        const Colors result = resolve_plates({choose_method(method), &set}, colored, black(set));
        for (std::size_t used = 0; used < kUsedPixels; ++used) {
            for (std::size_t c = 0; c < 3 && first + c < plates.size(); ++c) {
                const double opacity = static_cast<double>(plates[first + c].color[3]);
                counts[(first + c) * kUsedPixels + used] =
                    mean_over_samples(set, result, used, c) * bits / opacity;
            }
        }
    }
    return counts;
}

// Both as whole numbers. How many differ.
int differing_counts(const std::string& slab, const std::string& stochastic, int bits,
                     std::uint32_t seed)
{
    const Plates plates = random_plates(18, seed);
    const std::vector<double> ours = visible_counts(slab, centered(1), bits, plates);
    const std::vector<double> theirs =
        visible_counts("stochastic:depth-based=on" + stochastic, centered(bits), bits, plates);
    int differing = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        // Sums of up to `bits` equal terms.
        EXPECT_NEAR(ours[i], std::round(ours[i]), 64 * bits * kUnit);
        EXPECT_NEAR(theirs[i], std::round(theirs[i]), 64 * bits * kUnit);
        differing += std::round(ours[i]) != std::round(theirs[i]);
    }
    return differing;
}

std::string slab_with(int layers, int bits, const std::string& more = "")
{
    return "slab:layers=" + std::to_string(layers) + ":bits=" + std::to_string(bits) + more;
}

double largest_difference_of(const Image& a, const Image& b)
{
    double most = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
            const double one = static_cast<double>(a.pixels[i][c]);
            const double other = static_cast<double>(b.pixels[i][c]);
            most = std::max(most, std::abs(one - other) / std::max(1.0, std::abs(one)));
        }
    }
    return most;
}

Image picture(const Scene& scene, const std::string& method, int samples, int size)
{
    View view;
    view.width = view.height = size;
    view.samples = samples;
    view.positions = SamplePositions::center;
    Options options;
    options.method = method;
    options.seed = 5;
    return render(scene, view, options).image;
}

}  // namespace

TEST(Slab, WithAsManyLayersAsBitsFragmentsAreSeenThroughTheSamplesOfStochasticTransparency)
{
    for (const int bits : {1, 2, 4, 8, 16, 32}) {
        for (const int layers : {bits, 32}) {
            for (const std::uint32_t seed : {1u, 2u}) {
                EXPECT_EQ(differing_counts(slab_with(layers, bits), "", bits, seed), 0)
                    << "layers " << layers << ", bits " << bits;
            }
        }
    }
}

// The same test finds other masks, a layer too few, and hidden layers in the place of others.
TEST(Slab, OtherwiseTheyAreNot)
{
    EXPECT_GT(differing_counts(slab_with(8, 8), ":masks=naive", 8, 1), 0);
    EXPECT_GT(differing_counts(slab_with(3, 8), "", 8, 1), 0);
    EXPECT_GT(differing_counts(slab_with(4, 16), "", 16, 1), 0);
    EXPECT_GT(differing_counts(slab_with(4, 4, ":keep=nearest"), "", 4, 1), 0);
}

// n terms of a sum, in two orders: (n + 3) u of it each, and n is 8 here and some 20 there.
TEST(Slab, WithAsManyLayersAsBitsPicturesAreThoseOfStochasticTransparency)
{
    const Scene layers = load("builtin:layers?n=8&alpha=0.3&order=random&seed=3");
    const Scene foliage = load("builtin:foliage");
    for (const char* correction : {"", ":correction=on"}) {
        for (const int bits : {4, 8, 16}) {
            const std::string ours = slab_with(bits, bits, correction);
            const std::string theirs = std::string("stochastic:depth-based=on") + correction;
            EXPECT_LE(largest_difference_of(picture(layers, ours, 1, 64),
                                            picture(layers, theirs, bits, 64)),
                      1e-6);
            EXPECT_LE(largest_difference_of(picture(foliage, ours, 1, 40),
                                            picture(foliage, theirs, bits, 40)),
                      2 * 40 * kUnit);
        }
        // Without depths they are the basic method's.
        const std::string basic = std::string(":depth-based=off") + correction;
        EXPECT_LE(largest_difference_of(picture(foliage, slab_with(8, 8, basic), 1, 40),
                                        picture(foliage, "stochastic" + basic, 8, 40)),
                  2 * 40 * kUnit);
    }
}

// Layers that show themselves.
TEST(Slab, WithBitsWithoutNumberItIsAKBufferThatDiscards)
{
    for (const SampleSet& set : sample_sets()) {
        std::mt19937 random(static_cast<unsigned>(set.count));
        const Plates plates = RandomPlates{set, random}.make(30);
        const Colors backdrop = random_backdrop(set, random);
        for (const char* layers : {"1", "4", "8", "32"}) {
            const auto result = [&](const std::string& method, const std::string& more) {
                return resolve_plates({choose_method(method + ":layers=" + layers + more), &set},
                                      plates, backdrop);
            };
            for (const char* coverage : {"explicit", "implicit"}) {
                const std::string endless =
                    std::string(":bits=infinity:depth-based=off:coverage=") + coverage;
                EXPECT_LE(
                    largest_difference(result("slab", endless), result("hybrid", ":tail=none")),
                    1e-6);
                EXPECT_LE(largest_difference(result("slab", endless),
                                             result("k-buffer", ":merge=discard")),
                          1e-6);
                EXPECT_LE(largest_difference(result("slab", endless + ":correction=on"),
                                             result("hybrid", ":tail=scaled")),
                          1e-6);
            }
        }
    }
}

TEST(Slab, WithBitsWithoutNumberThereIsNoNoise)
{
    const Scene foliage = load("builtin:foliage");
    const auto with_seed = [&](const std::string& method, std::uint64_t seed) {
        View view;
        view.width = view.height = 32;
        view.samples = 4;
        Options options;
        options.method = method;
        options.seed = seed;
        return render(foliage, view, options).image;
    };
    for (const std::string more : {"", ":depth-based=off", ":correction=on", ":tail=dropped"}) {
        const std::string endless = "slab:bits=infinity" + more;
        EXPECT_EQ(with_seed(endless, 1).pixels, with_seed(endless, 2).pixels) << endless;
    }
    EXPECT_NE(with_seed("slab:bits=128", 1).pixels, with_seed("slab:bits=128", 2).pixels);
}

// The store by an oracle, whose masks are the text's.
class SlabOracle : public testing::TestWithParam<const char*> {
protected:
    static reference::SlabMask mask_of(const Plate& plate, std::uint32_t pixel, int bits)
    {
        const std::uint32_t seed =
            Text::fragment_seed(64 + pixel % kTileSize, 32 + pixel / kTileSize,
                                Text::identity_seed(plate.primitive, 0x1234567u));
        const auto drawn = Text::slab_random_mask(seed, 0, 1u << 24, plate.color[3], bits);
        reference::SlabMask mask;
        const std::uint32_t words[4] = {drawn.a, drawn.b, drawn.c, drawn.d};
        for (std::size_t i = 0; i < 128; ++i) mask[i] = (words[i / 32] >> i % 32 & 1) != 0;
        return mask;
    }
};

TEST_P(SlabOracle, PicturesAreThoseOfItsMasks)
{
    const SampleSet set = centered(1);
    const ChosenMethod method = choose_method(GetParam());
    const SlabSettings settings = slab_settings(method);
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
        const auto behind = [&](std::size_t c) {
            return static_cast<double>(backdrop[color_index(set, pixel, 0, c)]);
        };
        const reference::Rgba expected = reference::slab(
            fragments,
            reference::slab_store(fragments, masks, settings.layers, settings.bits,
                                  test::slab_keep_of(settings)),
            test::slab_resolve_of(settings), {behind(0), behind(1), behind(2), behind(3)});
        const double channels[] = {expected.r, expected.g, expected.b};
        for (std::size_t c = 0; c < 3; ++c) {
            const float got = result[color_index(set, pixel, 0, c)];
            EXPECT_NEAR(static_cast<double>(got), channels[c], bound) << "pixel " << used;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Parameters, SlabOracle,
    testing::Values("slab:layers=1:bits=8", "slab:layers=4:bits=1", "slab:layers=3:bits=8",
                    "slab:layers=4:bits=32", "slab:layers=4:bits=33:correction=on",
                    "slab:layers=5:bits=64:depth-based=off",
                    "slab:layers=8:bits=100:depth-based=off:correction=on",
                    "slab:layers=8:bits=128", "slab:layers=2:bits=128:keep=visible",
                    "slab:layers=3:bits=16:keep=visible:correction=on",
                    "slab:layers=3:bits=16:keep=nearest", "slab:layers=6:bits=65:keep=nearest",
                    "slab:layers=32:bits=128:correction=on"));

}  // namespace sheer
