// One function for each pixel, of fragments that take the part of it that they cover.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "methods/pixel_oracle.h"
#include "methods/rounding.h"

namespace sheer {
namespace {

// Each sample has the total alpha of what covers it, and the pixel's mean colour.
TEST(PixelStore, IsTheFunctionOfWhatCoversThePixel)
{
    for (const char* name :
         {"moment:store=pixel", "moment:store=pixel:moment-passes=2",
          "moment:store=pixel:format=nlqm:overestimation=0", "mboit:store=pixel:moments=6",
          "mboit:store=pixel:basis=trigonometric", "fourier:store=pixel", "wavelet:store=pixel"}) {
        const ChosenMethod method = choose_method(name);
        const auto function = test::transmittance_function(method);
        for (const SampleSet& set : sample_sets()) {
            std::mt19937 random(static_cast<unsigned>(set.count));
            Plates plates = RandomPlates{set, random}.make(12);
            for (Plate& plate : plates) plate.color[3] = std::min(plate.color[3], 0.9f);
            const Setting setting{method, &set};
            const Colors backdrop = random_backdrop(set, random);
            const Colors result = resolve_plates(setting, plates, backdrop);
            const double bound = rounding_bound(method, plates.size()).as_formula;
            for (std::size_t used = 0; used < kUsedPixels; ++used) {
                const auto over = test::fragments_over(plates, setting, used);
                const auto color = test::mean_color(plates, over, *function,
                                                    test::state_over(plates, over, *function));
                EXPECT_LE(test::largest_error(plates, setting, used, color, backdrop, result),
                          bound)
                    << name << ", S = " << set.count;
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
        {"wboit", 12},
        {"moment", 32},
        {"moment:format=nlqm", 42},
        {"moment:moment-passes=2", 52},
        {"moment:resolution=1/8", 12.3125},
        {"moment:resolution=1/8:moment-passes=2", 12.625}};
    for (const auto& [name, bytes] : rows) {
        EXPECT_EQ(choose_method(name).traits().texture_bytes, bytes) << name;
    }
}

}  // namespace
}  // namespace sheer
