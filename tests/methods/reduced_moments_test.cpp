// Functions of a picture of fewer pixels, as a tile's pixels read them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include <sheer/error.h>

#include "methods/pixel_oracle.h"
#include "methods/reduced_moments.h"
#include "methods/rounding.h"

namespace sheer {
namespace {

using test::State;
using test::Sums;

// Pixels of a tile at its left upper corner (64, 32), as Tile has it.
constexpr int kTileX = 64, kTileY = 32;

// Each texel that of some fragments, more than moments know.
ReducedMoments random_texels(const test::TransmittanceFunction& function, int reduction,
                             int numbers, std::mt19937& random)
{
    ReducedMoments r(200, 90, reduction, numbers);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int y = 0; y < r.height; ++y) {
        for (int x = 0; x < r.width; ++x) {
            for (std::size_t set = 0; set < static_cast<std::size_t>(numbers) / 5; ++set) {
                Sums sums(5);
                for (int i = 0; i < 9; ++i) {
                    function.add(sums, 2 * uniform(random) - 1, 0.3f * uniform(random));
                }
                for (std::size_t k = 0; k < 5; ++k) r.row(y, 5 * set + k)[x] = sums[k];
            }
        }
    }
    return r;
}

// By the distance of centres from texel to texel, in texels; beyond the last ones is more of these.
Sums mixed(const ReducedMoments& r, int x, int y, std::size_t set)
{
    const double column = (x + 0.5) / r.picture_width * r.width - 0.5;
    const double row = (y + 0.5) / r.picture_height * r.height - 0.5;
    Sums sums(5);
    for (int j = static_cast<int>(std::floor(row)), end = j + 2; j < end; ++j) {
        for (int i = static_cast<int>(std::floor(column)), last = i + 2; i < last; ++i) {
            const double weight = (1 - std::abs(row - j)) * (1 - std::abs(column - i));
            const int ty = std::clamp(j, 0, r.height - 1), tx = std::clamp(i, 0, r.width - 1);
            for (std::size_t k = 0; k < 5; ++k) sums[k] += weight * r.row(ty, 5 * set + k)[tx];
        }
    }
    return sums;
}

// What the pixel's own fragments have more than the mixture goes where it brings their mean.
void add_missing(const Plates& plates, const test::CoveringFragments& f, Sums& sums)
{
    double own = 0, own_first = 0;
    for (std::size_t i = 0; i < plates.size(); ++i) {
        const double depth =
            static_cast<double>(test::FloatText::optical_depth(plates[i].color[3]) * f.parts[i]);
        own += depth;
        own_first += depth * static_cast<double>(f.places[i]);
    }
    const double more = own - sums[0];
    if (more < 0) {
        for (double& sum : sums) sum *= own / (own - more);
        return;
    }
    const double place = std::clamp((own_first - sums[1]) / more, -1.0, 1.0);
    for (std::size_t k = 0; k < 5; ++k) sums[k] += more * std::pow(place, k);
}

// Doubles are off by 2^-50 here, which the least of the bias, 3e-7, makes 3e-9 of a kept number: a
// float of it may be the next one. T changes by less than 1e-4 with that.
constexpr double kNextFloat = 1e-4;

TEST(ReducedMoments, PixelsReadTheFourTexelsAround)
{
    for (const char* name :
         {"moment:resolution=1/8", "moment:resolution=1/4:moment-passes=2",
          "moment:resolution=1/2:upsample=depth-aware", "moment:resolution=1/8:overestimation=0"}) {
        const ChosenMethod method = choose_method(name);
        const MethodTraits traits = method.traits();
        const auto function = test::transmittance_function(method);
        for (const int samples : {1, 4}) {
            const SampleSet set = make_sample_set(samples, SamplePositions::standard);
            std::mt19937 random(static_cast<unsigned>(samples));
            const ReducedMoments texels =
                random_texels(*function, traits.reduction, traits.reduced_numbers, random);
            Plates plates = RandomPlates{set, random}.make(7);
            for (Plate& plate : plates) plate.color[3] = std::min(plate.color[3], 0.9f);
            Setting setting{method, &set};
            setting.reduced = &texels;
            const Colors backdrop = random_backdrop(set, random);
            const Colors result = resolve_plates(setting, plates, backdrop);
            for (std::size_t used = 0; used < kUsedPixels; ++used) {
                const auto over = test::fragments_over(plates, setting, used);
                const auto pixel = static_cast<int>(tile_pixel(used));
                const int x = kTileX + pixel % kTileSize, y = kTileY + pixel / kTileSize;
                Sums sums = mixed(texels, x, y, 0);
                if (name == std::string("moment:resolution=1/2:upsample=depth-aware")) {
                    add_missing(plates, over, sums);
                }
                State state = function->prepare(sums);
                if (traits.reduced_passes == 2) {
                    state = function->prepare_again(state, mixed(texels, x, y, 1));
                }
                const auto color = test::mean_color(plates, over, *function, state);
                EXPECT_LE(test::largest_error(plates, setting, used, color, backdrop, result),
                          rounding_bound(method, plates.size()).as_formula + kNextFloat)
                    << name << ", S = " << samples;
            }
        }
    }
}

// Sixteen pixels are two texels: the fourth pixel's centre is half a pixel from the first texel's.
TEST(ReducedMoments, TexelsCentresAreThoseOfTheirPixels)
{
    const TexelPair before(3, 16, 2), behind(4, 16, 2), last(15, 16, 2);
    EXPECT_EQ(before.first, 0);
    EXPECT_EQ(before.part, 0);
    EXPECT_EQ(behind.first, 0);
    EXPECT_EQ(behind.second, 1);
    EXPECT_DOUBLE_EQ(behind.part, 0.5 / 8);
    EXPECT_EQ(last.first, 1);
    EXPECT_EQ(last.second, 1);
}

TEST(ReducedMoments, QuantisedOnesCantBeMixed)
{
    try {
        check_method(choose_method("moment:resolution=1/4:format=nlqm"), 1);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("format=fp16"), std::string::npos);
    }
    check_method(choose_method("moment:format=nlqm"), 1);
}

}  // namespace
}  // namespace sheer
