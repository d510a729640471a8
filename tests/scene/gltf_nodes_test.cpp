// glTF scenes: which nodes are drawn, where they stand, and what they look through.

#include "gltf_fixture.h"

#include <cmath>

namespace sheer::test {
namespace {

// `count` nodes without children that share the one mesh; the scene is left to the test.
Builder nodes_with_a_mesh(int count)
{
    Builder builder = one_triangle();
    for (int i = 1; i < count; ++i) builder.json["nodes"].push_back({{"mesh", 0}});
    for (int i = 0; i < count; ++i)
        builder.json["nodes"][static_cast<std::size_t>(i)]["name"] = "n" + std::to_string(i);
    builder.json.erase("scenes");
    return builder;
}

std::string names(const Scene& scene)
{
    std::string names;
    for (const Object& object : scene.objects) names += object.name;
    return names;
}

TEST(GltfNodes, CirclesWithoutAScene)
{
    Builder builder = nodes_with_a_mesh(4);
    builder.json["nodes"][1]["children"] = {2};
    builder.json["nodes"][2]["children"] = {1, 3};
    const Scene scene = read(builder);
    EXPECT_EQ(names(scene), "n0");
    EXPECT_TRUE(notes(scene, "nodes in circles or below them: 3, not drawn"));
}

TEST(GltfNodes, ChoosesTheScene)
{
    Builder builder = nodes_with_a_mesh(3);
    builder.json["nodes"][0]["children"] = {2};
    EXPECT_EQ(names(read(builder)), "n0n2n1");  // no scenes: every root
    const Scene all = read(builder);
    ASSERT_EQ(all.groups.size(), 3u);
    EXPECT_EQ(all.objects[1].group, 0);  // n2's parent
    EXPECT_EQ(all.groups[0].name, "n0");
    EXPECT_EQ(all.objects[0].group, -1);
    EXPECT_EQ(all.objects[2].group, -1);
    builder.json["scenes"] = {{{"nodes", {1}}}, {{"nodes", {0}}}};
    EXPECT_EQ(names(read(builder)), "n1");  // no choice: the first
    builder.json["scene"] = 1;
    EXPECT_EQ(names(read(builder)), "n0n2");
    EXPECT_TRUE(notes(read(builder), "other scenes: 1, not drawn"));
    builder.json["scene"] = 2;
    EXPECT_EQ(fault_of(builder), "test.gltf: scene: there is no scenes[2], the file has 2");
}

TEST(GltfNodes, TheCallerMayChooseTheScene)
{
    Builder builder = nodes_with_a_mesh(3);
    builder.json["scenes"] = parse_json(
        R"([{"nodes": [0]}, {"nodes": [1], "name": "two"}, {"nodes": [2], "name": "0"}])");
    builder.json["scene"] = 1;
    const std::string text = builder.text();
    const auto chosen = [&](const std::string& choice) {
        return names(read_gltf("test.gltf", Bytes(text.begin(), text.end()), {.scene = choice}));
    };
    EXPECT_EQ(names(read(builder)), "n1");
    EXPECT_EQ(chosen("two"), "n1");
    EXPECT_EQ(chosen("1"), "n1");
    EXPECT_EQ(chosen("2"), "n2");
    EXPECT_EQ(chosen("0"), "n2");  // a name goes before a number
    for (const char* wrong : {"3", "three", "", "-1", "1 "}) {
        try {
            chosen(wrong);
            ADD_FAILURE() << wrong;
        } catch (const Error& e) {
            EXPECT_EQ(e.what(), "test.gltf: there is no scene \"" + std::string(wrong) +
                                    "\", the file has 3");
        }
    }
}

TEST(GltfNodes, NumbersObjectsInTheOrderOfTraversal)
{
    Builder builder = nodes_with_a_mesh(5);
    builder.json["nodes"][4]["children"] = {3, 0};
    builder.json["nodes"][3]["children"] = {1};
    builder.json["scenes"] = {{{"nodes", {4, 2}}}};
    const Scene scene = read(builder);
    EXPECT_EQ(names(scene), "n4n3n1n0n2");
    EXPECT_EQ(scene.meshes.size(), 1u);
    for (std::uint32_t i = 0; i < 5; ++i) {
        EXPECT_EQ(scene.objects[i].id, i);
        EXPECT_EQ(scene.objects[i].mesh, 0u);
    }
}

// A tree of nodes of which one is moved by an animation: what hangs below it moves as one.
TEST(GltfNodes, WhatAnAnimationMovesIsAWhole)
{
    Builder builder = nodes_with_a_mesh(5);
    Json& nodes = builder.json["nodes"];
    nodes[0]["children"] = {1};
    nodes[1]["children"] = {2};
    nodes[2]["children"] = {3};
    for (int i = 0; i < 5; ++i) {
        nodes[static_cast<std::size_t>(i)]["translation"] = {1 << i, 0, 0};
    }
    nodes[3]["scale"] = {2, 2, 2};
    EXPECT_FALSE(read(builder).objects[3].to_whole);  // nothing moves
    builder.json["animations"] = parse_json(R"([{"channels": [
        {"target": {"node": 1, "path": "rotation"}}, {"target": {"node": 4, "path": "weights"}},
        {"target": {"path": "scale"}}]}])");
    const Scene scene = read(builder);
    ASSERT_EQ(names(scene), "n0n1n2n3n4");
    EXPECT_FALSE(scene.objects[0].to_whole);
    EXPECT_EQ(scene.objects[1].to_whole, kIdentity);
    Mat4 second = kIdentity, third = kIdentity;
    second[12] = 4;
    EXPECT_EQ(scene.objects[2].to_whole, second);
    third[0] = third[5] = third[10] = 2;
    third[12] = 4 + 8;
    EXPECT_EQ(scene.objects[3].to_whole, third);
    EXPECT_FALSE(scene.objects[4].to_whole);  // weights move no node
    // The nearest that moves.
    builder.json["animations"][0]["channels"][1]["target"] = {{"node", 2}, {"path", "scale"}};
    EXPECT_EQ(read(builder).objects[2].to_whole, kIdentity);
    third[12] = 8;
    EXPECT_EQ(read(builder).objects[3].to_whole, third);
    EXPECT_EQ(read(builder).objects[1].to_whole, kIdentity);
    builder.json["animations"][0]["channels"][1]["target"]["node"] = 9;
    EXPECT_EQ(
        fault_of(builder),
        "test.gltf: animations[0].channels[1].target.node: there is no nodes[9], the file has 5");
}

TEST(GltfNodes, EachPrimitiveOfANodeIsAnObject)
{
    Builder builder = nodes_with_a_mesh(2);
    builder.json["meshes"][0]["name"] = "both";
    builder.json["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", 0}}}, {"mode", 5}});
    const Scene scene = read(builder);
    EXPECT_EQ(names(scene), "n0n0n1n1");
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[1].name, "both");
    EXPECT_EQ(scene.objects[3].mesh, 1u);
}

TEST(GltfNodes, PlacesChildrenInTheirParents)
{
    Builder builder = nodes_with_a_mesh(2);
    builder.json["nodes"][0]["children"] = {1};
    builder.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 10, 20, 30, 1};
    builder.json["nodes"][1]["translation"] = {1, 2, 3};
    builder.json["nodes"][1]["rotation"] = {0, 0, 2, 2};  // a quarter turn about z, not normalised
    builder.json["nodes"][1]["scale"] = {2, 3, 4};
    const Mat4 world = read(builder).objects.at(1).transform;
    const Mat4 expected = {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, -4, 0, 11, 22, 27, 1};
    for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(world[i], expected[i], 1e-6) << i;
}

TEST(GltfNodes, DeepChainsNeedNoStack)
{
    constexpr std::size_t depth = 100000;
    Builder builder = nodes_with_a_mesh(1);
    builder.json["nodes"] = Json::array();
    for (std::size_t i = 0; i < depth; ++i) {
        builder.json["nodes"].push_back({{"translation", {0, 0.5, 0}}, {"children", {i + 1}}});
    }
    builder.json["nodes"].push_back({{"mesh", 0}});
    builder.json["scenes"] = {{{"nodes", {0}}}};
    EXPECT_EQ(read(builder).objects.at(0).transform[13], 0.5f * depth);
}

TEST(GltfNodes, RefusesWhatIsNoTree)
{
    Builder builder = nodes_with_a_mesh(3);
    builder.json["nodes"][0]["children"] = {1};
    builder.json["nodes"][1]["children"] = {0};
    builder.json["scenes"] = {{{"nodes", {0}}}};
    EXPECT_EQ(fault_of(builder), "test.gltf: nodes[0]: is reached twice: nodes must form trees");
    builder.json["nodes"][0]["children"] = {1, 2};
    builder.json["nodes"][1]["children"] = {2};
    EXPECT_EQ(fault_of(builder), "test.gltf: nodes[2]: is reached twice: nodes must form trees");
    builder.json["nodes"][0]["children"] = {7};
    EXPECT_EQ(fault_of(builder),
              "test.gltf: nodes[0].children[0]: there is no nodes[7], the file has 3");
}

TEST(GltfNodes, RefusesBrokenTransforms)
{
    Builder builder = nodes_with_a_mesh(1);
    builder.json["nodes"][0]["scale"] = {1, 2};
    EXPECT_EQ(fault_of(builder), "test.gltf: nodes[0].scale: must be an array of 3 numbers");
    builder.json["nodes"][0]["scale"] = {1, 2, 1e39};
    EXPECT_EQ(fault_of(builder),
              "test.gltf: nodes[0]: its place in the world is infinite or not a number");
    builder.json["nodes"][0].erase("scale");
    builder.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
    EXPECT_EQ(fault_of(builder), "test.gltf: nodes[0].rotation: must be a unit quaternion");
    builder.json["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1};
    EXPECT_EQ(fault_of(builder), "test.gltf: nodes[0].matrix: the last row must be 0 0 0 1");
}

Builder with_camera(const Json& camera)
{
    Builder builder = nodes_with_a_mesh(1);
    builder.json["cameras"] = Json::array({camera});
    builder.json["nodes"][0]["camera"] = 0;
    return builder;
}

TEST(GltfCameras, ReadsPerspective)
{
    Builder builder = with_camera(parse_json(
        R"({"type": "perspective", "name": "eye",
            "perspective": {"yfov": 0.5, "aspectRatio": 1.5, "znear": 0.25}})"));
    const Camera camera = read(builder).cameras.at(0);
    EXPECT_EQ(camera.name, "eye");
    EXPECT_FALSE(camera.orthographic);
    EXPECT_EQ(camera.yfov, 0.5f);
    EXPECT_EQ(camera.aspect, 1.5f);
    EXPECT_EQ(camera.znear, 0.25f);
    EXPECT_EQ(camera.zfar, 0.0f);
    builder.json["cameras"][0]["perspective"]["yfov"] = 3.2;
    EXPECT_EQ(fault_of(builder), "test.gltf: cameras[0].perspective.yfov: must be less than pi");
    builder.json["cameras"][0]["perspective"]["yfov"] = 0;
    EXPECT_NE(fault_of(builder).find("cameras[0].perspective.yfov: must be greater than 0"),
              std::string::npos);
}

TEST(GltfCameras, ReadsOrthographic)
{
    Builder builder = with_camera(parse_json(
        R"({"type": "orthographic",
            "orthographic": {"xmag": 2, "ymag": 3, "znear": 0, "zfar": 10}})"));
    const Camera camera = read(builder).cameras.at(0);
    EXPECT_EQ(camera.name, "n0");
    EXPECT_TRUE(camera.orthographic);
    EXPECT_EQ(camera.xmag, 2.0f);
    EXPECT_EQ(camera.ymag, 3.0f);
    EXPECT_EQ(camera.znear, 0.0f);
    EXPECT_EQ(camera.zfar, 10.0f);
    builder.json["cameras"][0]["orthographic"]["znear"] = 10;
    EXPECT_EQ(fault_of(builder), "test.gltf: cameras[0].orthographic: zfar must be beyond znear");
}

TEST(GltfCameras, ScaleAndMirroringDoNotReachTheView)
{
    Builder builder = with_camera(
        parse_json(R"({"type": "perspective", "perspective": {"yfov": 0.5, "znear": 1}})"));
    builder.json["nodes"][0]["matrix"] = {-5, 0, 0, 0, 0, 0, -2, 0, 0, 3, 1, 0, 7, 8, 9, 1};
    const Scene scene = read(builder);
    const Mat4 camera = scene.cameras.at(0).transform;
    const double r = std::sqrt(10.0);
    const std::array<double, 16> expected = {1, 0,     0,     0, 0, 1 / r, -3 / r, 0,
                                             0, 3 / r, 1 / r, 0, 7, 8,     9,      1};
    for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(camera[i], expected[i], 1e-6) << i;
    EXPECT_EQ(scene.objects.at(0).transform[0], -5.0f);  // objects keep both
    builder.json["nodes"][0].erase("matrix");
    builder.json["nodes"][0]["scale"] = {1, 0, 1};
    EXPECT_TRUE(notes(read(builder), "cameras that look in no direction: 1, left out"));
}

}  // namespace
}  // namespace sheer::test
