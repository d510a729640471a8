// glTF meshes that are not as their positions say: morph targets, skins, instances.

#include "gltf_fixture.h"

#include <cmath>

namespace sheer::test {
namespace {

Json& primitive_of(Builder& builder)
{
    return builder.json["meshes"][0]["primitives"][0];
}

std::vector<float> repeated(int count, std::initializer_list<float> values)
{
    std::vector<float> list;
    for (int i = 0; i < count; ++i) list.insert(list.end(), values);
    return list;
}

// The triangle (0 0 0, 1 1 0, 2 4 0) with a target that moves its second vertex by (0 0 8) and one
// that moves all by (2 0 0).
Builder with_targets()
{
    Builder builder = one_triangle();
    primitive_of(builder)["targets"] = {
        {{"POSITION", builder.accessor("VEC3", std::vector<float>{0, 0, 0, 0, 0, 8, 0, 0, 0})}},
        {{"POSITION", builder.accessor("VEC3", repeated(3, {2, 0, 0}))}}};
    return builder;
}

TEST(GltfMorph, TheMeshesWeightsMoveIt)
{
    Builder builder = with_targets();
    EXPECT_EQ(read(builder).meshes.at(0).positions[1], (Float3{1, 1, 0}));
    builder.json["meshes"][0]["weights"] = {0.5, -1};
    EXPECT_EQ(read(builder).meshes.at(0).positions,
              (std::vector<Float3>{{-2, 0, 0}, {-1, 1, 4}, {0, 4, 0}}));
    EXPECT_TRUE(read(builder).ignored.empty());
}

TEST(GltfMorph, ANodesWeightsGoBefore)
{
    Builder builder = with_targets();
    builder.json["meshes"][0]["weights"] = {1, 0};
    builder.json["nodes"] = parse_json(
        R"([{"mesh": 0}, {"mesh": 0, "weights": [0, 0]}, {"mesh": 0, "weights": [0, 1]},
            {"mesh": 0, "weights": [1, 0]}])");
    builder.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
    const Scene scene = read(builder);
    ASSERT_EQ(scene.meshes.size(), 3u);  // the last node has the first one's shape
    EXPECT_EQ(scene.objects.at(3).mesh, scene.objects.at(0).mesh);
    const auto second = [&](std::size_t object) {
        return scene.meshes[scene.objects.at(object).mesh].positions[1];
    };
    EXPECT_EQ(second(0), (Float3{1, 1, 8}));
    EXPECT_EQ(second(1), (Float3{1, 1, 0}));
    EXPECT_EQ(second(2), (Float3{3, 1, 0}));
}

// Weights of their own make nodes read a mesh again: what they read is bounded, drawn or not.
TEST(GltfMorph, PrimitivesReadAgainAreCounted)
{
    Builder builder = with_targets();
    builder.json["meshes"][0]["primitives"].push_back({{"attributes", Json::object()}});
    builder.json["nodes"] = parse_json(
        R"([{"mesh": 0}, {"mesh": 0}, {"mesh": 0, "weights": [0, 1]},
            {"mesh": 0, "weights": [1, 0]}])");
    builder.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
    const std::string text = builder.text();
    const Bytes content(text.begin(), text.end());
    EXPECT_EQ(read_gltf("test.gltf", content, {.most_objects = 6}).objects.size(), 4u);
    EXPECT_THROW(read_gltf("test.gltf", content, {.most_objects = 5}), Error);
}

TEST(GltfMorph, NormalsAndTangentsMoveToo)
{
    Builder builder = one_triangle();
    Json& attributes = primitive_of(builder)["attributes"];
    attributes["NORMAL"] = builder.accessor("VEC3", repeated(3, {0, 0, 1}));
    attributes["TANGENT"] = builder.accessor("VEC4", repeated(3, {1, 0, 0, -1}));
    primitive_of(builder)["targets"] = {
        {{"NORMAL", builder.accessor("VEC3", repeated(3, {0, 3, 3}))},
         {"TANGENT", builder.accessor("VEC3", repeated(3, {-1, 2, 0}))}}};
    builder.json["meshes"][0]["weights"] = {1};
    const Mesh mesh = read(builder).meshes.at(0);
    // (0 0 1) + (0 3 3) is (0 3 4); (1 0 0) + (-1 2 0) is (0 2 0).
    EXPECT_EQ(mesh.normals.at(0), (Float3{0, .6f, .8f}));
    EXPECT_EQ(mesh.tangents.at(0), (Float4{0, 1, 0, -1}));
}

TEST(GltfMorph, TargetsMayBeSparseAndQuantized)
{
    Builder builder = with_targets();
    builder.json["meshes"][0]["weights"] = {1, 0};
    builder.json["accessors"].push_back(
        {{"componentType", 5120},
         {"type", "VEC3"},
         {"count", 3},
         {"normalized", true},
         {"sparse",
          {{"count", 1},
           {"indices",
            {{"bufferView", builder.view(std::vector<std::uint8_t>{2})}, {"componentType", 5121}}},
           {"values", {{"bufferView", builder.view(std::vector<std::int8_t>{127, 0, -127})}}}}}});
    primitive_of(builder)["targets"][0]["POSITION"] = builder.json["accessors"].size() - 1;
    EXPECT_EQ(read(builder).meshes.at(0).positions,
              (std::vector<Float3>{{0, 0, 0}, {1, 1, 0}, {3, 4, -1}}));
}

TEST(GltfMorph, NotesWhatDoesNotMove)
{
    Builder builder = with_targets();
    builder.json["meshes"][0]["weights"] = {1, 0};
    primitive_of(builder)["targets"][0]["COLOR_0"] = 0;
    EXPECT_TRUE(notes(read(builder),
                      "morph targets of colors or texture coordinates: 1, these are not moved"));
}

TEST(GltfMorph, Faults)
{
    Builder builder = with_targets();
    builder.json["meshes"][0]["weights"] = {1, 0, 0};
    EXPECT_EQ(fault_of(builder),
              "test.gltf: meshes[0].primitives[0]: has 2 morph targets, but there are 3 weights");
    builder.json["meshes"][0]["weights"] = {1e300, 0};
    EXPECT_EQ(
        fault_of(builder),
        "test.gltf: meshes[0].primitives[0].targets: POSITION of vertex 1 becomes infinite or "
        "not a number");
    builder.json["meshes"][0]["weights"] = {1, 0};
    primitive_of(builder)["targets"][0]["POSITION"] =
        builder.accessor("VEC3", std::vector<float>{1, 2, 3});
    EXPECT_EQ(
        fault_of(builder),
        "test.gltf: meshes[0].primitives[0].targets[0].POSITION: has 1 elements, POSITION has "
        "3");
}

// The triangle on two joints: node 1 at (10 0 0), node 2 turned by a quarter about z. Vertex 0
// hangs on the first, vertex 1 on the second, vertex 2 on both alike.
Builder with_skin()
{
    Builder builder = one_triangle();
    Json& attributes = primitive_of(builder)["attributes"];
    attributes["JOINTS_0"] =
        builder.accessor("VEC4", std::vector<std::uint8_t>{0, 9, 9, 9, 1, 9, 9, 9, 0, 1, 9, 9});
    attributes["WEIGHTS_0"] =
        builder.accessor("VEC4", std::vector<float>{1, 0, 0, 0, 0.5f, 0, 0, 0, 3, 3, 0, 0});
    builder.json["nodes"][0]["skin"] = 0;
    builder.json["nodes"][0]["name"] = "skinned";
    builder.json["nodes"][0]["translation"] = {100, 100, 100};  // has no effect
    const double half = std::sqrt(0.5);
    builder.json["nodes"].push_back({{"translation", {10, 0, 0}}});
    builder.json["nodes"].push_back({{"rotation", {0, 0, half, half}}});
    builder.json["scenes"][0]["nodes"] = {0, 1, 2};
    builder.json["skins"] = {{{"joints", {1, 2}}}};
    return builder;
}

void expect_near(const Float3& a, const Float3& b)
{
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-5) << k;
}

TEST(GltfSkin, JointsCarryVerticesIntoTheWorld)
{
    const Scene scene = read(with_skin());
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].name, "skinned");
    EXPECT_EQ(scene.objects[0].transform, kIdentity);
    const Mesh& mesh = scene.meshes.at(0);
    expect_near(mesh.positions[0], {10, 0, 0});
    expect_near(mesh.positions[1], {-1, 1, 0});  // (1 1 0), turned
    expect_near(mesh.positions[2], {4, 3, 0});   // half of (12 4 0) and half of (-4 2 0)
    EXPECT_TRUE(scene.ignored.empty());
}

TEST(GltfSkin, InverseBindMatricesComeFirst)
{
    Builder builder = with_skin();
    std::vector<float> matrices = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -10, 0, 0, 1};
    const std::vector<float> identity(kIdentity.begin(), kIdentity.end());
    matrices.insert(matrices.end(), identity.begin(), identity.end());
    builder.json["accessors"].push_back({{"bufferView", builder.view(matrices)},
                                         {"componentType", 5126},
                                         {"type", "MAT4"},
                                         {"count", 2}});
    builder.json["skins"][0]["inverseBindMatrices"] = builder.json["accessors"].size() - 1;
    const Mesh mesh = read(builder).meshes.at(0);
    expect_near(mesh.positions[0], {0, 0, 0});  // moved there and back
    expect_near(mesh.positions[1], {-1, 1, 0});
}

TEST(GltfSkin, TurnsNormalsAndTangents)
{
    Builder builder = with_skin();
    Json& attributes = primitive_of(builder)["attributes"];
    attributes["NORMAL"] = builder.accessor("VEC3", repeated(3, {1, 1, 0}));
    attributes["TANGENT"] = builder.accessor("VEC4", repeated(3, {1, -1, 0, 1}));
    builder.json["nodes"][1]["scale"] = {2, 1, 1};
    builder.json["nodes"][2]["scale"] = {-1, 1, 1};
    const Mesh mesh = read(builder).meshes.at(0);
    const auto third = static_cast<float>(1 / std::sqrt(5.0)), half = std::sqrt(0.5f);
    // The plane x + y = 0, twice as wide, is x / 2 + y = 0.
    expect_near(mesh.normals[0], {third, 2 * third, 0});
    expect_near({mesh.tangents[0][0], mesh.tangents[0][1], 0}, {2 * third, -third, 0});
    EXPECT_EQ(mesh.tangents[0][3], 1.0f);
    // Mirrored to (-1 1), then turned to (-1 -1); the tangent by way of (-1 -1) to (1 -1).
    expect_near(mesh.normals[1], {-half, -half, 0});
    expect_near({mesh.tangents[1][0], mesh.tangents[1][1], 0}, {half, -half, 0});
    EXPECT_EQ(mesh.tangents[1][3], -1.0f);
}

TEST(GltfSkin, AMirroredNodeTurnsTriangles)
{
    Builder builder = with_skin();
    EXPECT_EQ(read(builder).meshes.at(0).indices, (std::vector<std::uint32_t>{0, 1, 2}));
    builder.json["nodes"][0]["scale"] = {1, 1, -1};
    EXPECT_EQ(read(builder).meshes.at(0).indices, (std::vector<std::uint32_t>{0, 2, 1}));
}

TEST(GltfSkin, EachSkinnedNodeHasAMeshOfItsOwn)
{
    Builder builder = with_skin();
    builder.json["nodes"].push_back(builder.json["nodes"][0]);
    builder.json["nodes"].push_back({{"mesh", 0}});
    builder.json["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
    const Scene scene = read(builder);
    EXPECT_EQ(scene.meshes.size(), 3u);
    expect_near(scene.meshes.at(1).positions[0], {10, 0, 0});
    expect_near(scene.meshes.at(2).positions[0], {0, 0, 0});  // without skin: as it was made
}

TEST(GltfSkin, MorphsBefore)
{
    Builder builder = with_skin();
    primitive_of(builder)["targets"] = {
        {{"POSITION", builder.accessor("VEC3", repeated(3, {5, 0, 0}))}}};
    builder.json["meshes"][0]["weights"] = {1};
    expect_near(read(builder).meshes.at(0).positions[1], {-1, 6, 0});
}

TEST(GltfSkin, VerticesWithoutWeightsHangOnTheirFirstJoint)
{
    Builder builder = with_skin();
    primitive_of(builder)["attributes"]["WEIGHTS_0"] =
        builder.accessor("VEC4", std::vector<float>(12, 0));
    expect_near(read(builder).meshes.at(0).positions[2], {12, 4, 0});
}

TEST(GltfSkin, ReadsSeveralSetsAndIntegers)
{
    Builder builder = with_skin();
    Json& attributes = primitive_of(builder)["attributes"];
    attributes["JOINTS_1"] = builder.accessor("VEC4", std::vector<std::uint16_t>(12, 0));
    attributes["WEIGHTS_1"] =
        builder.accessor("VEC4", std::vector<std::uint8_t>{0, 0, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0});
    attributes["WEIGHTS_0"] = builder.accessor(
        "VEC4", std::vector<std::uint16_t>{65535, 0, 0, 0, 65535, 0, 0, 0, 1, 0, 0, 0});
    for (const char* name : {"WEIGHTS_0", "WEIGHTS_1"}) {
        builder.json["accessors"][attributes[name].get<std::size_t>()]["normalized"] = true;
    }
    const Mesh mesh = read(builder).meshes.at(0);
    expect_near(mesh.positions[1], {5, 1, 0});  // half of (-1 1 0) and half of (11 1 0)
    expect_near(mesh.positions[2], {12, 4, 0});
}

TEST(GltfSkin, JointsOutsideOfTheSceneCarryNothing)
{
    Builder builder = with_skin();
    builder.json["scenes"][0]["nodes"] = {0, 1};
    const Scene scene = read(builder);
    EXPECT_EQ(scene.objects.at(0).transform[12], 100.0f);
    EXPECT_TRUE(notes(scene, "skins with joints outside of the scene: 1, drawn without them"));
}

TEST(GltfSkin, Faults)
{
    const auto after = [](auto change) {
        Builder builder = with_skin();
        change(builder, primitive_of(builder)["attributes"]);
        return fault_of(builder);
    };
    const std::string attributes = "test.gltf: meshes[0].primitives[0].attributes";
    EXPECT_EQ(after([](Builder& b, Json&) { b.json["skins"][0]["joints"] = {1}; }),
              attributes + ": vertex 1 hangs on joint 1 of 1");
    EXPECT_EQ(after([](Builder& b, Json&) { b.json["nodes"][0]["skin"] = 3; }),
              "test.gltf: nodes[0].skin: there is no skins[3], the file has 1");
    EXPECT_EQ(after([](Builder&, Json& a) { a.erase("WEIGHTS_0"); }),
              attributes + ": JOINTS_0 and WEIGHTS_0 need one another");
    EXPECT_EQ(
        after([](Builder& b, Json& a) {
            a["WEIGHTS_0"] = b.accessor("VEC4", repeated(3, {1, -1, 0, 0}));
        }),
        "test.gltf: accessors[3]: a weight of vertex 0 is negative, infinite or not a number");
    EXPECT_EQ(after([](Builder& b, Json& a) {
                  a["JOINTS_0"] = b.accessor("VEC4", repeated(3, {1, 0, 0, 0}));
              }),
              "test.gltf: accessors[3]: joints must be VEC4 of 8 or 16 bit unsigned integers");
    EXPECT_EQ(
        after([](Builder& b, Json&) { b.json["skins"][0]["inverseBindMatrices"] = 0; }),
        "test.gltf: skins[0].inverseBindMatrices: must be MAT4, one for each of the 2 joints");
    EXPECT_EQ(after([](Builder& b, Json&) {
                  b.json["accessors"].push_back(
                      {{"componentType", 5126}, {"type", "MAT4"}, {"count", 2}});
                  b.json["skins"][0]["inverseBindMatrices"] = 3;  // all zero
              }),
              "test.gltf: skins[0].inverseBindMatrices: matrix 0 is not finite, or its last row is "
              "not 0 0 0 1");
    EXPECT_EQ(after([](Builder& b, Json&) {
                  b.json["nodes"][1]["scale"] = {1e300, 1, 1};
              }),
              "test.gltf: meshes[0].primitives[0]: its skin moves a vertex beyond what a float "
              "holds");
}

}  // namespace
}  // namespace sheer::test
