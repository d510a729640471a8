// PLY files by hand: what stands in them, and what is said of faults.
#include "scene/ply.h"

#include "mesh_file_fixture.h"

namespace sheer::test {
namespace {

std::string ascii(const std::string& elements, const std::string& rows)
{
    return "ply\nformat ascii 1.0\ncomment made by hand\n" + elements + "end_header\n" + rows;
}

std::string vertices(int count, const std::string& more = "")
{
    return "element vertex " + std::to_string(count) +
           "\nproperty float x\nproperty float y\nproperty float z\n" + more;
}

std::string faces(int count)
{
    return "element face " + std::to_string(count) + "\nproperty list uchar int vertex_indices\n";
}

Scene read(const std::string& text)
{
    Scene scene = read_ply("dir/mesh.ply", to_bytes(text));
    expect_sound(scene);
    return scene;
}

const std::string kCorners = "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n";

TEST(Ply, PolygonsAreCutAroundTheirFirstCorner)
{
    const Scene scene = read(ascii(vertices(4) + faces(2), kCorners + "4 0 1 2 3\n3 3 2 0\n"));
    ASSERT_EQ(scene.meshes.size(), 1u);
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.topology, Topology::triangles);
    EXPECT_EQ(mesh.positions, (std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5f}}));
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 2, 3, 3, 2, 0}));
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_TRUE(mesh.colors.empty());
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].name, "mesh");
    EXPECT_EQ(scene.objects[0].transform, kIdentity);
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].base_color, (Float3{0.7f, 0.7f, 0.7f}));
    EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::opaque);
    EXPECT_TRUE(scene.materials[0].double_sided);
}

TEST(Ply, NotchesOfFacesStayOpen)
{
    const std::string corners = "0 0 0\n2 1 0\n0 2 0\n1 1 0\n";
    const Scene scene = read(ascii(vertices(4) + faces(1), corners + "4 0 1 2 3\n"));
    EXPECT_EQ(scene.meshes.at(0).indices, (Indices{1, 2, 3, 3, 0, 1}));
}

TEST(Ply, FacesBeforeVerticesAreFans)
{
    const Mesh mesh = read(ascii(faces(1) + vertices(4), "4 0 1 2 3\n" + kCorners)).meshes[0];
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 2, 3}));
}

// A stray vertex far away would put the scene into a corner of the picture.
TEST(Ply, VerticesThatNoFaceUsesAreLeftOut)
{
    const Mesh mesh =
        read(ascii(vertices(4) + faces(1), "9e9 0 0\n0 0 0\n1 0 0\n1 1 0\n3 1 2 3\n")).meshes[0];
    EXPECT_EQ(mesh.positions, (std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2}));
}

TEST(Ply, WhatIsIncompleteIsNoted)
{
    const auto ignored = [](const std::string& more, const std::string& rest) {
        return read(ascii("comment TextureFile a.png\n" + vertices(3, more) + faces(2),
                          "0 0 0 " + rest + "\n1 0 0 " + rest + "\n1 1 0 " + rest +
                              "\n3 0 1 2\n2 0 1\n"))
            .ignored;
    };
    const std::string always = "textures that a comment names: 1, drawn without";
    const std::string faces = "faces of fewer than 3 corners: 1, not drawn";
    using Lines = std::vector<std::string>;
    EXPECT_EQ(ignored("", ""), (Lines{faces, always}));
    EXPECT_EQ(ignored("property uchar alpha\n", "9"),
              (Lines{"alpha without red, green and blue: 1, not read", faces, always}));
    EXPECT_EQ(ignored("property float nx\n", "1"),
              (Lines{faces, "normals without nx, ny and nz: 1, not read", always}));
    EXPECT_EQ(ignored("property uchar red\n", "1"),
              (Lines{"colours without red, green and blue: 1, not read", faces, always}));
    EXPECT_EQ(ignored("property float s\n", "1"),
              (Lines{faces, "texture coordinates of which one is missing: 1, not read", always}));
}

TEST(Ply, WhatIsNotReadIsNoted)
{
    const Scene scene = read(ascii(vertices(3, "property float quality\n") + faces(1) +
                                       "property uchar red\nelement camera 2\nproperty int id\n",
                                   "0 0 0 9\n1 0 0 9\n1 1 0 9\n3 0 1 2 255\n7\n8\n"));
    EXPECT_EQ(scene.ignored, (std::vector<std::string>{"elements called camera: 2, not read",
                                                       "property quality of each vertex: 1, not "
                                                       "read",
                                                       "property red of each face: 1, not read"}));
}

TEST(Ply, VertexPropertiesInAnyOrder)
{
    const std::string elements =
        "element vertex 3\nproperty uchar blue\nproperty float t\nproperty float s\n"
        "property double z\nproperty short y\nproperty int x\nproperty float nz\n"
        "property float ny\nproperty float nx\nproperty uchar red\nproperty uchar green\n" +
        faces(1);
    const std::string rows =
        "255 0.25 0.5 3 2 1 0 4 3 0 128\n0 0 0 0 0 1 1 0 0 0 0\n"
        "0 0 0 0 1 0 1 0 0 51 0\n3 0 1 2\n";
    const Scene scene = read(ascii(elements, rows));
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.positions[0], (Float3{1, 2, 3}));
    EXPECT_FLOAT_EQ(mesh.normals[0][0], 0.6f);
    EXPECT_FLOAT_EQ(mesh.normals[0][1], 0.8f);
    EXPECT_FLOAT_EQ(mesh.normals[0][2], 0);
    EXPECT_EQ(mesh.texcoords[0][0], (Float2{0.5f, 0.75f}));
    EXPECT_EQ(mesh.colors[0][0], 0);
    EXPECT_FLOAT_EQ(mesh.colors[0][1], decoded_srgb(128 / 255.0));
    EXPECT_EQ(mesh.colors[0][2], 1);
    EXPECT_EQ(mesh.colors[0][3], 1);
    EXPECT_FLOAT_EQ(mesh.colors[2][0], decoded_srgb(0.2));
    EXPECT_EQ(scene.materials[0].base_color, (Float3{1, 1, 1}));
}

TEST(Ply, ColorsOfEveryType)
{
    const auto color = [](const std::string& type, const std::string& value) {
        const std::string names =
            "property " + type + " red\nproperty " + type + " green\nproperty " + type + " blue\n";
        const std::string row = "0 0 0 0 " + value + " " + value + "\n";
        return read(ascii(vertices(1, names), row)).meshes[0].colors[0];
    };
    EXPECT_FLOAT_EQ(color("uchar", "51")[1], decoded_srgb(0.2));
    EXPECT_FLOAT_EQ(color("ushort", "13107")[1], decoded_srgb(0.2));
    EXPECT_EQ(color("char", "127")[1], 1);
    EXPECT_FLOAT_EQ(color("short", "6553.4")[1], decoded_srgb(0.2));
    EXPECT_EQ(color("int", "2147483647")[1], 1);
    EXPECT_FLOAT_EQ(color("float", "0.2")[1], decoded_srgb(0.2));
    EXPECT_EQ(color("float", "1")[1], 1);
    EXPECT_EQ(color("float", "7")[1], 1);
    EXPECT_EQ(color("float", "-1")[1], 0);
    EXPECT_EQ(color("float", "nan")[1], 0);
    EXPECT_EQ(color("uchar", "300")[1], 1);
}

TEST(Ply, AlphaBelowOneIsBlended)
{
    const std::string names =
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
    const auto material = [&](const std::string& alpha) {
        return read(ascii(vertices(1, names), "0 0 0 9 9 9 " + alpha + "\n"));
    };
    EXPECT_EQ(material("255").materials[0].alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(material("51").materials[0].alpha_mode, AlphaMode::blend);
    EXPECT_FLOAT_EQ(material("51").meshes[0].colors[0][3], 0.2f);
}

// The same content in each order of bytes, with things to be skipped between what is read.
std::string binary(bool big)
{
    std::string text = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                       "_endian 1.0\nelement vertex 3\nproperty double x\nproperty float y\n"
                       "property list ushort double weights\nproperty short z\nproperty uchar q\n"
                       "element strange 2\nproperty list int ushort a\nproperty char b\n"
                       "element face 1\nproperty int flags\n"
                       "property list uint ushort vertex_index\nproperty float quality\n"
                       "end_header\n";
    for (int i = 0; i < 3; ++i) {
        text += packed(0.25 * i, big) + packed(1.5f - static_cast<float>(i), big) +
                packed(static_cast<std::uint16_t>(i), big);
        for (int k = 0; k < i; ++k) text += packed(1e300, big);
        text += packed(static_cast<std::int16_t>(-300 * i), big) + "q";
    }
    text += packed(std::int32_t{2}, big) + "wxyz" + "b" + packed(std::int32_t{0}, big) + "b";
    text += packed(std::int32_t{-7}, big) + packed(std::uint32_t{3}, big);
    for (const int i : {2, 0, 1}) text += packed(static_cast<std::uint16_t>(i), big);
    return text + packed(0.5f, big);
}

TEST(Ply, BinaryOfEitherByteOrder)
{
    for (const bool big : {false, true}) {
        const Mesh mesh = read(binary(big)).meshes[0];
        EXPECT_EQ(mesh.positions,
                  (std::vector<Float3>{{0, 1.5f, 0}, {0.25f, 0.5f, -300}, {0.5f, -0.5f, -600}}));
        EXPECT_EQ(mesh.indices, (Indices{2, 0, 1}));
    }
}

TEST(Ply, HeadersOfCarriageReturns)
{
    // 10 is the byte of a line feed.
    std::string text =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\n"
        "property uchar y\nproperty uchar z\nend_header\n";
    std::replace(text.begin(), text.end(), '\n', '\r');
    EXPECT_EQ(read(text + "\n\n\r").meshes[0].positions, (std::vector<Float3>{{10, 10, 13}}));
}

// Programs that append to a file of others end lines in their own way.
TEST(Ply, RowsNeedNotEndAsTheHeaderDoes)
{
    std::string header = ascii(vertices(3) + faces(1), "");
    std::replace(header.begin(), header.end(), '\n', '\r');
    const std::vector<Float3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (const std::string rows :
         {"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r\n",
          "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2"}) {
        EXPECT_EQ(read(header + rows).meshes[0].positions, corners) << rows;
    }
}

TEST(Ply, StripsEndAtMinusOne)
{
    const std::string elements =
        vertices(4) + "element tristrips 1\nproperty list int int vertex_indices\n";
    // 0 1 2 3, then 3 3 2 1, whose first triangle has no area, then one of two vertices.
    const Mesh mesh = read(ascii(elements, kCorners + "12 0 1 2 3 -1 3 3 2 1 -1 0 1\n")).meshes[0];
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 2, 1, 3, 2, 3, 1}));
}

TEST(Ply, EdgesAreLines)
{
    const std::string edges = "element edge 2\nproperty int vertex1\nproperty int vertex2\n";
    const Mesh mesh = read(ascii(vertices(4) + edges, kCorners + "0 1\n1 3\n")).meshes[0];
    EXPECT_EQ(mesh.topology, Topology::lines);
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 1, 2}));  // the vertex that no edge uses is left out
    EXPECT_EQ(mesh.positions.at(2), (Float3{0, 1, 0.5f}));

    const Scene both =
        read(ascii(vertices(4) + faces(1) + edges, kCorners + "3 0 1 2\n3 1\n1 3\n"));
    ASSERT_EQ(both.meshes.size(), 2u);
    EXPECT_EQ(both.objects[0].name, "mesh edges");
    EXPECT_EQ(both.meshes[0].positions, (std::vector<Float3>{{1, 0, 0}, {0, 1, 0.5f}}));
    EXPECT_EQ(both.meshes[0].indices, (Indices{1, 0, 0, 1}));
    EXPECT_EQ(both.meshes[1].indices, (Indices{0, 1, 2}));
    EXPECT_NE(both.objects[0].id, both.objects[1].id);
    // What is thin is dark, to be seen before a light background.
    EXPECT_EQ(both.materials[both.meshes[0].material].base_color, (Float3{0.1f, 0.1f, 0.1f}));
    EXPECT_EQ(both.materials[both.meshes[1].material].base_color, (Float3{0.7f, 0.7f, 0.7f}));
}

TEST(Ply, VerticesAloneArePoints)
{
    const std::string normals = "property float nx\nproperty float ny\nproperty float nz\n";
    const Mesh mesh = read(ascii(vertices(2, normals), "0 0 0 1 0 0\n1 2 3 0 1 0\n")).meshes[0];
    EXPECT_EQ(mesh.topology, Topology::points);
    EXPECT_EQ(mesh.indices, (Indices{0, 1}));
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_EQ(read(ascii(vertices(1) + faces(0), "0 0 0")).meshes[0].topology, Topology::points);
}

TEST(Ply, LineEndsOfWindowsAndRowsOnAnyLines)
{
    std::string text = ascii(vertices(3) + faces(1), "0 0 0 1 0 0\n\n1 1\n0\n3 0\n1 2");
    EXPECT_EQ(read(text).meshes[0].indices, (Indices{0, 1, 2}));
    for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 2)) {
        text.insert(i, "\r");
    }
    EXPECT_EQ(read(text).meshes[0].indices, (Indices{0, 1, 2}));
    std::erase(text, '\n');
    EXPECT_EQ(read(text).meshes[0].indices, (Indices{0, 1, 2}));
}

TEST(Ply, Faults)
{
    const auto fault = [](const std::string& text) { return fault_of(read_ply, text); };
    EXPECT_EQ(fault(""), "not a PLY file");
    EXPECT_EQ(fault("plyx\n"), "not a PLY file");
    EXPECT_EQ(fault("ply\nformat ascii 1.0\n"), "the header has no end");
    EXPECT_EQ(fault("ply\nend_header\n"), "line 2: the header names no format");
    EXPECT_EQ(fault("ply\nformat cuneiform 1.0\n"), "line 2: 'cuneiform' is not a PLY format");
    EXPECT_EQ(fault("ply\nproperty float x\n"), "line 2: a property before the first element");
    EXPECT_EQ(fault("ply\nelement vertex -1\n"), "line 2: '-1' is not a whole number");
    EXPECT_EQ(fault("ply\nelement vertex 99999999999999999999\n"),
              "line 2: '99999999999999999999' is not a whole number");
    EXPECT_EQ(fault("ply\nelement vertex 1\nproperty quad x\n"),
              "line 3: 'quad' is not a property's type");
    EXPECT_EQ(fault("ply\nvertex 1\n"), "line 2: 'vertex' does not belong into a header");
    EXPECT_EQ(fault("ply\nelement face 1\nelement face 2\n"),
              "line 3: 'face' is an element already");
    EXPECT_EQ(fault(ascii(faces(0), "")), "the file holds no vertices");
    EXPECT_EQ(fault(ascii("element vertex 3\n" + faces(1), "3 0 1 2\n")),
              "line 7: vertices without x, y and z");
    EXPECT_EQ(fault(ascii("element vertex 1\nproperty float x\n", "1\n")),
              "line 6: vertices without x, y and z");
    EXPECT_EQ(fault(ascii(vertices(1), "1 2 z\n")), "line 9: 'z' is not a number");
    EXPECT_EQ(fault(ascii(vertices(1), "1 2 inf\n")),
              "line 9: the position of vertex 0 is not finite");
    EXPECT_EQ(fault(ascii(vertices(1), "1 2 1e99\n")),
              "line 9: the position of vertex 0 is not finite");
    EXPECT_EQ(fault(ascii(vertices(2), "1 2 3\n4 5  \n")), "line 10: the file is cut short");
    const std::string one = vertices(1) + faces(1);
    EXPECT_EQ(fault(ascii(one, "1 2 3\n3 0 0 1\n")), "line 12: a vertex that does not exist");
    EXPECT_EQ(fault(ascii(one, "1 2 3\n3 0 0 -1\n")), "line 12: a vertex that does not exist");
    EXPECT_EQ(fault(ascii(one, "1 2 3\n3 0 0 nan\n")), "line 12: a vertex that does not exist");
    EXPECT_EQ(fault(ascii(one, "1 2 3\n-3 0 0\n")), "line 12: a list has a negative length");
    EXPECT_EQ(fault(ascii(one, "1 2 3\nnan 0 0\n")), "line 12: a list's length is not a number");
    EXPECT_EQ(fault(ascii(one, "1 2 3\n4000000000 0\n")),
              "line 12: a list is longer than the file");
}

TEST(Ply, CountsBeyondTheFileAllocateNothing)
{
    const auto fault = [](const std::string& format, const std::string& elements) {
        return fault_of(read_ply,
                        "ply\nformat " + format + " 1.0\n" + elements + "end_header\n0 0 0 0 0 0 ");
    };
    const std::string many =
        "element vertex 18446744073709551615\nproperty float x\n"
        "property float y\nproperty float z\n";
    EXPECT_EQ(fault("ascii", many),
              "line 7: the file is too short for its 18446744073709551615 rows of 'vertex'");
    EXPECT_NE(fault("binary_little_endian", many).find("is too short for its 184467"),
              std::string::npos);
    // One vertex takes the twelve bytes there are.
    const std::string one =
        "element vertex 1\nproperty float x\nproperty float y\n"
        "property float z\n";
    EXPECT_EQ(fault("binary_little_endian", one), "");
    EXPECT_NE(fault("binary_little_endian", one + faces(1'000'000'000)).find("of 'face'"),
              std::string::npos);
}

TEST(Ply, HeadersHaveAnEnd)
{
    std::string elements, properties = "element vertex 1\n";
    for (int i = 0; i < 100'000; ++i) {
        elements += "element e" + std::to_string(i) + " 0\n";
        properties += "property float p" + std::to_string(i) + "\n";
    }
    EXPECT_EQ(fault_of(read_ply, ascii(elements, "")), "line 1004: more than 1000 elements");
    EXPECT_EQ(fault_of(read_ply, ascii(properties, "")), "line 1005: more than 1000 properties");
}

TEST(Ply, RefusesEveryTruncatedFile)
{
    const std::string whole = binary(true);
    ASSERT_EQ(fault_of(read_ply, whole), "");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_NE(fault_of(read_ply, whole.substr(0, size)), "") << size;
    }
}

TEST(Ply, SplatsAreRefused)
{
    const std::string says = "Gaussian splats are not supported yet";
    EXPECT_EQ(fault_of(read_ply, ascii(vertices(0, "property float f_dc_0\n"), "")), says);
    EXPECT_EQ(fault_of(read_ply, ascii("element chunk 0\nproperty float min_x\n"
                                       "element vertex 0\nproperty uint packed_position\n",
                                       "")),
              says);
}

TEST(Ply, ChangedFilesAreReadOrRefused)
{
    expect_survives_changes(read_ply, binary(false), 20000);
    expect_survives_changes(
        read_ply, ascii(vertices(4) + faces(2), kCorners + "4 0 1 2 3\n3 3 2 0\n"), 20000);
}

}  // namespace
}  // namespace sheer::test
