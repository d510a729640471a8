// glTF meshes and materials: topology, accessors, attributes, what a material says.

#include "gltf_fixture.h"

#include <cmath>

namespace sheer::test {
namespace {

using Indices = std::vector<std::uint32_t>;

Indices triangles_of_mode(int mode, int vertices)
{
    Builder builder;
    builder.primitive({{"POSITION", builder.accessor("VEC3", curve(vertices))}})["mode"] = mode;
    return read(builder).meshes.at(0).indices;
}

TEST(Gltf, ReadsATriangleWithoutIndices)
{
    const Scene scene = read(one_triangle());
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].positions, (std::vector<Float3>{{0, 0, 0}, {1, 1, 0}, {2, 4, 0}}));
    EXPECT_EQ(scene.meshes[0].indices, (Indices{0, 1, 2}));
    EXPECT_TRUE(scene.meshes[0].normals.empty());
    EXPECT_TRUE(scene.meshes[0].colors.empty());
    EXPECT_TRUE(scene.ignored.empty());
}

TEST(Gltf, ReadsAGlbWhateverItsName)
{
    const std::string path = in_temp_dir("a_glb.gltf", as_glb(one_triangle()));
    EXPECT_EQ(read_gltf(path).meshes.at(0).positions.size(), 3u);
    const std::string other = in_temp_dir("a_gltf.glb", one_triangle().text());
    EXPECT_EQ(read_gltf(other).meshes.at(0).positions.size(), 3u);
}

TEST(Gltf, ReadsABufferFromAFileWithAnEncodedName)
{
    Builder builder = one_triangle();
    in_temp_dir("two words.bin", std::string(builder.data.begin(), builder.data.end()));
    for (const char* uri : {"two%20words.bin", "two words.bin"}) {
        builder.json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        const std::string path = in_temp_dir("beside.gltf", builder.text());
        EXPECT_EQ(read_gltf(path).meshes.at(0).positions[2][1], 4.0f);
    }
}

TEST(Gltf, WindsStripsAndFansAsTheSpecificationSays)
{
    EXPECT_EQ(triangles_of_mode(4, 6), (Indices{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(triangles_of_mode(5, 5), (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
    EXPECT_EQ(triangles_of_mode(6, 5), (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
}

TEST(Gltf, LeavesOutVerticesThatMakeNoTriangle)
{
    Builder builder;
    builder.primitive({{"POSITION", builder.accessor("VEC3", curve(5))}});
    const Scene scene = read(builder);
    EXPECT_EQ(scene.meshes.at(0).indices, (Indices{0, 1, 2}));
    EXPECT_EQ(scene.meshes[0].positions.size(), 3u);
    EXPECT_TRUE(notes(scene, "primitives with vertices left over: 1, which make no triangle"));
}

TEST(Gltf, JoinsPointsAndLinesAsTheSpecificationSays)
{
    const auto of_mode = [](int mode) {
        Builder builder;
        builder.primitive({{"POSITION", builder.accessor("VEC3", curve(4))}})["mode"] = mode;
        return read(builder).meshes.at(0);
    };
    EXPECT_EQ(of_mode(0).topology, Topology::points);
    EXPECT_EQ(of_mode(0).indices, (Indices{0, 1, 2, 3}));
    for (const int mode : {1, 2, 3}) EXPECT_EQ(of_mode(mode).topology, Topology::lines) << mode;
    EXPECT_EQ(of_mode(1).indices, (Indices{0, 1, 2, 3}));
    EXPECT_EQ(of_mode(2).indices, (Indices{0, 1, 1, 2, 2, 3, 3, 0}));
    EXPECT_EQ(of_mode(3).indices, (Indices{0, 1, 1, 2, 2, 3}));
    for (const int mode : {4, 5, 6}) EXPECT_EQ(of_mode(mode).topology, Topology::triangles);
}

TEST(Gltf, LeavesOutVerticesThatMakeNoLine)
{
    const auto indices_of = [](int mode, int vertices) {
        Builder builder = one_triangle();
        builder.primitive({{"POSITION", builder.accessor("VEC3", curve(vertices))}})["mode"] = mode;
        const Scene scene = read(builder);
        EXPECT_TRUE(notes(scene, "primitives with vertices left over: 1, which make no line"));
        return scene.meshes.size() > 1 ? scene.meshes[1].indices : Indices();
    };
    EXPECT_EQ(indices_of(1, 3), (Indices{0, 1}));
    for (const int mode : {1, 2, 3}) EXPECT_EQ(indices_of(mode, 1), Indices());
}

TEST(Gltf, LinesAndPointsWithoutNormalsAreUnlit)
{
    Builder builder = one_triangle();
    builder.json["materials"] = parse_json(R"([{"name": "ink", "alphaMode": "BLEND"}])");
    Json lines = builder.json["meshes"][0]["primitives"][0];
    lines["material"] = 0;
    builder.json["meshes"][0]["primitives"] = Json::array({lines, lines, lines, lines});
    for (std::size_t i = 1; i < 4; ++i) {
        builder.json["meshes"][0]["primitives"][i]["mode"] = i - 1;  // triangles, points, 2 lines
    }
    builder.json["meshes"][0]["primitives"][3]["attributes"]["NORMAL"] = 0;
    builder.json["accessors"][0]["sparse"] = {
        // the first position is no direction
        {"count", 1},
        {"indices",
         {{"bufferView", builder.view(std::vector<std::uint8_t>{0})}, {"componentType", 5121}}},
        {"values", {{"bufferView", builder.view(std::vector<float>{1, 0, 0})}}}};
    const Scene scene = read(builder);
    ASSERT_EQ(scene.materials.size(), 2u);  // one copy for both
    EXPECT_EQ(scene.meshes.at(0).material, 0u);
    EXPECT_EQ(scene.meshes.at(1).material, 1u);
    EXPECT_EQ(scene.meshes.at(2).material, 1u);
    EXPECT_EQ(scene.meshes.at(3).material, 0u);
    EXPECT_NE(scene.materials[0].shading, Shading::unlit);
    EXPECT_EQ(scene.materials[1].shading, Shading::unlit);
    EXPECT_EQ(scene.materials[1].name, "ink");
    EXPECT_EQ(scene.materials[1].alpha_mode, AlphaMode::blend);
}

template <class T>
void expect_indices_of_type()
{
    Builder builder = one_triangle();
    builder.json["meshes"][0]["primitives"][0]["indices"] =
        builder.accessor("SCALAR", std::vector<T>{2, 1, 0, 0, 0, 1});
    // The degenerate triangle stays: leaving it out would renumber those behind it.
    EXPECT_EQ(read(builder).meshes.at(0).indices, (Indices{2, 1, 0, 0, 0, 1}));
}

TEST(Gltf, ReadsIndicesOfEveryType)
{
    expect_indices_of_type<std::uint8_t>();
    expect_indices_of_type<std::uint16_t>();
    expect_indices_of_type<std::uint32_t>();
}

TEST(Gltf, KeepsOnlyTheVerticesThatAreUsed)
{
    Builder builder;
    Json& primitive = builder.primitive({{"POSITION", builder.accessor("VEC3", curve(9))},
                                         {"NORMAL", builder.accessor("VEC3", curve(9))}});
    primitive["indices"] = builder.accessor("SCALAR", Indices{8, 3, 5});
    const Mesh mesh = read(builder).meshes.at(0);
    EXPECT_EQ(mesh.indices, (Indices{2, 0, 1}));
    EXPECT_EQ(mesh.positions, (std::vector<Float3>{{3, 9, 0}, {5, 25, 0}, {8, 64, 0}}));
    ASSERT_EQ(mesh.normals.size(), 3u);
    EXPECT_NEAR(mesh.normals[0][0], 1 / std::sqrt(10.0), 1e-6);
}

TEST(Gltf, StepsByTheStride)
{
    Builder builder = one_triangle();
    std::vector<float> interleaved;
    for (int i = 0; i < 3; ++i) {
        const float x = static_cast<float>(i);
        interleaved.insert(interleaved.end(), {99, x, x * x, 7});
    }
    const std::size_t view = builder.view(interleaved);
    builder.json["bufferViews"][view]["byteStride"] = 16;
    builder.json["accessors"][0]["bufferView"] = view;
    builder.json["accessors"][0]["byteOffset"] = 4;
    EXPECT_EQ(read(builder).meshes.at(0).positions,
              (std::vector<Float3>{{0, 0, 7}, {1, 1, 7}, {2, 4, 7}}));
}

TEST(Gltf, SparseElementsStandInForOthers)
{
    Builder builder = one_triangle();
    builder.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices",
         {{"bufferView", builder.view(std::vector<std::uint16_t>{0, 2})}, {"componentType", 5123}}},
        {"values", {{"bufferView", builder.view(std::vector<float>{5, 6, 7, 8, 9, 10})}}}};
    const std::vector<Float3> expected = {{5, 6, 7}, {1, 1, 0}, {8, 9, 10}};
    EXPECT_EQ(read(builder).meshes.at(0).positions, expected);
    builder.json["accessors"][0].erase("bufferView");
    EXPECT_EQ(read(builder).meshes.at(0).positions,
              (std::vector<Float3>{{5, 6, 7}, {0, 0, 0}, {8, 9, 10}}));
}

TEST(Gltf, ReadsQuantizedPositions)
{
    Builder builder = one_triangle();
    builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const std::size_t accessor = builder.accessor(
        "VEC3", std::vector<std::int16_t>{-32768, -32767, 0, 32767, 0, 0, 0, 16384, 0});
    builder.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = accessor;
    EXPECT_EQ(read(builder).meshes.at(0).positions[0], (Float3{-32768, -32767, 0}));
    builder.json["accessors"][accessor]["normalized"] = true;
    const Mesh mesh = read(builder).meshes.at(0);
    EXPECT_EQ(mesh.positions[0], (Float3{-1, -1, 0}));
    EXPECT_EQ(mesh.positions[1], (Float3{1, 0, 0}));
    EXPECT_FLOAT_EQ(mesh.positions[2][1], 16384.0f / 32767.0f);
}

template <class T>
void expect_colors(const std::string& type, const std::vector<T>& values, const Float4& second)
{
    Builder builder = one_triangle();
    const std::size_t accessor = builder.accessor(type, values);
    if (!std::is_same_v<T, float>) builder.json["accessors"][accessor]["normalized"] = true;
    builder.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = accessor;
    const Mesh mesh = read(builder).meshes.at(0);
    ASSERT_EQ(mesh.colors.size(), 3u);
    EXPECT_EQ(mesh.colors[1], second);
}

TEST(Gltf, ReadsColorsOfEveryType)
{
    expect_colors<float>("VEC3", {0, 0, 0, .25f, .5f, 1, 0, 0, 0}, {.25f, .5f, 1, 1});
    // glTF asks for values to be clamped.
    expect_colors<float>("VEC4", {0, 0, 0, 0, -1, .5f, 7, .5f, 0, 0, 0, 0}, {0, .5f, 1, .5f});
    expect_colors<std::uint8_t>("VEC4", {0, 0, 0, 0, 255, 51, 0, 102, 0, 0, 0, 0},
                                {1, 0.2f, 0, 0.4f});
    expect_colors<std::uint16_t>("VEC4", {0, 0, 0, 0, 65535, 13107, 0, 0, 0, 0, 0, 0},
                                 {1, 0.2f, 0, 0});
}

TEST(Gltf, RepairsNormalsWithoutDirection)
{
    Builder builder = one_triangle();
    const float nan = std::nanf("");
    builder.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        builder.accessor("VEC3", std::vector<float>{0, 3, 4, 0, 0, 0, nan, 0, 0});
    const Scene scene = read(builder);
    EXPECT_EQ(scene.meshes.at(0).normals,
              (std::vector<Float3>{{0, .6f, .8f}, {0, 0, 1}, {0, 0, 1}}));
    EXPECT_TRUE(notes(scene, "normals without a direction: 2, made from their triangles"));
}

}  // namespace
}  // namespace sheer::test
