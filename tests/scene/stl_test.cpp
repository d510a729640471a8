// STL files by hand, binary and text.
#include "scene/stl.h"

#include <limits>

#include "mesh_file_fixture.h"

namespace sheer::test {
namespace {

constexpr Float3 kA = {0, 0, 0}, kB = {1, 0, 0}, kC = {0, 2, 0}, kD = {0, 0, -3.5f};

using Triangle = std::array<Float3, 3>;

std::string binary(const std::vector<Triangle>& triangles, const std::string& start = "")
{
    std::string text = start;
    text.resize(80, ' ');
    text += packed(static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& triangle : triangles) {
        for (int i = 0; i < 3; ++i) text += packed(0.0f);
        for (const Float3& corner : triangle) {
            for (const float x : corner) text += packed(x);
        }
        text += "\x7f\xff";
    }
    return text;
}

void expect_two_triangles(const Scene& scene)
{
    expect_sound(scene);
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].positions, (std::vector<Float3>{kA, kB, kC, kD}));
    EXPECT_EQ(scene.meshes[0].indices, (Indices{0, 1, 2, 0, 2, 3}));
    EXPECT_TRUE(scene.meshes[0].normals.empty());
    EXPECT_TRUE(scene.materials[0].double_sided);
}

TEST(Stl, WhatFollowsBinaryTrianglesIsPassedOver)
{
    for (const char* start : {"solid of a writer that knows no better", "any"}) {
        std::string text = binary({{kA, kB, kC}, {kA, kC, kD}}, start);
        text.replace(60, 1, 1, '\0');
        const Scene scene = read_stl("a.stl", to_bytes(text + "\r\n"));
        expect_two_triangles(scene);
        EXPECT_EQ(scene.ignored.at(0), "bytes behind the triangles: 2, not read");
    }
}

TEST(Stl, ColoursAreNoted)
{
    const std::string text = binary({{kA, kB, kC}}, "COLOR=abcd");
    EXPECT_EQ(read_stl("a.stl", to_bytes(text)).ignored,
              (std::vector<std::string>{"colour in the header: 1, not read",
                                        "triangles with spare bytes, which may be colours: 1, not "
                                        "read"}));
}

TEST(Stl, BinaryCornersInOnePlaceAreOneVertex)
{
    // -0 is 0, and what the header begins with says nothing.
    const Float3 a = {-0.0f, 0, -0.0f};
    for (const std::string start : {"", "solid cube"}) {
        const Bytes bytes = to_bytes(binary({{kA, kB, kC}, {a, kC, kD}}, start));
        EXPECT_TRUE(is_binary_stl(bytes));
        expect_two_triangles(read_stl("dir/part.stl", bytes));
        EXPECT_EQ(read_stl("dir/part.stl", bytes).objects[0].name, "part");
    }
}

std::string facet(const std::vector<std::string>& corners)
{
    std::string text = "  facet normal 0 0 1\n    outer loop\n";
    for (const std::string& corner : corners) text += "      vertex " + corner + "\n";
    return text + "    endloop\n  endfacet\n";
}

const std::string kFirst = facet({"0 0 0", "1.0 0 0", "0 2e0 -0"});
const std::string kSecond = facet({"0 0 0", "0 2 0", "0 0 -3.5"});

TEST(Stl, Text)
{
    const std::string text = "solid two words\n" + kFirst + kSecond + "endsolid two words\n";
    EXPECT_FALSE(is_binary_stl(to_bytes(text)));
    expect_two_triangles(read_stl("part.stl", to_bytes(text)));
    EXPECT_EQ(read_stl("part.stl", to_bytes(text)).meshes[0].name, "two words");
    std::string capitals = text;
    for (char& c : capitals) c = static_cast<char>(std::toupper(c));
    expect_two_triangles(read_stl("part.stl", to_bytes(capitals)));
}

TEST(Stl, SolidsAreMeshes)
{
    const std::string text = "solid a\n" + kFirst + "endsolid a\nsolid\n" + kSecond + "endsolid\n";
    const Scene scene = read_stl("part.stl", to_bytes(text));
    expect_sound(scene);
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].name, "a");
    EXPECT_EQ(scene.objects[1].name, "part");
    EXPECT_EQ(scene.meshes[1].positions, (std::vector<Float3>{kA, kC, kD}));
}

TEST(Stl, SolidsAreCounted)
{
    const std::string solid = "solid a\n" + facet({"0 0 0", "1 0 0", "0 1 0"}) + "endsolid a\n";
    const Bytes two = to_bytes(solid + solid);
    EXPECT_EQ(read_stl("a.stl", two, {.most_objects = 2}).objects.size(), 2u);
    EXPECT_THROW(read_stl("a.stl", two, {.most_objects = 1}), Error);
}

TEST(Stl, LinesMayEndWithCarriageReturns)
{
    std::string text = "solid a\n" + facet({"0 0 0", "1 0 0", "0 1 0"}) + "endsolid a\n";
    std::replace(text.begin(), text.end(), '\n', '\r');
    EXPECT_EQ(read_stl("a.stl", to_bytes(text)).meshes.at(0).indices, (Indices{0, 1, 2}));
}

TEST(Stl, Faults)
{
    const auto fault = [](const std::string& text) { return fault_of(read_stl, text); };
    EXPECT_EQ(fault(""), "not an STL file, or one that is cut short");
    EXPECT_EQ(fault(binary({})), "the file holds no triangles");
    EXPECT_EQ(fault("solid a\nendsolid a\n"), "the file holds no triangles");
    EXPECT_EQ(fault("solid a\n" + facet({"0 0 0", "1 1 1"})),
              "line 6: a loop of fewer than 3 vertices");
    EXPECT_EQ(fault("solid a\nvertex 0 0\n"), "line 2: a number is missing");
    EXPECT_EQ(fault("solid a\nvertex 0 0 nan\n"), "line 2: 'nan' is not a finite number");
    EXPECT_EQ(fault("solid a\nvertex 0 0 1\n"), "line 2: the file is cut short");
    EXPECT_EQ(fault("solid a\nedge 0 0 1\n"), "line 2: 'edge' does not belong into an STL file");
    EXPECT_EQ(fault("solid a\nvertex 0 0 1\nendsolid\n"), "line 3: a loop has no end");
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(fault(binary({{kA, kB, kC}, {kA, {0, infinity, 0}, kC}})),
              "byte 162: a coordinate is not finite");
    // As many triangles as a word can say.
    std::string huge = binary({{kA, kB, kC}});
    huge.replace(80, 4, "\xff\xff\xff\xff");
    EXPECT_EQ(fault(huge), "not an STL file, or one that is cut short");
    const std::string whole = binary({{kA, kB, kC}});
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_EQ(fault(whole.substr(0, size)), "not an STL file, or one that is cut short")
            << size;
    }
}

TEST(Stl, ChangedFilesAreReadOrRefused)
{
    expect_survives_changes(read_stl, binary({{kA, kB, kC}, {kA, kC, kD}}), 20000);
    expect_survives_changes(read_stl, "solid a\n" + kFirst + kSecond + "endsolid a\n", 20000);
}

}  // namespace
}  // namespace sheer::test
