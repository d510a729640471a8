// Copies of a mesh: EXT_mesh_gpu_instancing, and what may be asked for.
#include <cmath>

#include "gltf_fixture.h"

namespace sheer::test {
namespace {

Builder with_instances()
{
    Builder builder = one_triangle();
    builder.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    Json& attributes =
        builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    attributes["TRANSLATION"] = builder.accessor("VEC3", std::vector<float>{1, 0, 0, 0, 2, 0});
    attributes["SCALE"] = builder.accessor("VEC3", std::vector<float>{1, 1, 1, 1, 1, 3});
    attributes["ROTATION"] =
        builder.accessor("VEC4", std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 32767, 0});
    builder.json["accessors"][attributes["ROTATION"].get<std::size_t>()]["normalized"] = true;
    return builder;
}

TEST(GltfInstances, EachIsAnObject)
{
    Builder builder = with_instances();
    builder.json["nodes"][0]["scale"] = {2, 2, 2};
    builder.json["nodes"][0]["name"] = "leaf";
    const Scene scene = read(builder);
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    for (std::uint32_t i = 0; i < 2; ++i) {
        EXPECT_EQ(scene.objects[i].mesh, 0u);
        EXPECT_EQ(scene.objects[i].id, i);
        EXPECT_EQ(scene.objects[i].name, "leaf");
    }
    EXPECT_EQ(scene.objects[0].transform, (Mat4{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 2, 0, 0, 1}));
    // A half turn about z, three times as deep, all of it twice as large.
    EXPECT_EQ(scene.objects[1].transform, (Mat4{-2, 0, 0, 0, 0, -2, 0, 0, 0, 0, 6, 0, 0, 4, 0, 1}));
    EXPECT_TRUE(scene.ignored.empty());
}

// Those of other attributes, which are for the file's author, stand where the node does.
TEST(GltfInstances, AnyAttributeSaysHowMany)
{
    Builder builder = with_instances();
    Json& attributes =
        builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    attributes = {{"_ID", builder.accessor("SCALAR", std::vector<float>{5, 6, 7})}};
    const Scene scene = read(builder);
    ASSERT_EQ(scene.objects.size(), 3u);
    EXPECT_EQ(scene.objects[0].transform, scene.objects[2].transform);
}

// Primitives that differ in their material alone: their vertices are kept once, and each object has
// its material and the name of its own glTF mesh.
TEST(GltfInstances, OfOtherMaterialsShareTheirVertices)
{
    Builder builder = one_triangle();
    builder.json["materials"] = {{{"name", "red"}},
                                 {{"name", "blue"}, {"alphaMode", "BLEND"}, {"doubleSided", true}}};
    builder.json["meshes"][0]["name"] = "first";
    const Json same = builder.json["meshes"][0]["primitives"][0]["attributes"];
    builder.primitive(same)["material"] = 1;
    builder.primitive(same)["material"] = 0;
    builder.json["meshes"][1]["name"] = "second";
    builder.primitive(same)["mode"] = 0;  // points: another shape
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    Scene scene = read(builder);
    ASSERT_EQ(scene.objects.size(), 4u);
    ASSERT_EQ(scene.meshes.size(), 2u);
    const std::uint32_t mesh[4] = {0, 0, 0, 1};
    const char* material[3] = {"red", "blue", "red"};
    const char* name[4] = {"first", "second", "", ""};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(scene.objects[i].mesh, mesh[i]) << i;
        EXPECT_EQ(mesh_name(scene, scene.objects[i]), name[i]) << i;
        if (i == 3) continue;
        EXPECT_EQ(material_of(scene, scene.objects[i]).name, material[i]) << i;
    }
    EXPECT_EQ(set_opacity(scene, "first", 0.5f), 1u);
    EXPECT_EQ(scene.objects[0].opacity, 0.5f);
    EXPECT_EQ(set_opacity(scene, "second", 0.25f), 1u);
    EXPECT_EQ(scene.objects[1].opacity, 0.25f);
    EXPECT_EQ(set_opacity(scene, "red", 0.75f), 2u);
    EXPECT_EQ(scene.objects[1].opacity, 0.25f);
}

TEST(GltfInstances, LimitsAreTheCallers)
{
    const std::string text = with_instances().text();
    const auto fault = [&](auto set) -> std::string {
        LoadOptions options;
        set(options);
        try {
            read_gltf("test.gltf", Bytes(text.begin(), text.end()), options);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    // Two instances of one triangle.
    EXPECT_EQ(fault([](LoadOptions& o) { o.most_objects = o.most_triangles = 2; }), "");
    EXPECT_EQ(fault([](LoadOptions& o) { o.most_objects = 1; }),
              "test.gltf: nodes[0].extensions.EXT_mesh_gpu_instancing.attributes: more instances "
              "than --most-objects allows (1)");
    EXPECT_EQ(fault([](LoadOptions& o) { o.most_triangles = 1; }),
              "test.gltf: nodes[0]: more triangles, each node's counted, than --most-triangles "
              "allows (1)");
    EXPECT_EQ(fault([](LoadOptions& o) { o.most_elements = 2; }),
              "test.gltf: accessors[3]: more elements than --most-elements allows (2)");
}

TEST(GltfInstances, Faults)
{
    const auto after = [](auto change) {
        Builder builder = with_instances();
        change(builder,
               builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]);
        return fault_of(builder);
    };
    const std::string place = "test.gltf: nodes[0].extensions.EXT_mesh_gpu_instancing.attributes";
    EXPECT_EQ(after([](Builder&, Json& a) { a = Json::object(); }), place + ": names no attribute");
    EXPECT_EQ(after([](Builder& b, Json& a) {
                  a["SCALE"] = b.accessor("VEC3", std::vector<float>{1, 1, 1});
              }),
              place + ".SCALE: has 1 elements, others have 2");
    EXPECT_EQ(after([](Builder& b, Json& a) {
                  a["SCALE"] = b.accessor("SCALAR", std::vector<float>{1, 1});
              }),
              place + ".SCALE: must be VEC3");
    EXPECT_EQ(after([](Builder& b, Json& a) {
                  a["ROTATION"] = b.accessor("VEC4", std::vector<float>(8, 0));
              }),
              place + ".ROTATION: element 0 must be a unit quaternion");
    EXPECT_EQ(
        after([](Builder& b, Json& a) {
            a = {{"TRANSLATION", b.accessor("VEC3", std::vector<float>{std::nanf(""), 0, 0})}};
        }),
        "test.gltf: nodes[0]: its place in the world is infinite or not a number");
}

}  // namespace
}  // namespace sheer::test
