// One function for each pixel, of fragments that take the part of it that they cover.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "methods/depth_range.h"
#include "methods/rounding.h"
#include "methods/tile_fixture.h"
#include "methods/transmittance_oracle.h"

namespace sheer {
namespace {

using test::FloatText;

// What lies over a pixel in the paper's sense: each fragment with the part that it covers.
struct PixelFragments {
    std::vector<float> places, parts;
};

PixelFragments fragments_over(const Plates& plates, const Setting& setting, std::size_t used)
{
    const DepthRange range = depth_range(setting.eye, true);
    PixelFragments f;
    for (const Plate& plate : plates) {
        const float depth = depth_at_center(plate.depth, tile_pixel(used));
        f.places.push_back(
            FloatText::warped_depth(range.is_distance, depth, range.from, range.scale));
        const auto covered = plate.samples[used] & setting.set->all();
        f.parts.push_back(static_cast<float>(std::popcount(covered)) /
                          static_cast<float>(setting.set->count));
    }
    return f;
}

// The mean colour that all of the pixel's samples show, by the text's function.
std::array<double, 3> mean_color(const Plates& plates, const Setting& setting, std::size_t used)
{
    const PixelFragments f = fragments_over(plates, setting, used);
    const auto function = test::transmittance_function(setting.method);
    test::State state;
    for (int pass = 0; pass < function->passes(); ++pass) {
        test::Sums sums(function->sums());
        for (std::size_t i = 0; i < plates.size(); ++i) {
            const float seen = pass == 0 ? 1 : function->transmittance(state, f.places[i]);
            const float depth = FloatText::optical_depth(plates[i].color[3] * seen);
            function->add(sums, f.places[i], depth * f.parts[i]);
        }
        state = pass == 0 ? function->prepare(sums) : function->prepare_again(state, sums);
    }
    double sum[3] = {}, weight = 0;
    for (std::size_t i = 0; i < plates.size(); ++i) {
        const auto through =
            static_cast<double>(std::max(function->transmittance(state, f.places[i]), 0x1p-30f));
        const double w =
            through * static_cast<double>(plates[i].color[3]) * static_cast<double>(f.parts[i]);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += w * static_cast<double>(plates[i].color[c]);
        weight += w;
    }
    const double divisor = weight > 0 ? weight : 1;
    return {sum[0] / divisor, sum[1] / divisor, sum[2] / divisor};
}

// Each sample has the total alpha of what covers it, and the pixel's mean colour.
TEST(PixelStore, IsTheFunctionOfWhatCoversThePixel)
{
    for (const char* name : {"moment:store=pixel", "moment:store=pixel:moment-passes=2",
                             "moment:store=pixel:format=nlqm:overestimation=0"}) {
        const ChosenMethod method = choose_method(name);
        for (const SampleSet& set : sample_sets()) {
            std::mt19937 random(static_cast<unsigned>(set.count));
            Plates plates = RandomPlates{set, random}.make(12);
            for (Plate& plate : plates) plate.color[3] = std::min(plate.color[3], 0.9f);
            const Setting setting{method, &set};
            const Colors backdrop = random_backdrop(set, random);
            const Colors result = resolve_plates(setting, plates, backdrop);
            const double bound = rounding_bound(method, plates.size()).as_formula;
            for (std::size_t used = 0; used < kUsedPixels; ++used) {
                const auto color = mean_color(plates, setting, used);
                for (std::size_t s = 0; s < static_cast<std::size_t>(set.count); ++s) {
                    double through = 1;
                    for (const Plate& plate : plates) {
                        if ((plate.samples[used] >> s & 1) == 0) continue;
                        through *= 1 - static_cast<double>(plate.color[3]);
                    }
                    for (std::size_t c = 0; c < 3; ++c) {
                        const std::size_t at = color_index(set, tile_pixel(used), s, c);
                        const double expected =
                            (1 - through) * color[c] + through * static_cast<double>(backdrop[at]);
                        EXPECT_NEAR(static_cast<double>(result[at]), expected, bound)
                            << name << ", S = " << set.count;
                    }
                }
            }
        }
    }
}

// Where every fragment covers all of a pixel, it is what every sample has of its own.
TEST(PixelStore, OfWholePixelsIsThatOfSamples)
{
    const SampleSet set = make_sample_set(8, SamplePositions::standard);
    std::mt19937 random(5);
    Plates plates = RandomPlates{set, random}.make(20);
    for (Plate& plate : plates) {
        plate.depth = make_plane(plate.depth.precise_at, 0, 0);
        plate.samples.fill(set.all());
    }
    const Colors backdrop = random_backdrop(set, random);
    const ChosenMethod of_samples = choose_method("moment"),
                       of_pixels = choose_method("moment:store=pixel");
    const Colors a = resolve_plates({of_samples, &set}, plates, backdrop);
    const Colors b = resolve_plates({of_pixels, &set}, plates, backdrop);
    EXPECT_LE(largest_difference(a, b), 2 * rounding_bound(of_samples, plates.size()).as_formula);
}

// The same bits in the pixels of a tile that nothing touches as without the method.
TEST(PixelStore, NothingOfALastTileIsLeft)
{
    const SampleSet set = make_sample_set(4, SamplePositions::standard);
    std::mt19937 random(6);
    const Setting setting{choose_method("moment:store=pixel"), &set};
    const StoreVerbs verbs =
        setting.method.row->verbs(targets_of(Simd::best), setting.method, set.count);
    const auto store = verbs.make({&set, &setting.method, setting.eye, 1024});
    SampleColors colors(set.count, true);
    std::fill_n(colors.fraction.values.data(), colors.fraction.values.size(), 3.0f);
    verbs.clear(store.get(), {});
    verbs.resolve(store.get(), colors);
    const float* values = colors.fraction.values.data();
    EXPECT_TRUE(std::all_of(values, values + colors.fraction.values.size(),
                            [](float x) { return x == 0; }));
}

TEST(TextureBytes, AreTheTableOfTheMomentPaper)
{
    const std::pair<const char*, double> rows[] = {
        {"wboit", 12}, {"moment", 32}, {"moment:format=nlqm", 42}, {"moment:moment-passes=2", 52}};
    for (const auto& [name, bytes] : rows) {
        EXPECT_EQ(choose_method(name).traits().texture_bytes, bytes) << name;
    }
}

}  // namespace
}  // namespace sheer
