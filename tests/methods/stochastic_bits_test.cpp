// Random pictures, bit for bit: the seed alone decides.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include <sheer/sheer.h>

#include "methods/every_method.h"
#include "simd_levels.h"

namespace sheer {

namespace {

// Two tiles and a bit across, so that threads have something to share.
View small_view(int samples)
{
    View view;
    view.width = 80;
    view.height = 70;
    view.samples = samples;
    return view;
}

std::vector<Float4> pixels(const Scene& scene, int samples, const Options& options)
{
    return render(scene, small_view(samples), options).image.pixels;
}

// Of different colours, whose shares no correction gets right. The nearest is so faint that even
// one of 128 bits, each for itself, is not sure to be set.
constexpr const char* kLayers =
    "builtin:layers?alpha=0.02,0.3,0.6,0.4&color=1,1,0;1,0,0;0,1,0;0,0.5,1&background=0.2,0,0.9";

}  // namespace

TEST(StochasticBits, OneSeedOnePicture)
{
    const Scene scene = load("builtin:quads");
    Scene shuffled = scene;
    std::mt19937 random(5);
    std::shuffle(shuffled.objects.begin(), shuffled.objects.end(), random);
    for (const ChosenMethod& method : every_choice(*choose_method("stochastic").row)) {
        const bool any_order = method.traits().any_order == Agreement::bits;
        for (const int samples : {1, 8, 64}) {
            if (is_refused(method, samples)) continue;
            Options options;
            options.method = name_of(method);
            options.seed = 123456789012345ull;
            options.accumulate = 2;
            options.threads = 1;
            options.simd = Simd::scalar;
            const auto expected = pixels(scene, samples, options);
            for (const Simd level : simd_levels()) {
                // What threads do does not depend on the level.
                for (const int threads : {1, 2, 7}) {
                    if (threads != 2 && level != simd_levels().back()) continue;
                    options.simd = level;
                    options.threads = threads;
                    const Scene& submitted = threads == 2 && any_order ? shuffled : scene;
                    EXPECT_EQ(pixels(submitted, samples, options), expected)
                        << options.method << ", S = " << samples << ", "
                        << name_of_targets(targets_of(level)) << ", " << threads << " threads";
                }
            }
        }
    }
}

TEST(StochasticBits, SeedsDiffer)
{
    // In the ramps of opacity a seed shows even where it decides for all pixels alike.
    const Scene layers = load(kLayers), ramps = load("builtin:quads");
    for (const ChosenMethod& method : every_method()) {
        if (method.row->bench_only || is_refused(method, 8)) continue;
        std::set<std::vector<Float4>> different;
        constexpr std::uint64_t kSeeds[] = {0, ~0ull, 1, 2, 1ull << 32};
        // Two tell what any number of them would of a picture that knows none.
        for (std::size_t i = 0; i < (method.traits().random ? std::size(kSeeds) : 2); ++i) {
            Options options;
            options.method = name_of(method);
            options.seed = kSeeds[i];
            std::vector<Float4> both = pixels(layers, 8, options);
            const std::vector<Float4> others = pixels(ramps, 8, options);
            both.insert(both.end(), others.begin(), others.end());
            different.insert(both);
        }
        EXPECT_EQ(different.size(), method.traits().random ? 5u : 1u) << name_of(method);
    }
}

TEST(StochasticBits, OnlyPicturesThatVaryByFrameChangeWhenTheyAreAccumulated)
{
    const Scene scene = load(kLayers);
    for (const ChosenMethod& method : every_method()) {
        if (method.row->bench_only || is_refused(method, 8)) continue;
        Options options;
        options.method = name_of(method);
        const auto one = pixels(scene, 8, options);
        options.accumulate = 7;
        const MethodTraits traits = method.traits();
        EXPECT_EQ(pixels(scene, 8, options) != one, traits.random || traits.by_frame)
            << options.method;
    }
}

}  // namespace sheer
