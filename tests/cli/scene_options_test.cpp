// What the tool makes of SCENE's own options: which scene, what of it is seen through, what may be
// read for it; and what it says of a scene.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/run_tool.h"
#include "image/png_file.h"
#include "scene/gltf_fixture.h"
#include "support/json.h"

namespace sheer::test {
namespace {

using Words = std::vector<std::string>;

class SceneOptionsTest : public testing::Test {
protected:
    std::string write(const std::string& name, const std::string& content) const
    {
        std::filesystem::create_directories(
            std::filesystem::path(scenes_.file(name)).parent_path());
        std::ofstream(scenes_.file(name), std::ios::binary) << content;
        return scenes_.file(name);
    }

    std::string refusal(const Words& words) const
    {
        const Outcome outcome = tool_.run(words);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
        return outcome.err;
    }

    std::string output(const Words& words) const
    {
        const Outcome outcome = tool_.run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return outcome.out;
    }

    // The transparent fragments that a picture takes.
    int fragments(const std::string& scene, const Words& added = {}) const
    {
        Words words = {"render", scene,       "-o", "a.exr",  "--size",
                       "8x8",    "--samples", "1",  "--json", "--camera"};
        words.emplace_back("0");
        words.insert(words.end(), added.begin(), added.end());
        return parse_json(output(words)).at("fragments");
    }

    Json info(const Words& words) const
    {
        Words all = {"info", "--json"};
        all.insert(all.end(), words.begin(), words.end());
        return parse_json(output(all));
    }

private:
    TestFolder scenes_;
    Tool tool_;
};

// Two rectangles, one in front of the other, that each fill the picture: of nodes "near" and "far",
// meshes "pane" and "wall", materials "glass" and "stone=grey", with the given modes.
Builder two_rectangles(const std::string& near_mode, const std::string& far_mode)
{
    Builder builder;
    const std::size_t corners =
        builder.accessor("VEC3", std::vector<float>{-9, -9, 0, 9, -9, 0, 9, 9, 0, -9, 9, 0});
    const std::size_t indices =
        builder.accessor("SCALAR", std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3});
    for (const std::size_t material : {0u, 1u}) {
        Json& primitive = builder.primitive({{"POSITION", corners}});
        primitive["indices"] = indices;
        primitive["material"] = material;
    }
    Json& json = builder.json;
    json["materials"] = {{{"name", "glass"}, {"alphaMode", near_mode}},
                         {{"name", "stone=grey"}, {"alphaMode", far_mode}}};
    json["meshes"][0]["name"] = "pane";
    json["meshes"][1]["name"] = "wall";
    json["nodes"][0].update({{"name", "near"}, {"translation", {0, 0, -1}}});
    json["nodes"][1].update({{"name", "far"}, {"translation", {0, 0, -2}}});
    json["nodes"].push_back({{"camera", 0}});
    json["scenes"][0]["nodes"].push_back(2);
    json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
    return builder;
}

constexpr int kAll = 8 * 8;  // fragments of a rectangle

TEST_F(SceneOptionsTest, OpacityMakesObjectsTransparent)
{
    const std::string scene = write("a.gltf", two_rectangles("OPAQUE", "OPAQUE").text());
    EXPECT_EQ(fragments(scene), 0);
    EXPECT_EQ(fragments(scene, {"--opacity", "0.5"}), 2 * kAll);
    EXPECT_EQ(fragments(scene, {"--opacity", "near=0.5"}), kAll);
    EXPECT_EQ(fragments(scene, {"--opacity", "pa*=0.5"}), kAll);
    EXPECT_EQ(fragments(scene, {"--opacity", "stone=gr?y=0.5"}), 0);  // behind what is opaque
    // The last that matches counts.
    EXPECT_EQ(fragments(scene, {"--opacity", "0.5", "--opacity", "near=1"}), 0);
    EXPECT_EQ(fragments(scene, {"--opacity", "near=1", "--opacity", "0.5"}), 2 * kAll);
}

TEST_F(SceneOptionsTest, OptionsDoNotSwallowTheScene)
{
    const std::string scene = write("a.gltf", two_rectangles("OPAQUE", "OPAQUE").text());
    const std::string line = output({"render", "--opacity", "0.5", scene, "-o", "a.exr", "--size",
                                     "8x8", "--samples", "1", "--camera", "0"});
    EXPECT_NE(line.find(std::to_string(2 * kAll) + " fragments"), std::string::npos) << line;
}

TEST_F(SceneOptionsTest, OpacityThatIsNone)
{
    const std::string scene = write("a.gltf", two_rectangles("OPAQUE", "OPAQUE").text());
    for (const std::string command : {"render", "bench", "compare"}) {
        const auto said = [&](const std::string& opacity) {
            Words words = {command, scene, "--opacity", opacity};
            if (command != "bench") words.insert(words.end(), {"-o", "a.png"});
            return refusal(words);
        };
        EXPECT_EQ(said("2"), "sheer: --opacity: '2' is not between 0 and 1\n");
        EXPECT_EQ(said("near=-0.5"), "sheer: --opacity: '-0.5' is not between 0 and 1\n");
        EXPECT_EQ(said("near"), "sheer: --opacity: 'near' is not a finite number\n");
        EXPECT_EQ(said("=0.5"), "sheer: --opacity: there is no name before the '='\n");
        EXPECT_EQ(said("near=nan"), "sheer: --opacity: 'nan' is not a finite number\n");
        EXPECT_EQ(
            said("door*=1"),
            "sheer: --opacity: no object, group, mesh or material is called 'door*'; there are "
            "'near', 'pane', 'glass', 'far', 'wall', 'stone=grey'\n");
    }
}

TEST_F(SceneOptionsTest, MasksAreBlendedOnDemand)
{
    const std::string scene = write("a.gltf", two_rectangles("MASK", "OPAQUE").text());
    EXPECT_EQ(fragments(scene), 0);
    EXPECT_EQ(fragments(scene, {"--mask-as-blend"}), kAll);
}

TEST_F(SceneOptionsTest, ChoosesAmongScenes)
{
    Builder builder = two_rectangles("OPAQUE", "OPAQUE");
    builder.json["scenes"].push_back({{"name", "second"}, {"nodes", {1}}});
    const std::string scene = write("a.gltf", builder.text());
    EXPECT_EQ(info({scene}).at("objects"), 2);
    EXPECT_EQ(info({scene, "--scene", "0"}).at("objects"), 2);
    EXPECT_EQ(info({scene, "--scene", "1"}).at("objects"), 1);
    EXPECT_EQ(info({scene, "--scene", "second"}).at("objects"), 1);
    EXPECT_EQ(refusal({"info", scene, "--scene", "third"}),
              "sheer: " + scene + ": there is no scene \"third\", the file has 2\n");
    EXPECT_EQ(refusal({"info", "builtin:quads", "--scene", "0"}),
              "sheer: builtin:quads: only glTF files have scenes to choose from by --scene\n");
}

// Each rectangle with an image of two texels, out of one file in the folder above.
Builder textured_from_outside()
{
    Builder builder = two_rectangles("OPAQUE", "OPAQUE");
    builder.json["images"] = {{{"uri", "../a.png"}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["materials"][0]["emissiveTexture"] = {{"index", 0}};
    return builder;
}

TEST_F(SceneOptionsTest, FilesAnywhereAndTexelsAreTheUsersChoice)
{
    const auto png = png_file::make_png({2, 1, 8, png_file::kGrey, std::string(3, '\0')});
    write("a.png", {reinterpret_cast<const char*>(png.data()), png.size()});
    const std::string scene = write("inner/a.gltf", textured_from_outside().text());
    EXPECT_EQ(refusal({"info", scene}),
              "sheer: " + scene +
                  ": images[0].uri: \"../a.png\" is outside of the scene's folder "
                  "(--allow-any-file lets it be read)\n");
    const Json told = info({scene, "--allow-any-file", "--most-texels", "2"});
    ASSERT_EQ(told.at("textures").size(), 1u);
    EXPECT_EQ(told.at("textures")[0].at("width"), 2);
    EXPECT_EQ(told.at("textures")[0].at("height"), 1);
    EXPECT_EQ(told.at("texture_bytes"), 8);
    EXPECT_NE(refusal({"info", scene, "--allow-any-file", "--most-texels", "1"})
                  .find("more than 1 texels, which is what --most-texels leaves"),
              std::string::npos);
    EXPECT_EQ(refusal({"info", scene, "--most-texels", "-1"}).rfind("sheer: --most-texels: ", 0),
              0u);
    EXPECT_NE(output({"info", scene, "--allow-any-file"}).find("1 image of 2x1, 8 bytes\n"),
              std::string::npos);
}

TEST_F(SceneOptionsTest, InfoTellsTrianglesLinesAndPointsApart)
{
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    const Json mixed = info({write("a.obj", vertices + "f 1 2 4 3\nl 1 2 3 4\np 1 2 3 4\n")});
    EXPECT_EQ(mixed.at("triangles"), 2);
    EXPECT_EQ(mixed.at("lines"), 3);
    EXPECT_EQ(mixed.at("points"), 4);
    const Json cloud = info({write("b.obj", vertices)});
    EXPECT_EQ(cloud.at("triangles"), 0);
    EXPECT_EQ(cloud.at("points"), 4);
}

TEST_F(SceneOptionsTest, InfoCountsInstancesGlassAndLights)
{
    Builder builder = two_rectangles("OPAQUE", "BLEND");
    Json& json = builder.json;
    json["nodes"][1]["mesh"] = 0;
    json["materials"][0]["extensions"] = {
        {"KHR_materials_transmission", {{"transmissionFactor", 1}}}};
    json["extensions"]["KHR_lights_punctual"]["lights"] =
        parse_json(R"([{"type": "spot", "spot": {}}, {"type": "point"}])");
    json["nodes"][2]["extensions"] = {{"KHR_lights_punctual", {{"light", 0}}}};
    const std::string scene = write("a.gltf", builder.text());
    const Json told = info({scene});
    EXPECT_EQ(told.at("objects"), 2);
    EXPECT_EQ(told.at("triangles"), 4);
    EXPECT_EQ(told.at("mesh_triangles").get<int>(), 2 * told.at("meshes").get<int>());
    EXPECT_EQ(told.at("triangles_by_alpha_mode").at("opaque"), 4);
    EXPECT_EQ(told.at("glass_triangles"), 4);
    EXPECT_EQ(told.at("glass_materials"), 1);
    EXPECT_EQ(told.at("lights"), parse_json(R"({"directional": 0, "point": 0, "spot": 1})"));
    const std::string text = output({"info", scene});
    EXPECT_NE(text.find("triangles  4 (4 opaque), 4 of them coloured glass\n"), std::string::npos)
        << text;
    EXPECT_NE(text.find("lights     1 (1 spot)\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace sheer::test
