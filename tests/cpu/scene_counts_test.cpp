// The counts that docs/scenes.md gives of the built-in scenes, at 500x500 and 8 samples. Depth
// complexity: transparent layers over a pixel's centre, over the pixels that have any.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

#include <sheer/sheer.h>

#include "scene/builtin.h"
#include "scene/transparency.h"

namespace sheer {

namespace {

constexpr int kSize = 500;

std::string with_commas(std::uint64_t number)
{
    std::string text = std::to_string(number);
    for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
    return text;
}

// What --mask-as-blend draws.
Scene with_masks_blended(Scene scene)
{
    for (Material& material : scene.materials)
        if (material.alpha_mode == AlphaMode::mask) material.alpha_mode = AlphaMode::blend;
    return scene;
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
    view.samples = 1;
    view.positions = SamplePositions::center;
    Options options;
    options.method = "none";
    options.channels = true;
    std::vector<float> layers = render(scene, view, options).channels->depth_complexity;
    std::sort(layers.begin(), layers.end());
    layers.erase(layers.begin(), std::upper_bound(layers.begin(), layers.end(), 0.0f));
    const auto percentile = [&](std::size_t p) {
        const float count = layers.empty() ? 0.0f : layers[(layers.size() - 1) * p / 100];
        return std::to_string(static_cast<int>(count));
    };
    return percentile(50) + " / " + percentile(99) + " / " + percentile(100);
}

std::string two_digits(double number)
{
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%.2g", number);
    return text.data();
}

// Of what is transparent: material times object, and what that is multiplied by.
std::string opacities(const Scene& scene)
{
    double least = 1, most = 0;
    bool textured = false, by_vertex = false;
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        const Material& material = scene.materials[mesh.material];
        if (!is_transparent(material, object)) continue;
        const double opacity = double{material.opacity} * double{object.opacity};
        least = std::min(least, opacity);
        most = std::max(most, opacity);
        textured |= material.base_color_texture.has_value();
        by_vertex |= std::any_of(mesh.colors.begin(), mesh.colors.end(),
                                 [](const Float4& color) { return color[3] != 1; });
    }
    std::string text = "opacities " + two_digits(least);
    if (most > least) text += " to " + two_digits(most);
    if (textured) text += ", times a texture's";
    if (by_vertex) text += ", times a vertex's";
    return text;
}

std::string docs()
{
    std::ifstream file(SHEER_SOURCE_DIR "/docs/scenes.md");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

class SceneCounts : public ::testing::TestWithParam<std::string> {};

TEST_P(SceneCounts, AreThoseOfTheDocs)
{
    const std::string text = docs();
    const std::size_t section = text.find("\n## " + GetParam() + "\n");
    ASSERT_NE(section, std::string::npos);
    const Scene scene = with_masks_blended(load("builtin:" + GetParam()));
    const std::string expected = "Counts at 500x500, 8 samples: " + fragments(scene) +
                                 " fragments; depth complexity (50th, 99th, 100th percentile) " +
                                 depth_complexity(scene) + ";\n" + opacities(scene) + ".\n";
    const std::size_t line = text.find("Counts at 500x500", section);
    EXPECT_EQ(text.substr(line, expected.size()), expected);
}

std::vector<std::string> scene_names()
{
    std::vector<std::string> names;
    for (const BuiltinScene& row : builtin_scenes()) names.push_back(row.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Builtin, SceneCounts, ::testing::ValuesIn(scene_names()),
                         [](const auto& scene) {
                             std::string name = scene.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace sheer
