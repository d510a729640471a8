// glTF files of other people's making: those of the folder that SHEER_SCENES names, and broken
// ones.

#include "gltf_fixture.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <sstream>

#include "image/png_file.h"

namespace sheer::test {
namespace {

namespace fs = std::filesystem;

fs::path scenes_folder()
{
    const char* folder = std::getenv("SHEER_SCENES");
    return folder != nullptr && fs::is_directory(folder) ? fs::path(folder) : fs::path();
}

std::vector<fs::path> gltf_files_in(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string suffix = entry.path().extension().string();
        if (suffix == ".gltf" || suffix == ".glb") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::uint64_t triangles_of(const Scene& scene)
{
    std::uint64_t triangles = 0;
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        if (mesh.topology == Topology::triangles) triangles += mesh.indices.size() / 3;
    }
    return triangles;
}

// The second column of README.md's table, for the rows that name one file.
std::map<std::string, std::uint64_t> triangles_by_table(const fs::path& readme)
{
    std::map<std::string, std::uint64_t> triangles;
    std::ifstream file(readme);
    for (std::string line; std::getline(file, line);) {
        std::istringstream row(line);
        std::string edge, name;
        std::uint64_t count = 0;
        if (row >> edge >> name >> edge >> count && edge == "|") triangles[name] = count;
    }
    return triangles;
}

// What `read_gltf` has promised of every scene that it returns.
void expect_sound(const Scene& scene)
{
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_LT(mesh.material, scene.materials.size());
        const std::size_t one = mesh.topology == Topology::triangles ? 3
                                : mesh.topology == Topology::lines   ? 2
                                                                     : 1;
        ASSERT_EQ(mesh.indices.size() % one, 0u);
        ASSERT_TRUE(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
        ASSERT_TRUE(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size());
        for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
    }
    for (const Object& object : scene.objects) ASSERT_LT(object.mesh, scene.meshes.size());
}

// Whether it loads; anything but an Error of one line goes through.
bool loads(const std::string& path, const Bytes& content)
{
    const auto start = std::chrono::steady_clock::now();
    bool loaded = false;
    try {
        expect_sound(read_gltf(path, content));
        loaded = true;
    } catch (const Error& e) {
        EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << path;
        EXPECT_EQ(std::string(e.what()).rfind(path + ": ", 0), 0u) << e.what();
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << path;
    return loaded;
}

TEST(GltfFiles, TriangleCountsAreThoseOfTheTable)
{
    const fs::path folder = scenes_folder();
    if (folder.empty()) GTEST_SKIP() << "SHEER_SCENES names no folder";
    const auto expected = triangles_by_table(folder / "README.md");
    std::size_t compared = 0, refused = 0;
    for (const fs::path& path : gltf_files_in(folder / "gltf")) {
        const std::string name = fs::relative(path, folder).string();
        try {
            const Scene scene = read_gltf(path.string());
            expect_sound(scene);
            // The table counts all scenes of a file, and none of a node's 125 instances.
            if (!expected.contains(name) || notes(scene, "other scenes: 1, not drawn")) continue;
            if (name == "gltf/SimpleInstancing/SimpleInstancing.glb") {
                EXPECT_EQ(triangles_of(scene), 125 * expected.at(name));
                continue;
            }
            EXPECT_EQ(triangles_of(scene), expected.at(name)) << name;
            ++compared;
        } catch (const Error& e) {
            const std::string what = e.what();
            EXPECT_TRUE(what.find("is not supported") != std::string::npos ||
                        what.find("only 2.0 is supported") != std::string::npos)
                << what;
            ++refused;
        }
    }
    EXPECT_GE(compared, expected.size() / 2);
    RecordProperty("compared", static_cast<int>(compared));
    RecordProperty("refused", static_cast<int>(refused));
}

TEST(GltfFiles, TheTeaTableIsDrawnWhole)
{
    const std::string path = std::string(SHEER_SOURCE_DIR) + "/scenes/tea_table.glb";
    const Scene scene = read_gltf(path);
    expect_sound(scene);
    EXPECT_TRUE(scene.ignored.empty());
    EXPECT_EQ(scene.cameras.size(), 1u);
    const auto uses = [&](AlphaMode mode) {
        return std::count_if(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
            return material_of(scene, object).alpha_mode == mode;
        });
    };
    EXPECT_GT(uses(AlphaMode::opaque), 0);
    EXPECT_GT(uses(AlphaMode::mask), 0);
    EXPECT_GT(uses(AlphaMode::blend), 0);
    EXPECT_LT(fs::file_size(path), 300000u);
}

TEST(GltfFiles, BrokenFilesLoadOrAreRefused)
{
    const fs::path folder = scenes_folder();
    if (folder.empty()) GTEST_SKIP() << "SHEER_SCENES names no folder";
    int loaded = 0, refused = 0;
    for (const fs::path& path : gltf_files_in(folder / "broken")) {
        ++(loads(path.string(), read_file(path.string())) ? loaded : refused);
    }
    RecordProperty("loaded", loaded);
    RecordProperty("refused", refused);
}

// One to four bytes are changed, or the end is cut off.
Bytes mutated(const Bytes& original, std::mt19937& random)
{
    Bytes bytes = original;
    if (random() % 8 == 0) {
        bytes.resize(1 + random() % bytes.size());
        return bytes;
    }
    // The JSON stands in front and is where a byte matters most.
    const std::size_t reach =
        random() % 4 == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 3000);
    constexpr std::string_view telling = "0123456789-.eE\"[]{},:";
    for (std::uint32_t i = 0; i < 1 + random() % 4; ++i) {
        const auto value = static_cast<std::uint32_t>(random());
        bytes[random() % reach] =
            value % 2 == 0 ? static_cast<std::uint8_t>(value >> 8)
                           : static_cast<std::uint8_t>(telling[(value >> 8) % telling.size()]);
    }
    return bytes;
}

Builder sample_document()
{
    Builder builder = one_triangle();
    Json& primitive = builder.primitive({{"POSITION", 0}});
    primitive["indices"] = builder.accessor("SCALAR", std::vector<std::uint16_t>{2, 1, 0});
    primitive["material"] = 0;
    primitive["attributes"]["COLOR_0"] = builder.accessor("VEC3", curve(3));
    builder.json["materials"] = {{{"alphaMode", "BLEND"}}};
    builder.json["nodes"][0]["children"] = {2};
    builder.json["nodes"].push_back({{"rotation", {0, 0, 0, 1}}, {"camera", 0}});
    builder.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 1}}}}};
    builder.json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", builder.view(std::vector<std::uint8_t>{1})}, {"componentType", 5121}}},
        {"values", {{"bufferView", 0}}}};
    primitive["targets"] = {{{"POSITION", 0}}};
    primitive["attributes"]["TEXCOORD_1"] = builder.accessor("VEC2", std::vector<float>(6, 0.5f));
    primitive["attributes"]["JOINTS_0"] =
        builder.accessor("VEC4", std::vector<std::uint8_t>(12, 0));
    primitive["attributes"]["WEIGHTS_0"] = builder.accessor("VEC4", std::vector<float>(12, 1));
    builder.json["meshes"][1]["weights"] = {0.5};
    builder.json["nodes"][1]["skin"] = 0;
    builder.json["skins"] = {{{"joints", {2}}}};
    builder.json["nodes"][0]["extensions"] = parse_json(
        R"({"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 0}},
            "KHR_lights_punctual": {"light": 0}})");
    builder.json["extensions"] =
        parse_json(R"({"KHR_lights_punctual": {"lights": [{"type": "spot", "intensity": 2}]}})");
    builder.json["materials"][0]["emissiveTexture"] =
        parse_json(R"({"index": 0, "extensions": {"KHR_texture_transform": {"rotation": 1}}})");
    builder.json["textures"] = parse_json(R"([{"source": 0, "sampler": 0}])");
    builder.json["samplers"] = parse_json(R"([{"wrapS": 33071, "minFilter": 9987}])");
    const auto png =
        png_file::make_png({1, 1, 8, png_file::kRgba, png_file::text_of({0, 1, 2, 3, 4})});
    builder.json["images"] = {{{"bufferView", builder.view(png)}}};
    return builder;
}

TEST(GltfFiles, MutatedSampleNeverCrashes)
{
    std::mt19937 random(1);
    for (const std::string& text : {sample_document().text(), as_glb(sample_document())}) {
        const Bytes original(text.begin(), text.end());
        ASSERT_TRUE(loads("sample.gltf", original));
        for (int i = 0; i < 2000; ++i) loads("sample.gltf", mutated(original, random));
    }
}

TEST(GltfFiles, MutatedFilesNeverCrash)
{
    const fs::path folder = scenes_folder();
    if (folder.empty()) GTEST_SKIP() << "SHEER_SCENES names no folder";
    std::vector<fs::path> files = gltf_files_in(folder / "gltf");
    std::stable_sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
        return fs::file_size(a) < fs::file_size(b);
    });
    files.resize(std::min<std::size_t>(files.size(), 60));
    std::mt19937 random(2);
    // Of the sixty smallest, those with different generators: every third.
    for (std::size_t i = 0; i < files.size(); i += 3) {
        const Bytes original = read_file(files[i].string());
        for (int k = 0; k < 200; ++k) loads(files[i].string(), mutated(original, random));
    }
}

}  // namespace
}  // namespace sheer::test
