// glTF lights: KHR_lights_punctual.

#include "gltf_fixture.h"

#include <cmath>

namespace sheer::test {
namespace {

Builder with_light(const char* light)
{
    Builder builder = one_triangle();
    builder.json["extensionsRequired"] = {"KHR_lights_punctual"};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({parse_json(light)});
    builder.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    return builder;
}

std::string fault_of_light(const char* light)
{
    const std::string fault = fault_of(with_light(light));
    const std::string place = "test.gltf: extensions.KHR_lights_punctual.lights[0]";
    EXPECT_EQ(fault.rfind(place, 0), 0u) << fault;
    return fault.substr(std::min(fault.size(), place.size()));
}

TEST(GltfLights, DefaultsAreTheExtensions)
{
    const Scene scene = read(with_light(R"({"type": "point"})"));
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].kind, LightKind::point);
    EXPECT_EQ(scene.lights[0].intensity, (Float3{1, 1, 1}));
    EXPECT_EQ(scene.lights[0].range, 0.0f);
    EXPECT_TRUE(scene.ignored.empty());
    const Light spot = read(with_light(R"({"type": "spot", "spot": {}})")).lights.at(0);
    EXPECT_EQ(spot.inner_cone, 0.0f);
    EXPECT_FLOAT_EQ(spot.outer_cone, 0.78539816f);  // pi / 4
}

TEST(GltfLights, TakeThePlaceOfTheSun)
{
    EXPECT_NE(read(one_triangle()).sun.color, (Float3{0, 0, 0}));
    const Scene scene = read(with_light(R"({"type": "point"})"));
    EXPECT_EQ(scene.sun.color, (Float3{0, 0, 0}));
    EXPECT_EQ(scene.sky.up, Sky().up);
    Builder unused = with_light(R"({"type": "point"})");
    unused.json["nodes"][0].erase("extensions");
    EXPECT_TRUE(read(unused).lights.empty());
    EXPECT_EQ(read(unused).sun.color, Sun().color);
}

TEST(GltfLights, ReadsStrengthRangeAndCones)
{
    const Light light = read(with_light(R"({"type": "spot", "name": "lamp",
        "color": [1, 0.5, 0.25], "intensity": 8, "range": 12,
        "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.5}})"))
                            .lights.at(0);
    EXPECT_EQ(light.kind, LightKind::spot);
    EXPECT_EQ(light.intensity, (Float3{8, 4, 2}));
    EXPECT_EQ(light.range, 12.0f);
    EXPECT_EQ(light.inner_cone, 0.25f);
    EXPECT_EQ(light.outer_cone, 0.5f);
}

TEST(GltfLights, StandWhereTheirNodesAre)
{
    Builder builder = with_light(R"({"type": "directional", "intensity": 3})");
    // A quarter turn about x takes -z to y; the scale does not show.
    const double half = std::sqrt(0.5);
    builder.json["nodes"][0]["rotation"] = {half, 0, 0, half};
    builder.json["nodes"][0]["scale"] = {5, 5, 5};
    builder.json["nodes"][0]["translation"] = {1, 2, 3};
    builder.json["nodes"].push_back({{"translation", {10, 0, 0}}, {"children", {0}}});
    builder.json["scenes"][0]["nodes"] = {1};
    const Light light = read(builder).lights.at(0);
    EXPECT_EQ(light.kind, LightKind::directional);
    EXPECT_EQ(light.position, (Float3{11, 2, 3}));
    EXPECT_NEAR(light.direction[0], 0, 1e-7);
    EXPECT_NEAR(light.direction[1], 1, 1e-7);
    EXPECT_NEAR(light.direction[2], 0, 1e-7);
    EXPECT_EQ(light.intensity, (Float3{3, 3, 3}));
}

TEST(GltfLights, NodesShareALight)
{
    Builder builder = with_light(R"({"type": "point"})");
    builder.json["nodes"].push_back(builder.json["nodes"][0]);
    builder.json["scenes"][0]["nodes"].push_back(1);
    EXPECT_EQ(read(builder).lights.size(), 2u);
}

TEST(GltfLights, NeedADirection)
{
    for (const char* kind : {"directional", "spot"}) {
        Builder builder = with_light((R"({"type": ")" + std::string(kind) + "\"}").c_str());
        builder.json["nodes"][0]["scale"] = {1, 1, 0};
        EXPECT_TRUE(read(builder).lights.empty());
        EXPECT_TRUE(notes(read(builder), "lights that shine in no direction: 1, left out"));
    }
    Builder builder = with_light(R"({"type": "point"})");
    builder.json["nodes"][0]["scale"] = {1, 1, 0};
    EXPECT_EQ(read(builder).lights.size(), 1u);
}

TEST(GltfLights, AreBounded)
{
    const Scene scene = read(with_light(R"({"type": "point", "intensity": 1e30, "range": 1e60})"));
    EXPECT_EQ(scene.lights.at(0).intensity, (Float3{1e6f, 1e6f, 1e6f}));
    EXPECT_TRUE(std::isfinite(scene.lights[0].range));
    EXPECT_TRUE(notes(scene, "lights brighter than 1,000,000: 1, dimmed to that"));
}

TEST(GltfLights, Faults)
{
    EXPECT_EQ(fault_of_light("{}"), ": \"type\" is missing");
    EXPECT_EQ(fault_of_light(R"({"type": "area"})"), ".type: must be directional, point or spot");
    EXPECT_EQ(fault_of_light(R"({"type": "point", "intensity": -1})"),
              ".intensity: must not be negative");
    EXPECT_EQ(fault_of_light(R"({"type": "point", "color": [0, -1, 0]})"),
              ".color: must not be negative");
    EXPECT_EQ(fault_of_light(R"({"type": "point", "range": 0})"), ".range: must be greater than 0");
    EXPECT_EQ(fault_of_light(R"({"type": "spot", "spot": {"innerConeAngle": -0.1}})"),
              ".spot.innerConeAngle: must not be negative");
    EXPECT_EQ(fault_of_light(R"({"type": "spot", "spot": {"outerConeAngle": 1.6}})"),
              ".spot.outerConeAngle: must be greater than 0 and at most pi / 2");
    EXPECT_EQ(fault_of_light(R"({"type": "spot", "spot": {"innerConeAngle": 0.8}})"),
              ".spot: innerConeAngle must be less than outerConeAngle");
    Builder builder = with_light(R"({"type": "point"})");
    builder.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 1;
    EXPECT_EQ(fault_of(builder),
              "test.gltf: nodes[0].extensions.KHR_lights_punctual.light: there is no light 1, the "
              "file has 1");
    builder.json.erase("extensions");
    EXPECT_EQ(fault_of(builder),
              "test.gltf: nodes[0].extensions.KHR_lights_punctual: the file has no lights");
}

}  // namespace
}  // namespace sheer::test
