// OBJ files by hand: what stands in them, and what is said of faults.
#include "scene/obj.h"

#include "mesh_file_fixture.h"

namespace sheer::test {
namespace {

Scene read(const std::string& text)
{
    Scene scene = read_obj("dir/mesh.obj", to_bytes(text));
    expect_sound(scene);
    return scene;
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::vector<Float3> kSquareCorners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

bool is_noted(const Scene& scene, const std::string& line)
{
    return std::find(scene.ignored.begin(), scene.ignored.end(), line) != scene.ignored.end();
}

TEST(Obj, PolygonsAreCutAroundTheirFirstCorner)
{
    const Scene scene = read("# a square\n" + kSquare + "\nf 1 2 3 4 # all\nf 3 2 1\n");
    ASSERT_EQ(scene.meshes.size(), 1u);
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.positions, kSquareCorners);
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 2, 3, 2, 1, 0}));
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_TRUE(mesh.texcoords[0].empty());
    EXPECT_TRUE(mesh.colors.empty());
    EXPECT_EQ(scene.objects[0].name, "mesh");
    EXPECT_EQ(scene.materials[0].base_color, (Float3{0.7f, 0.7f, 0.7f}));
    EXPECT_TRUE(scene.materials[0].double_sided);
    EXPECT_TRUE(scene.ignored.empty());
}

// Around the first corner the triangle 1 2 3 would fill the notch.
TEST(Obj, NotchesOfFacesStayOpen)
{
    const Scene scene = read("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n");
    EXPECT_EQ(scene.meshes.at(0).indices, (Indices{1, 2, 3, 3, 0, 1}));
}

TEST(Obj, CornersThatAreEqualInAllAreOneVertex)
{
    // The second face shares 1/1/1 alone: 3/2/1 differs in its texture coordinates, 4/1/2 is new.
    const Mesh mesh = read(kSquare +
                           "vt 0.25 0.25\nvt 0.5 1 0\nvt 0.75\nvn 0 0 2\nvn 0 -3 4\n"
                           "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/2/1 4/1/2\n")
                          .meshes[0];
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 3, 4}));
    EXPECT_EQ(mesh.positions,
              (std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}}));
    // v goes up in the file, and counts as 0 where it is missing.
    EXPECT_EQ(
        mesh.texcoords[0],
        (std::vector<Float2>{{0.25f, 0.75f}, {0.5f, 0}, {0.75f, 1}, {0.5f, 0}, {0.25f, 0.75f}}));
    EXPECT_EQ(mesh.normals[0], (Float3{0, 0, 1}));
    EXPECT_FLOAT_EQ(mesh.normals[4][1], -0.6f);
    EXPECT_FLOAT_EQ(mesh.normals[4][2], 0.8f);
}

TEST(Obj, CornersOfEveryForm)
{
    const std::string start = kSquare + "vt 0 1\nvn 0 0 1\n";
    for (const std::string face :
         {"1 2 3", "1// 2// 3//", "1/ 2/ 3/", "1/1 2/1 3/1", "1//1 2//1 3//1", "1/1/1 2/1/1 3/1/1",
          "-4 -3 -2", "-4/-1/-1 2/1/-1 -2/1/1", "1/1/ 2/1/ 3/1/"}) {
        const Mesh mesh = read(start + "f " + face).meshes[0];
        EXPECT_EQ(mesh.indices, (Indices{0, 1, 2})) << face;
        EXPECT_EQ(mesh.positions[2], (Float3{1, 1, 0})) << face;
        EXPECT_EQ(mesh.texcoords[0].empty(),
                  face.find("/1") == std::string::npos || face == "1//1 2//1 3//1")
            << face;
        EXPECT_EQ(mesh.normals.empty(), face.find("1/1/1") == std::string::npos &&
                                            face.find("//1") == std::string::npos &&
                                            face.find("/-1/-1") == std::string::npos)
            << face;
    }
}

TEST(Obj, NegativeNumbersCountFromTheLatest)
{
    const Mesh mesh =
        read("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n").meshes[0];
    EXPECT_EQ(mesh.positions, (std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}));
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 3, 2, 1}));
}

TEST(Obj, MissingNormalsAreMadeFromTriangles)
{
    const Mesh mesh = read(kSquare + "vn 1 0 0\nf 1//1 2//1 3//1\nf 1 3 4\n").meshes[0];
    ASSERT_EQ(mesh.normals.size(), 6u);
    EXPECT_EQ(mesh.normals[0], (Float3{1, 0, 0}));
    EXPECT_EQ(mesh.normals[5], (Float3{0, 0, 1}));
}

TEST(Obj, ColorsOfVertices)
{
    const Scene scene = read("v 0 0 0\nv 1 0 0 0.2 1 0\nv 0 1 0 0.5\nf 1 2 3\n");
    const Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.colors.size(), 3u);
    EXPECT_EQ(mesh.colors[0], (Float4{1, 1, 1, 1}));
    EXPECT_FLOAT_EQ(mesh.colors[1][0], decoded_srgb(0.2));
    EXPECT_EQ(mesh.colors[1][1], 1);
    EXPECT_EQ(mesh.colors[1][2], 0);
    EXPECT_EQ(mesh.colors[2], (Float4{1, 1, 1, 1}));  // a weight is no colour
    EXPECT_EQ(scene.materials[0].base_color, (Float3{1, 1, 1}));
}

TEST(Obj, NamesAndMaterialsMakeMeshes)
{
    const Scene scene = read(kSquare +
                             "g inner\no first part\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n"
                             "g passed over\nusemtl red\nf 4 3 2\no second\nf 2 3 4\n");
    ASSERT_EQ(scene.meshes.size(), 3u);
    EXPECT_EQ(scene.meshes[0].name, "first part");
    EXPECT_EQ(scene.meshes[1].name, "first part");
    EXPECT_EQ(scene.meshes[2].name, "second");
    EXPECT_EQ(scene.meshes[0].indices, (Indices{0, 1, 2, 3, 2, 1}));
    EXPECT_EQ(scene.meshes[1].indices, (Indices{0, 1, 2}));
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[scene.meshes[0].material].name, "red");
    EXPECT_EQ(scene.materials[scene.meshes[1].material].name, "blue");
    EXPECT_EQ(scene.materials[scene.meshes[2].material].name, "red");
    EXPECT_TRUE(is_noted(scene, "materials that no library has: 2, drawn grey"));
    for (std::uint32_t i = 0; i < 3; ++i) {
        EXPECT_EQ(scene.objects[i].mesh, i);
        EXPECT_EQ(scene.objects[i].id, i);
    }
}

TEST(Obj, GroupsNameWhatHasNoObjects)
{
    const Scene scene = read(kSquare + "g left\nf 1 2 3\ng right\nf 1 3 4\ng\nf 1 2 4\n");
    ASSERT_EQ(scene.meshes.size(), 3u);
    EXPECT_EQ(scene.meshes[0].name, "left");
    EXPECT_EQ(scene.meshes[1].name, "right");
    EXPECT_EQ(scene.meshes[2].name, "mesh");
}

TEST(Obj, PolylinesShareTheirPoints)
{
    const Scene scene = read(kSquare + "vt 0 0\nl 1 2/1 3\nl 4 1\np 2 3\np 2\n");
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[0].topology, Topology::lines);
    EXPECT_EQ(scene.meshes[0].indices, (Indices{0, 1, 1, 2, 3, 0}));
    EXPECT_EQ(scene.meshes[0].positions, kSquareCorners);
    EXPECT_EQ(scene.meshes[1].topology, Topology::points);
    EXPECT_EQ(scene.meshes[1].indices, (Indices{0, 1, 0}));
    EXPECT_EQ(scene.meshes[1].positions, (std::vector<Float3>{{1, 0, 0}, {1, 1, 0}}));
}

TEST(Obj, ThinThingsWithoutAMaterialAreDark)
{
    const Scene scene = read(kSquare + "f 1 2 3\nl 1 2\np 3\nl 2 4\n");
    ASSERT_EQ(scene.meshes.size(), 3u);
    ASSERT_EQ(scene.materials.size(), 2u);
    for (const Mesh& mesh : scene.meshes) {
        const float grey = mesh.topology == Topology::triangles ? 0.7f : 0.1f;
        EXPECT_EQ(scene.materials[mesh.material].base_color, (Float3{grey, grey, grey}));
    }
}

TEST(Obj, VerticesAloneArePoints)
{
    const Mesh mesh = read("vn 0 0 1\nv 1 2 3\nvn 0 0 1\nv 4 5 6\n").meshes[0];
    EXPECT_EQ(mesh.topology, Topology::points);
    EXPECT_EQ(mesh.indices, (Indices{0, 1}));
    EXPECT_EQ(mesh.positions, (std::vector<Float3>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(Obj, NumbersAndLinesOfEveryForm)
{
    const Mesh mesh = read(
                          "\xef\xbb\xbfv +1 2. .5\r\nv\t-1e2  2.E1 1e-60  \r\nv 0\\\n 0 \\\r\n 0\n"
                          "f 1 \\\n 2 3")
                          .meshes[0];
    EXPECT_EQ(mesh.positions, (std::vector<Float3>{{1, 2, 0.5f}, {-100, 20, 0}, {0, 0, 0}}));
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2}));
}

TEST(Obj, WhatIsNotDrawnIsNoted)
{
    const Scene scene =
        read(kSquare + "f 1 2 3\nf 1 2\nl 1\ncurv 0 1 1 2\ns off\nmtllib none.mtl\n");
    EXPECT_EQ(scene.ignored,
              (std::vector<std::string>{"faces of fewer than 3 corners: 1, not drawn",
                                        "free-form curves and surfaces: 1, not drawn",
                                        "lines of fewer than 2 points: 1, not drawn",
                                        "material library 'none.mtl', which is not in the file's "
                                        "folder: 1, drawn without it"}));
    EXPECT_EQ(scene.meshes.size(), 1u);
}

TEST(Obj, StatementsThatAreNotKnownAreNoted)
{
    const Scene scene = read(kSquare + "# v\nfo 1 2 3\nvp 0 1\nvp 1 1\ns 1\ns off\nlod 3\n");
    EXPECT_EQ(scene.meshes.at(0).indices, (Indices{0, 1, 2}));  // fo is what f was called once
    EXPECT_EQ(scene.ignored,
              (std::vector<std::string>{"smoothing groups without normals: 1, drawn flat",
                                        "statements called lod: 1, not read",
                                        "statements called vp: 2, not read"}));
    EXPECT_TRUE(read(kSquare + "vn 0 0 1\ns 1\nf 1//1 2//1 3//1\n").ignored.empty());
}

// As PLY and glTF do: only positions must be numbers.
TEST(Obj, NormalsAndTextureCoordinatesThatAreNoNumbers)
{
    const Scene scene = read(kSquare + "vn nan 0 0\nvt nan 0\nvt 1 inf\nf 1/1/1 2/2/1 3/1/1\n");
    EXPECT_EQ(scene.meshes.at(0).texcoords[0].at(0), (Float2{0, 0}));
    EXPECT_EQ(scene.meshes.at(0).texcoords[0].at(1), (Float2{0, 0}));
    EXPECT_FLOAT_EQ(std::abs(scene.meshes.at(0).normals.at(0)[2]), 1);
}

TEST(Obj, LinesMayEndWithCarriageReturns)
{
    std::string text = kSquare + "f 1 2 3\n";
    std::replace(text.begin(), text.end(), '\n', '\r');
    EXPECT_EQ(read(text).meshes.at(0).indices, (Indices{0, 1, 2}));
}

// Each is kept once, whatever the number of parts; scenes get their beginnings.
TEST(Obj, LongNamesStayApart)
{
    const std::string same(100000, 'x');
    std::string text = kSquare + "usemtl " + same + "1\n";
    for (int i = 0; i < 3000; ++i) text += "g " + std::to_string(i) + "\nf 1 2 3\n";
    text += "usemtl " + same + "2\nf 1 2 3\n";
    const Scene scene = read(text);
    EXPECT_EQ(scene.meshes.size(), 3001u);
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[0].name, std::string(128, 'x'));
    EXPECT_EQ(read(kSquare + "o " + same + "\nf 1 2 3\n").objects.at(0).name,
              std::string(128, 'x'));
}

TEST(Obj, Faults)
{
    const auto fault = [](const std::string& text) { return fault_of(read_obj, text); };
    EXPECT_EQ(fault(""), "the file holds nothing that can be drawn");
    EXPECT_EQ(fault("\xfe\xff"), "UTF-16 text is not supported, only UTF-8 is");
    EXPECT_EQ(fault("v 0 0\n"), "line 1: a number is missing");
    EXPECT_EQ(fault("v 0 0 zero\n"), "line 1: 'zero' is not a number");
    EXPECT_EQ(fault("v 0 0 1.0.0\n"), "line 1: '1.0.0' is not a number");
    EXPECT_EQ(fault("v 0 0 nan\n"), "line 1: 'nan' is not a finite number");
    EXPECT_EQ(fault("v 0 0 -inf\n"), "line 1: '-inf' is not a finite number");
    EXPECT_EQ(fault("v 0 0 1e39\n"), "line 1: '1e39' is not a finite number");
    EXPECT_EQ(fault("v 0 0 1e999\n"), "line 1: '1e999' is too large or too small a number");
    EXPECT_EQ(fault("\n\nv 0 0 " + std::string(100, 'x') + "\n"),
              "line 3: '" + std::string(40, 'x') + "...' is not a number");
    EXPECT_EQ(fault(kSquare + "f 1 2 5\n"), "line 5: there is no vertex 5 before this line");
    EXPECT_EQ(fault(kSquare + "f 1 2 0\n"), "line 5: there is no vertex 0 before this line");
    EXPECT_EQ(fault(kSquare + "f 1 2 -5\n"), "line 5: there is no vertex -5 before this line");
    EXPECT_EQ(fault(kSquare + "f 1/1 2 3\n"),
              "line 5: there is no texture coordinate 1 before this line");
    EXPECT_EQ(fault(kSquare + "f 1//7 2 3\n"), "line 5: there is no normal 7 before this line");
    for (const std::string corner : {"a", "/1", "1/1/1/1", "1.5", "1/a", "99999999999999999999"}) {
        EXPECT_EQ(fault(kSquare + "vt 0 0\nvn 0 0 1\nf 1 2 " + corner),
                  "line 7: '" + corner + "' is not a corner of a face");
    }
    EXPECT_EQ(fault(kSquare + "f 1 \\\n 2 \\\n 9\n"),
              "line 7: there is no vertex 9 before this line");
}

TEST(Obj, ChangedFilesAreReadOrRefused)
{
    expect_survives_changes(read_obj,
                            kSquare +
                                "v 0 0 0 1 1 1\nvt 0 1\nvn 0 0 1\no a\nf 1/1/1 2/1/1 3\n"
                                "usemtl b\nl 1 2 3\np -1 -2\nmtllib c.mtl\n",
                            20000);
}

}  // namespace
}  // namespace sheer::test
