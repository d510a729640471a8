// Functions of a grid of pixels are those of each pixel by itself.
#include "compare/probe_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include <sheer/sheer.h>

#include "cpu/frame.h"

namespace sheer {
namespace {

const std::vector<std::string> kMethods = {"blend", "adaptive", "wboit", "mboit:moments=8"};

struct Drawn {
    Drawn(const char* source, int threads, std::size_t most_layers = ~std::size_t{0})
        : scene(load(source))
    {
        view.width = 70;
        view.height = 40;
        view.samples = 4;
        options.threads = threads;
        Probes probes(view.width, view.height, 30);
        positions = probes.results();
        ProbeFragments fragments(positions, most_layers);
        const Take take{.method = choose_method("blend"), .keys = {frame_key(0, 0)}};
        render_takes(scene, view, options, {.takes = {&take, 1}, .sink = &fragments});
        for (const PixelFragments& pixel : fragments.pixels()) {
            fragments_of.push_back(pixel.fragments.size());
        }
        curves = probe_curves(fragments, kMethods, setting());
    }
    DepthFunctionSetting setting() const { return {samples, targets_of(Simd::best), 0}; }

    Scene scene;
    View view;
    Options options;
    SampleSet samples = make_sample_set(4, SamplePositions::standard);
    std::vector<Probe> positions;
    std::vector<std::size_t> fragments_of;  // of each
    ProbeCurves curves;
};

// One pixel's fragments alone, as `sheer transmittance` has them.
PixelFragments alone(const Drawn& drawn, const Probe& probe)
{
    PixelFragments pixel(probe.x, probe.y);
    const PixelRect only{probe.x, probe.y, probe.x + 1, probe.y + 1};
    render_takes(drawn.scene, drawn.view, drawn.options,
                 {.takes = {}, .sink = &pixel, .only = &only});
    return pixel;
}

TEST(ProbeCurves, AreThoseOfEachPixel)
{
    const Drawn drawn("builtin:quads", 2);
    EXPECT_EQ(drawn.curves.methods, (std::vector<std::string>{"adaptive", "mboit:moments=8"}));
    ASSERT_EQ(drawn.curves.pixels.size(), drawn.positions.size());
    std::size_t seen = 0;
    for (std::size_t i = 0; i < drawn.positions.size(); i += 3) {
        const PixelFragments pixel = alone(drawn, drawn.positions[i]);
        const ProbeCurves::Pixel& curve = drawn.curves.pixels[i];
        ASSERT_EQ(curve.distances.empty(), pixel.fragments.empty()) << i;
        if (pixel.fragments.empty()) continue;
        ++seen;
        EXPECT_TRUE(std::is_sorted(curve.distances.begin(), curve.distances.end()));
        std::vector<float> depths;
        for (const double distance : curve.distances) {
            depths.push_back(static_cast<float>(pixel.eye.orthographic ? distance : -1 / distance));
        }
        for (std::size_t m = 0; m < drawn.curves.methods.size(); ++m) {
            const auto values = depth_function(choose_method(drawn.curves.methods[m]), pixel,
                                               depths, drawn.setting());
            // Distances and depths are one another's reciprocals, a rounding or two apart: beside a
            // step only one of both sides can be met. Everywhere else functions are smooth.
            std::size_t differing = 0;
            for (std::size_t k = 0; k < values.size(); ++k) {
                differing += std::abs(values[k] - curve.values[m][k]) > 1e-4 ? 1 : 0;
            }
            EXPECT_LE(differing, 2 * pixel.fragments.size() * 4) << drawn.curves.methods[m];
        }
    }
    EXPECT_GT(seen, 2u);
}

TEST(ProbeCurves, OfPixelsWhoseFragmentsAreTooManyThereAreNone)
{
    const char* source = "builtin:foliage";
    const Drawn all(source, 2);
    constexpr std::size_t kMost = 6;
    const Drawn some(source, 2, kMost);
    std::size_t without = 0, with = 0;
    for (std::size_t i = 0; i < all.positions.size(); ++i) {
        const bool fits = all.fragments_of[i] <= kMost;
        EXPECT_EQ(some.fragments_of[i], fits ? all.fragments_of[i] : 0) << i;
        EXPECT_EQ(some.curves.pixels[i].distances,
                  fits ? all.curves.pixels[i].distances : std::vector<double>{})
            << i;
        if (all.fragments_of[i] > 0) ++(fits ? with : without);
    }
    EXPECT_GT(with, 3u);
    EXPECT_GT(without, 3u);
}

// Two layers are not too many for eight nodes: exact everywhere.
TEST(ProbeCurves, OfLayersThatAMethodKnowsExactly)
{
    const Drawn drawn("builtin:layers?alpha=0.5,0.25&depth=1,2", 2);
    for (const ProbeCurves::Pixel& pixel : drawn.curves.pixels) {
        ASSERT_FALSE(pixel.distances.empty());
        for (std::size_t k = 0; k < pixel.distances.size(); ++k) {
            const double distance = pixel.distances[k];
            if (std::abs(distance - 1) < 1e-5 || std::abs(distance - 2) < 1e-5) continue;
            const double right = distance < 1 ? 1 : distance < 2 ? 0.5 : 0.375;
            EXPECT_NEAR(pixel.values[0][k], right, 1e-6) << distance;
        }
    }
}

TEST(ProbeCurves, DoNotDependOnThreads)
{
    const Drawn one("builtin:quads", 1), three("builtin:quads", 3);
    for (std::size_t i = 0; i < one.curves.pixels.size(); ++i) {
        EXPECT_EQ(one.curves.pixels[i].distances, three.curves.pixels[i].distances);
        EXPECT_EQ(one.curves.pixels[i].values, three.curves.pixels[i].values);
    }
}

}  // namespace
}  // namespace sheer
