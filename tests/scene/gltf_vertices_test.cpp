// glTF vertex attributes that textures need: coordinates and tangents.

#include "gltf_fixture.h"

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
