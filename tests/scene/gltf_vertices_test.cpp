// glTF vertex attributes that textures need: coordinates and tangents.

#include "gltf_fixture.h"

#include <limits>

#include "gltf_draco_file.h"

#include <cmath>

namespace sheer::test {
namespace {

template <class T>
void expect_coordinates(bool normalized, const std::vector<T>& values, const Float2& second)
{
    Builder builder = one_triangle();
    const std::size_t accessor = builder.accessor("VEC2", values);
    if (normalized) builder.json["accessors"][accessor]["normalized"] = true;
    for (const char* name : {"TEXCOORD_0", "TEXCOORD_1"}) {
        auto& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
        attributes.clear();
        attributes["POSITION"] = 0;
        attributes[name] = accessor;
        const Mesh mesh = read(builder).meshes.at(0);
        const std::size_t set = name[9] == '1';
        ASSERT_EQ(mesh.texcoords[set].size(), 3u);
        EXPECT_TRUE(mesh.texcoords[1 - set].empty());
        EXPECT_EQ(mesh.texcoords[set][1], second);
    }
}

TEST(GltfVertices, ReadsCoordinatesOfEveryType)
{
    expect_coordinates<float>(false, {0, 0, -3.5f, 0.25f, 0, 0}, {-3.5f, 0.25f});
    expect_coordinates<std::uint8_t>(true, {0, 0, 255, 51, 0, 0}, {1, 0.2f});
    expect_coordinates<std::uint16_t>(true, {0, 0, 65535, 13107, 0, 0}, {1, 0.2f});
    expect_coordinates<std::int8_t>(true, {0, 0, -128, 127, 0, 0}, {-1, 1});
    expect_coordinates<std::int16_t>(true, {0, 0, -32767, 32767, 0, 0}, {-1, 1});
    expect_coordinates<std::uint8_t>(false, {0, 0, 255, 51, 0, 0}, {255, 51});
    expect_coordinates<std::uint16_t>(false, {0, 0, 65535, 13107, 0, 0}, {65535, 13107});
    expect_coordinates<std::int8_t>(false, {0, 0, -128, 127, 0, 0}, {-128, 127});
    expect_coordinates<std::int16_t>(false, {0, 0, -32768, 1, 0, 0}, {-32768, 1});
}

TEST(GltfVertices, CoordinatesThatAreNoNumbersAreZero)
{
    Builder builder = one_triangle();
    const float nan = std::nanf("");
    builder.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
        builder.accessor("VEC2", std::vector<float>{1, 2, nan, 3, 4, 5});
    const Scene scene = read(builder);
    EXPECT_EQ(scene.meshes.at(0).texcoords[0], (std::vector<Float2>{{1, 2}, {0, 0}, {4, 5}}));
    EXPECT_TRUE(
        notes(scene, "texture coordinates that are infinite or not a number: 1, taken as 0"));
}

TEST(GltfVertices, ReadsTangents)
{
    const auto read_with = [](const std::vector<float>& tangents, bool normals = true) {
        Builder builder = one_triangle();
        Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
        attributes["TANGENT"] = builder.accessor("VEC4", tangents);
        if (normals) {
            attributes["NORMAL"] =
                builder.accessor("VEC3", std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1});
        }
        return read(builder);
    };
    const Scene good = read_with({2, 0, 0, 1, 0, 0.5f, 0, -1, 1, 0, 0, 1});
    EXPECT_EQ(good.meshes.at(0).tangents,
              (std::vector<Float4>{{1, 0, 0, 1}, {0, 1, 0, -1}, {1, 0, 0, 1}}));
    const Scene broken = read_with({1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1});
    EXPECT_TRUE(broken.meshes.at(0).tangents.empty());
    const std::string note =
        "primitives with a tangent without direction or side: 1, their tangents are made from "
        "texture coordinates";
    EXPECT_TRUE(notes(broken, note));
    EXPECT_TRUE(notes(read_with({1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 1}), note));
    // Without normals glTF wants tangents ignored.
    EXPECT_TRUE(
        read_with({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, false).meshes.at(0).tangents.empty());
}

// Three primitives of three corners each among 3,000 vertices of which each reads its own.
Builder with_shared_vertices()
{
    Builder builder;
    const std::size_t positions = builder.accessor("VEC3", curve(3000));
    std::vector<float> coordinates;
    for (int i = 0; i < 3000; ++i)
        coordinates.insert(coordinates.end(), {static_cast<float>(i), 0.5f});
    const std::size_t texcoords = builder.accessor("VEC2", coordinates);
    builder.primitive({{"POSITION", positions}, {"TEXCOORD_0", texcoords}});
    Json& primitives = builder.json["meshes"][0]["primitives"];
    const Json first = primitives[0];
    primitives = Json::array();
    for (const int start : {10, 500, 2996}) {
        Json one = first;
        const auto at = [&](int i) { return static_cast<std::uint16_t>(start + i); };
        one["indices"] =
            builder.accessor("SCALAR", std::vector<std::uint16_t>{at(3), at(0), at(1), at(3)});
        builder.json["accessors"].back()["count"] = 3;
        primitives.push_back(one);
    }
    return builder;
}

Scene read_with(const Builder& builder, const LoadOptions& options)
{
    const std::string text = builder.text();
    return read_gltf("test.gltf", Bytes(text.begin(), text.end()), options);
}

TEST(GltfVertices, OnlyThoseThatAPrimitiveUsesAreRead)
{
    // For each primitive 3 indices, 3 positions and 3 pairs of coordinates.
    const Builder builder = with_shared_vertices();
    const Scene scene = read_with(builder, {.most_elements = 27});
    EXPECT_THROW(read_with(builder, {.most_elements = 26}), Error);
    ASSERT_EQ(scene.meshes.size(), 3u);
    const Mesh& mesh = scene.meshes[1];
    EXPECT_EQ(mesh.positions,
              (std::vector<Float3>{{500, 250000, 0}, {501, 251001, 0}, {503, 253009, 0}}));
    EXPECT_EQ(mesh.texcoords[0], (std::vector<Float2>{{500, 0.5f}, {501, 0.5f}, {503, 0.5f}}));
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{2, 0, 1}));
}

TEST(GltfVertices, AmongSharedOnesSparseOnesFindTheirPlaces)
{
    Builder builder = with_shared_vertices();
    const std::size_t places = builder.view(std::vector<std::uint16_t>{501, 700, 2999});
    const std::size_t values = builder.view(std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9});
    builder.json["accessors"][0]["sparse"] = {
        {"count", 3},
        {"indices", {{"bufferView", places}, {"componentType", 5123}}},
        {"values", {{"bufferView", values}}}};
    const Scene scene = read(builder);
    EXPECT_EQ(scene.meshes.at(1).positions.at(1), (Float3{1, 2, 3}));
    EXPECT_EQ(scene.meshes.at(2).positions.at(2), (Float3{7, 8, 9}));
    EXPECT_EQ(scene.meshes.at(0).positions.at(0), (Float3{10, 100, 0}));
}

TEST(GltfVertices, FaultsOfSharedOnesNameTheFilesVertex)
{
    Builder builder = with_shared_vertices();
    const float infinity = std::numeric_limits<float>::infinity();
    std::memcpy(&builder.data[12 * 503], &infinity, sizeof infinity);
    EXPECT_EQ(fault_of(builder), "test.gltf: accessors[0]: vertex 503 is infinite or not a number");
    builder = with_shared_vertices();
    builder.json["accessors"][1]["count"] = 2999;
    EXPECT_NE(fault_of(builder).find("has 2999 elements, POSITION has 3000"), std::string::npos)
        << fault_of(builder);
}

TEST(GltfDraco, TrianglesThatNoAccessorCountsAreCounted)
{
    Builder builder = draco_file::compressed(draco_file::make_grid(2), false);  // 8 triangles
    Json& primitive = builder.json["meshes"][0]["primitives"][0];
    primitive.erase("indices");
    const std::size_t attributes =
        primitive["extensions"]["KHR_draco_mesh_compression"]["attributes"].size();
    const std::string text = builder.text();
    const Bytes content(text.begin(), text.end());
    LoadOptions options{.most_elements = 9 * attributes + 24};
    EXPECT_EQ(read_gltf("test.gltf", content, options).meshes.size(), 1u);
    --options.most_elements;
    EXPECT_THROW(read_gltf("test.gltf", content, options), Error);
}

TEST(GltfVertices, NotesFurtherSets)
{
    Builder builder = one_triangle();
    Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_2"] = 0;
    attributes["COLOR_1"] = 0;
    EXPECT_EQ(read(builder).ignored,
              (std::vector<std::string>{
                  "primitives with more than one set of colors: 1, the first is read",
                  "primitives with more than two sets of texture coordinates: 1, the first two are "
                  "read"}));
}

}  // namespace
}  // namespace sheer::test
