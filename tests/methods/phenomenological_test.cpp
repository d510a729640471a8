// Coloured glass through phenomenological transparency: every channel is multiplied by what all
// fragments let through of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "methods/rounding.h"
#include "methods/tile_fixture.h"
#include "reference/phenomenological.h"
#include "simd_levels.h"

namespace sheer {

namespace {

using Through = std::array<float, 3>;

// What the plate of a number lets through; its opacity is 1 - the mean.
struct Glass {
    Plates plates;
    std::vector<Through> through;
};

Glass random_glass(const SampleSet& set, std::mt19937& random, int count)
{
    std::uniform_real_distribution<float> uniform(0, 1);
    Glass glass{RandomPlates{set, random}.make(count), {}};
    for (Plate& plate : glass.plates) {
        const Through t = {uniform(random), uniform(random), uniform(random)};
        plate.color[3] = 1 - (t[0] + t[1] + t[2]) / 3;
        glass.through.push_back(t);
    }
    return glass;
}

constexpr EyeSpace kEye = {true, 0.1f, 500.0f};

Colors resolve_glass(const Glass& glass, const SampleSet& set, const Colors& backdrop, Simd level)
{
    const ChosenMethod method = choose_method("phenomenological");
    const StoreVerbs verbs = method.row->colored_verbs(targets_of(level), method, set.count);
    FragmentStream stream(4096, true);
    fill_stream(glass.plates, stream);
    for (int r = 0; r < stream.run_count; ++r) {
        const FragmentRun& run = stream.runs[r];
        const Through& through = glass.through[run.primitive];
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            stream.through_red[i] = through[0];
            stream.through_green[i] = through[1];
            stream.through_blue[i] = through[2];
        }
    }
    const auto store = verbs.make({&set, &method, kEye, 4096});
    verbs.clear(store.get(), {});
    verbs.insert(store.get(), stream, 0);
    SampleColors colors(set.count);
    std::copy(backdrop.begin(), backdrop.end(), colors.values.data());
    verbs.resolve(store.get(), colors);
    return {colors.values.data(), colors.values.data() + colors.values.size()};
}

}  // namespace

TEST(Phenomenological, ColouredGlassIsWhatTheFormulaGives)
{
    constexpr int kCount = 40;
    const double bound =
        rounding_bound(choose_method("phenomenological"), kCount).as_formula + 4 * kUnit;
    for (const SampleSet& set : sample_sets()) {
        std::mt19937 random(static_cast<unsigned>(set.count));
        const Glass glass = random_glass(set, random, kCount);
        const Colors backdrop = random_backdrop(set, random);
        const Colors got = resolve_glass(glass, set, backdrop, Simd::best);
        for (std::size_t used = 0; used < kUsedPixels; ++used) {
            for (std::size_t s = 0; s < static_cast<std::size_t>(set.count); ++s) {
                auto fragments = fragments_at(glass.plates, set, used, s);
                for (auto& f : fragments) {
                    const Plate& plate = glass.plates[f.id];
                    const float depth = depth_at_center(plate.depth, tile_pixel(used));
                    f.depth = (static_cast<double>(depth) - static_cast<double>(kEye.znear)) /
                              static_cast<double>(kEye.zfar - kEye.znear);
                    for (std::size_t c = 0; c < 3; ++c) {
                        f.transmittance[c] = static_cast<double>(glass.through[f.id][c]);
                    }
                }
                const auto at = [&](const Colors& colors, std::size_t c) {
                    return static_cast<double>(colors[color_index(set, tile_pixel(used), s, c)]);
                };
                const auto expected = reference::phenomenological(
                    fragments, reference::BackdropPart::mean,
                    {at(backdrop, 0), at(backdrop, 1), at(backdrop, 2), at(backdrop, 3)});
                const double channels[] = {expected.r, expected.g, expected.b, expected.a};
                for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(at(got, c), channels[c], bound);
            }
        }
    }
}

TEST(Phenomenological, ColouredGlassHasTheSameBitsAtEveryLevel)
{
    for (const SampleSet& set : sample_sets()) {
        std::mt19937 random(static_cast<unsigned>(set.count));
        const Glass glass = random_glass(set, random, 60);
        const Colors backdrop = random_backdrop(set, random);
        const Colors expected = resolve_glass(glass, set, backdrop, Simd::scalar);
        for (const Simd level : simd_levels()) {
            EXPECT_TRUE(same_bits(resolve_glass(glass, set, backdrop, level), expected));
        }
    }
}

// Black glass adds nothing: the background is multiplied by each channel's product, in any order.
TEST(Phenomenological, TheBackgroundIsMultipliedExactly)
{
    const SampleSet& set = sample_sets()[2];
    std::mt19937 random(3);
    Glass glass = random_glass(set, random, 12);
    for (Plate& plate : glass.plates) {
        plate.color = {0, 0, 0, plate.color[3]};
        plate.samples[0] = set.all();
    }
    const Colors white(4 * kTilePixels * 4, 1.0f);
    double expected[3] = {1, 1, 1};
    for (const Through& t : glass.through) {
        for (std::size_t c = 0; c < 3; ++c) expected[c] *= static_cast<double>(t[c]);
    }
    for (int round = 0; round < 5; ++round) {
        std::shuffle(glass.plates.begin(), glass.plates.end(), random);
        const Colors got = resolve_glass(glass, set, white, Simd::best);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto color = static_cast<double>(got[color_index(set, tile_pixel(0), 0, c)]);
            EXPECT_NEAR(color, expected[c], 12 * kUnit * expected[c]);  // 12 products
        }
    }
}

}  // namespace sheer
