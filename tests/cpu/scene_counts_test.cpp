// The counts that docs/scenes.md gives of the built-in scenes, at 500x500 and 8 samples. Depth
// complexity: transparent layers over a pixel's centre, over the pixels that have any.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include <sheer/sheer.h>

#include "cpu/coverage_counter.h"
#include "geometry/build.h"

namespace sheer {

namespace {

constexpr int kSize = 500;

std::string with_commas(std::uint64_t number)
{
    std::string text = std::to_string(number);
    for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
    return text;
}

std::string fragments(const Scene& scene)
{
    View view;
    view.width = view.height = kSize;
    Options options;
    options.method = "none";
    return with_commas(render(scene, view, options).stats.fragments);
}

std::string depth_complexity(const Scene& scene)
{
    View view;
    view.width = view.height = kSize;
    CoverageCounter counter(kSize, kSize, 1, SamplePositions::center, scene.objects.size());
    Geometry geometry = build_geometry(
        {scene, resolve_camera(scene, view), counter.grid(), counter.samples().extent, 1});
    std::vector<std::uint8_t> layers = counter.count(geometry, targets_of(Simd::best));
    std::sort(layers.begin(), layers.end());
    layers.erase(layers.begin(), std::upper_bound(layers.begin(), layers.end(), 0));
    const auto percentile = [&](std::size_t p) {
        return std::to_string(layers[(layers.size() - 1) * p / 100]);
    };
    return percentile(50) + " / " + percentile(99) + " / " + percentile(100);
}

std::string docs()
{
    std::ifstream file(SHEER_SOURCE_DIR "/docs/scenes.md");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST(SceneCounts, AreThoseOfTheDocs)
{
    const std::string text = docs();
    for (const char* name : {"layers", "quads", "motor"}) {
        const Scene scene = load(std::string("builtin:") + name);
        const std::size_t section = text.find(std::string("\n## ") + name + "\n");
        ASSERT_NE(section, std::string::npos);
        const std::string expected =
            "Counts at 500x500, 8 samples: " + fragments(scene) +
            " fragments; depth complexity (50th, 99th, 100th percentile) " +
            depth_complexity(scene) + ".";
        const std::size_t line = text.find("Counts at 500x500", section);
        EXPECT_EQ(text.substr(line, text.find('\n', line) - line), expected) << name;
    }
}

}  // namespace sheer
