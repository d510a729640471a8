// Which reader gets a file, and files of other people's making: those of the folder that
// SHEER_SCENES names.
#include "scene/read_scene.h"

#include <filesystem>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "mesh_file_fixture.h"
#include "support/test_folder.h"

namespace sheer::test {
namespace {

namespace fs = std::filesystem;

std::string said_of(const std::string& path)
{
    try {
        expect_sound(read_scene(path));
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_EQ(error.fault(), Fault::input);
        EXPECT_EQ(text.find('\n'), std::string::npos);
        EXPECT_EQ(text.rfind(path + ": ", 0), 0u) << text;
        return text.substr(path.size() + 2);
    }
    return "";
}

std::string said_of(const std::string& name, const std::string& content)
{
    const TestFolder folder;
    std::ofstream(folder.file(name), std::ios::binary) << content;
    return said_of(folder.file(name));
}

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
    "property float y\nproperty float z\nend_header\n0 0 0\n";
const std::string kGltf = R"( {"asset": {"version": "2.0"}})";
const std::string kStl = std::string(80, 's') + packed(std::uint32_t{1}) + std::string(50, '\0');
const std::string kTextStl = "solid\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n";

TEST(ReadScene, ContentDecidesWhereItCan)
{
    for (const std::string name : {"a.ply", "a.obj", "a.glb", "a", "a.xyz"}) {
        EXPECT_EQ(said_of(name, kPly), "") << name;
        EXPECT_EQ(said_of(name, kGltf), "") << name;
        EXPECT_EQ(said_of(name, kStl), "") << name;
        EXPECT_NE(said_of(name, "glTF"), "") << name;
    }
    EXPECT_EQ(said_of("a.ply", "glTF").find("PLY"), std::string::npos);
}

TEST(ReadScene, ElseTheSuffixDoes)
{
    EXPECT_EQ(said_of("a.obj", "v 0 0 0\n"), "");
    EXPECT_EQ(said_of("a.OBJ", "v 0 0 0\n"), "");
    EXPECT_EQ(said_of("a.stl", kTextStl), "");
    EXPECT_EQ(said_of("a.tfx", ""), "the file is cut short");
    EXPECT_EQ(said_of("a.ply", ""), "not a PLY file");
    EXPECT_EQ(said_of("a.fbx", "v 0 0 0\n"),
              "not a scene that can be read; such end in .glb, .gltf, .ply, .stl, .obj, .tfx");
    EXPECT_EQ(said_of("/no/such/file.obj"), "no such file");
}

TEST(ReadScene, OnlyGltfHasScenesToChooseFrom)
{
    const TestFolder folder;
    const auto fault = [&](const std::string& name, const std::string& content) -> std::string {
        std::ofstream(folder.file(name), std::ios::binary) << content;
        try {
            read_scene(folder.file(name), {.scene = "0"});
        } catch (const Error& error) {
            return std::string(error.what()).substr(folder.file(name).size());
        }
        return "";
    };
    const std::string refusal = ": only glTF files have scenes to choose from by --scene";
    EXPECT_EQ(fault("a.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{}]})"), "");
    EXPECT_EQ(fault("a.ply", kPly), refusal);
    EXPECT_EQ(fault("a.obj", "v 0 0 0\n"), refusal);
    EXPECT_EQ(fault("a.stl", kTextStl), refusal);
}

struct Counts {
    std::size_t triangles = 0, pieces = 0, points = 0;  // pieces of lines
    bool operator==(const Counts&) const = default;
};

Counts counts_of(const Scene& scene)
{
    Counts counts;
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        const std::size_t indices = mesh.indices.size();
        if (mesh.topology == Topology::triangles) counts.triangles += indices / 3;
        if (mesh.topology == Topology::lines) counts.pieces += indices / 2;
        if (mesh.topology == Topology::points) counts.points += indices;
    }
    return counts;
}

std::string scenes_folder()
{
    const char* folder = std::getenv("SHEER_SCENES");
    return folder != nullptr && fs::is_directory(folder) ? folder : "";
}

// Triangles, pieces of lines and points, counted in the files by other means: their headers, or the
// statements in them.
TEST(ReadScene, CountsOfRealFiles)
{
    const std::string folder = scenes_folder();
    if (folder.empty()) GTEST_SKIP() << "SHEER_SCENES names no folder";
    const std::map<std::string, Counts> files = {
        {"mesh/spot.obj", {5856, 0, 0}},
        {"mesh/teapot.obj", {6320, 0, 0}},
        {"mesh/dolphins_be.ply", {1689, 0, 0}},
        {"mesh/dolphins_colored.ply", {1689, 0, 0}},
        {"mesh/ripple_points.ply", {0, 0, 10201}},
        {"mesh/assimp/OBJ/box_without_lineending.obj", {12, 0, 0}},
        {"mesh/assimp/OBJ/cube_with_vertexcolors.obj", {12, 0, 0}},
        {"mesh/assimp/OBJ/multiple_spaces.obj", {1, 0, 0}},
        {"mesh/assimp/OBJ/point_cloud.obj", {0, 0, 3}},
        {"mesh/assimp/OBJ/testline.obj", {0, 18, 0}},
        {"mesh/assimp/OBJ/testmixed.obj", {12, 18, 24}},
        {"mesh/assimp/OBJ/testpoints.obj", {0, 0, 24}},
        {"mesh/assimp/PLY/cube.ply", {12, 0, 0}},
        {"mesh/assimp/PLY/cube_binary.ply", {12, 0, 0}},
        {"mesh/assimp/PLY/cube_binary_header_with_RN_newline.ply", {12, 0, 0}},
        {"mesh/assimp/PLY/cube_binary_starts_with_nl.ply", {12, 0, 0}},
        {"mesh/assimp/PLY/cube_uv.ply", {12, 0, 0}},
        {"mesh/assimp/PLY/float-color.ply", {1, 0, 0}},
        {"mesh/assimp/PLY/points.ply", {0, 0, 4}},
        {"hair/Ratboy_mohawk.tfx", {0, 2228 * 31, 0}},
        {"hair/tractography_afq_lines.obj", {0, 141447 - 508, 0}},
    };
    for (const auto& [name, counts] : files) {
        const Scene scene = read_scene(folder + "/" + name);
        expect_sound(scene);
        EXPECT_EQ(counts_of(scene), counts) << name;
    }
}

TEST(ReadScene, TheSpiderHasItsSkin)
{
    const std::string folder = scenes_folder();
    if (folder.empty()) GTEST_SKIP() << "SHEER_SCENES names no folder";
    const Scene scene = read_scene(folder + "/mesh/assimp/OBJ/spider.obj");
    // Of the library's five materials four are used.
    EXPECT_EQ(scene.materials.size(), 4u);
    EXPECT_EQ(scene.images.size(), 4u);
    for (const Material& material : scene.materials) {
        EXPECT_TRUE(material.base_color_texture) << material.name;
    }
}

// Every file loads or is refused in one line.
TEST(ReadScene, AllRealFilesAreReadOrRefused)
{
    const std::string folder = scenes_folder();
    if (folder.empty()) GTEST_SKIP() << "SHEER_SCENES names no folder";
    const std::map<std::string, std::string> refused = {
        {"Zaghetto.pcd", "not a scene that can be read"},
        {"box_UTF16BE.obj", "UTF-16 text is not supported"},
        {"number_formats.obj", "line 11: '3.1+e2' is not a number"},
        {"issue623.ply", "line 17: a list has a negative length"},
        {"malformed.obj", "line 23: there is no vertex 12"},
        {"empty.obj", "the file holds nothing that can be drawn"},
        {"empty.ply", "not a PLY file"},
    };
    std::size_t met = 0;
    for (const std::string part : {"mesh", "hair", "splats", "broken/assimp/invalid"}) {
        for (const auto& entry : fs::recursive_directory_iterator(folder + "/" + part)) {
            if (!entry.is_regular_file()) continue;
            const std::string said = said_of(entry.path().string());
            const auto expected = refused.find(entry.path().filename().string());
            if (expected == refused.end()) continue;
            EXPECT_EQ(said.rfind(expected->second, 0), 0u) << entry.path() << ": " << said;
            ++met;
        }
    }
    EXPECT_EQ(met, refused.size());
}

}  // namespace
}  // namespace sheer::test
