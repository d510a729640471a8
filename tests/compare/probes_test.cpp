// Probes of a scene whose layers are known, and of fragments that cover a part of a pixel.
#include "compare/probes.h"

#include <gtest/gtest.h>

#include <sheer/sheer.h>

#include "cpu/frame.h"

namespace sheer {
namespace {

std::vector<Probe> probes_of(const char* source, Filter filter, int threads,
                             const char* method = "blend")
{
    const Scene scene = load(source);
    View view;
    view.width = 50;
    view.height = 40;
    view.samples = 4;
    view.filter = filter;
    Options options;
    options.threads = threads;
    Probes probes(view.width, view.height, 100);
    const Take take{.method = choose_method(method), .keys = {frame_key(0, 0)}};
    render_takes(scene, view, options, {.takes = {&take, 1}, .sink = &probes});
    return probes.results();
}

// Whatever the order of arrival, and once only where tiles overlap under a wide filter.
TEST(Probes, SeeEachLayerOnceNearToFar)
{
    for (const Filter filter : {Filter::box, Filter::gaussian}) {
        const auto probes = probes_of(
            "builtin:layers?alpha=0.5,0.25,0.2&color=1,0,0;0,1,0&depth=1,2,4&order=far-to-near",
            filter, 2);
        // 2000 pixels, 100 at most: every 5th, from the 2nd.
        ASSERT_EQ(probes.size(), 10u * 8u);
        EXPECT_EQ(probes[11].x, 2 + 5);
        EXPECT_EQ(probes[11].y, 2 + 5);
        for (const Probe& probe : probes) {
            ASSERT_EQ(probe.steps.size(), 3u);
            double behind = 1;
            for (std::size_t i = 0; i < 3; ++i) {
                const double opacity = i == 0 ? 0.5 : i == 1 ? 0.25 : 0.2;
                // Floats: of depth a reciprocal, of opacity the rounding of 0.2.
                EXPECT_NEAR(probe.steps[i].depth, 1 << i, (1 << i) * 0x1p-21);
                EXPECT_NEAR(probe.steps[i].opacity, opacity, 0x1p-24);
                behind *= 1 - opacity;
                EXPECT_NEAR(probe.steps[i].behind, behind, 0x1p-23);
                EXPECT_EQ(probe.steps[i].coverage, 1);
            }
            EXPECT_EQ(probe.steps[0].color, (std::array<float, 3>{1, 0, 0}));
        }
    }
}

// Two of a pixel's layers fit, three do not.
TEST(Probes, KeepNoneOfTooManyLayers)
{
    for (const int layers : {1, 2, 3}) {
        View view;
        view.width = view.height = 12;
        view.samples = 1;  // else a layer has two fragments where its triangles meet
        const std::uint64_t most = 9 * 2 * Probes::kBytesOfLayer;
        Probes probes(view.width, view.height, 9, most);
        ASSERT_EQ(probes.results().size(), 9u);
        const Take take{.method = choose_method("blend"), .keys = {frame_key(0, 0)}};
        const Scene scene = load("builtin:layers?alpha=0.5&n=" + std::to_string(layers));
        render_takes(scene, view, {}, {.takes = {&take, 1}, .sink = &probes});
        for (const Probe& probe : probes.results()) {
            EXPECT_EQ(probe.too_many, layers > 2);
            EXPECT_EQ(probe.steps.size(), layers > 2 ? 0u : static_cast<std::size_t>(layers));
        }
    }
}

TEST(Probes, DoNotDependOnThreads)
{
    const auto one = probes_of("builtin:quads", Filter::gaussian, 1);
    const auto three = probes_of("builtin:quads", Filter::gaussian, 3);
    ASSERT_EQ(one.size(), three.size());
    std::size_t steps = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_EQ(one[i].steps.size(), three[i].steps.size());
        for (std::size_t k = 0; k < one[i].steps.size(); ++k, ++steps) {
            EXPECT_EQ(one[i].steps[k].depth, three[i].steps[k].depth);
            EXPECT_EQ(one[i].steps[k].behind, three[i].steps[k].behind);
        }
    }
    EXPECT_GT(steps, 0u);
}

// Not even where a method asks for MASK surfaces itself: here all is MASK or opaque.
TEST(Probes, DoNotDependOnTheMethod)
{
    for (const char* method : {"blend", "alpha-to-coverage", "hashed-alpha-test"}) {
        for (const Probe& probe : probes_of("builtin:fence", Filter::box, 1, method)) {
            ASSERT_EQ(probe.steps.size(), 0u) << method;
        }
    }
}

// Two halves of a pixel at opacity 1 leave nothing; the same half twice leaves half.
TEST(Probes, ApartAndOverlappingSamples)
{
    const auto behind = [](std::uint32_t first, std::uint32_t second) {
        FragmentStream stream(2);
        stream.size = stream.run_count = 2;
        for (std::uint32_t i = 0; i < 2; ++i) {
            stream.runs[i] = {i, 1, i, 0, {}, false};
            stream.runs[i].depth.least = stream.runs[i].depth.most = static_cast<float>(2 - i);
            stream.depth[i] = static_cast<float>(2 - i);
            stream.pixel[i] = 0;
            stream.samples[i] = i == 0 ? second : first;
            stream.samples_high[i] = 0;
            stream.red[i] = stream.green[i] = stream.blue[i] = 1;
            stream.opacity[i] = 1;
        }
        Probes probes(1, 1, 1);
        const PixelRect all{0, 0, 1, 1};
        probes.take(all, all, {4, 1, {true, 0, 10}}, stream);
        const Probe probe = probes.results().front();
        EXPECT_EQ(probe.steps[0].depth, 1);
        EXPECT_EQ(probe.steps[0].coverage, 0.5f);
        EXPECT_EQ(probe.steps[0].behind, 0.5);
        return probe.steps[1].behind;
    };
    EXPECT_EQ(behind(0b0011, 0b1100), 0);
    EXPECT_EQ(behind(0b0011, 0b0011), 0.5);
    EXPECT_EQ(behind(0b0011, 0b0110), 0.25);
}

}  // namespace
}  // namespace sheer
