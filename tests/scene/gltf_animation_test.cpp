// glTF animations at a time: nodes, weights, joints.
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scene/gltf_fixture.h"

namespace sheer::test {
namespace {

Scene read_at(const Builder& builder, double time, const std::optional<std::string>& which = {})
{
    LoadOptions options;
    options.time = time;
    options.animation = which;
    const std::string text = builder.text();
    return read_gltf("test.gltf", Bytes(text.begin(), text.end()), options);
}

// Node 0 of one triangle, `path` of which has these values at these times.
Builder animated(const std::string& path, const std::string& type, const std::vector<float>& times,
                 const std::vector<float>& values, const char* interpolation = "LINEAR")
{
    Builder builder = one_triangle();
    const std::size_t input = builder.accessor("SCALAR", times);
    const std::size_t output = builder.accessor(type, values);
    builder.json["animations"] = {
        {{"name", "own"},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
         {"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}}}};
    return builder;
}

Float3 place_of(const Scene& scene)
{
    const Mat4& m = scene.objects.at(0).transform;
    return {m[12], m[13], m[14]};
}

TEST(GltfAnimation, MovesNodesBetweenKeysAndRestsOutside)
{
    const Builder builder = animated("translation", "VEC3", {1, 2, 4}, {0, 0, 0, 4, 0, 8, 0, 2, 0});
    const std::pair<double, Float3> expected[] = {
        {0, {0, 0, 0}},      {1, {0, 0, 0}}, {1.25, {1, 0, 2}}, {2, {4, 0, 8}}, {3, {2, 1, 4}},
        {3.5, {1, 1.5f, 2}}, {4, {0, 2, 0}}, {99, {0, 2, 0}},   {-5, {0, 0, 0}}};
    for (const auto& [time, place] : expected) {
        EXPECT_EQ(place_of(read_at(builder, time)), place) << time;
    }
    EXPECT_EQ(place_of(read(builder)), (Float3{0, 0, 0})) << "without a time";
    EXPECT_TRUE(notes(read(builder), "animations: 1, not played"));
    EXPECT_TRUE(read_at(builder, 1).ignored.empty());
}

TEST(GltfAnimation, StepsHoldTheirValue)
{
    const Builder builder = animated("scale", "VEC3", {0, 1}, {1, 2, 3, 4, 5, 6}, "STEP");
    EXPECT_EQ(read_at(builder, 0.99).objects.at(0).transform[5], 2);
    EXPECT_EQ(read_at(builder, 1).objects.at(0).transform[5], 5);
}

// The tangents of t^2 at 0 and 2 are 0 and 4, those of t^3 - t -1 and 11: one cubic has them.
TEST(GltfAnimation, CubicSplinesAreTheCubicOfTheirTangents)
{
    const Builder builder =
        animated("translation", "VEC3", {0, 2},
                 {7, 7, 7, 0, 0, 0, 0, -1, 0, 4, 11, 0, 4, 6, 0, 7, 7, 7}, "CUBICSPLINE");
    for (const double t : {0.0, 0.5, 1.0, 1.5, 1.75}) {
        const Float3 place = place_of(read_at(builder, t));
        EXPECT_NEAR(place[0], t * t, 1e-6) << t;
        EXPECT_NEAR(place[1], t * t * t - t, 1e-6) << t;
    }
}

TEST(GltfAnimation, TurnsAtAnEvenPaceTheShortWay)
{
    const double pi = std::acos(-1.0);
    const auto half = static_cast<float>(std::sqrt(0.5));
    // A quarter of a turn about y; then the same, with the other of the two quaternions for it.
    for (const float sign : {1.0f, -1.0f}) {
        const Builder builder =
            animated("rotation", "VEC4", {0, 1}, {0, 0, 0, 1, 0, sign * half, 0, sign * half});
        for (int i = 0; i <= 4; ++i) {
            const Mat4 m = read_at(builder, i / 4.0).objects.at(0).transform;
            EXPECT_NEAR(std::atan2(m[8], m[0]), i / 4.0 * pi / 2, 1e-6) << i;
        }
    }
    // Between nearly equal ones it is straight, and no worse.
    const Builder small = animated("rotation", "VEC4", {0, 1}, {0, 0, 0, 1, 0, 0.01f, 0, 1});
    const Mat4 m = read_at(small, 0.5).objects.at(0).transform;
    EXPECT_NEAR(std::atan2(m[8], m[0]), std::atan(0.01), 1e-6);
}

TEST(GltfAnimation, MovesMorphTargets)
{
    Builder builder = animated("weights", "SCALAR", {0, 1}, {0, 0, 1, 3});
    for (const float x : {1.0f, 100.0f}) {
        builder.json["meshes"][0]["primitives"][0]["targets"].push_back(
            {{"POSITION",
              builder.accessor("VEC3", std::vector<float>{x, 0, 0, 0, 0, 0, 0, 0, 0})}});
    }
    EXPECT_EQ(read_at(builder, 0).meshes.at(0).positions.at(0), (Float3{0, 0, 0}));
    EXPECT_EQ(read_at(builder, 0.5).meshes.at(0).positions.at(0), (Float3{150.5f, 0, 0}));
    EXPECT_EQ(read_at(builder, 2).meshes.at(0).positions.at(0), (Float3{301, 0, 0}));
}

TEST(GltfAnimation, MovesWhatHangsOnJoints)
{
    Builder builder = animated("translation", "VEC3", {0, 1}, {0, 0, 0, 0, 0, 2});
    Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = builder.accessor("VEC4", std::vector<std::uint8_t>(12, 0));
    std::vector<float> weights;
    for (int i = 0; i < 3; ++i) weights.insert(weights.end(), {1, 0, 0, 0});
    attributes["WEIGHTS_0"] = builder.accessor("VEC4", weights);
    builder.json["nodes"][0]["skin"] = 0;
    builder.json["nodes"].push_back(Json::object());
    builder.json["scenes"][0]["nodes"].push_back(1);
    builder.json["skins"] = {{{"joints", {1}}}};
    builder.json["animations"][0]["channels"][0]["target"]["node"] = 1;
    EXPECT_EQ(read_at(builder, 0.5).meshes.at(0).positions.at(1), (Float3{1, 1, 1}));
}

TEST(GltfAnimation, IsTheFirstOrTheOneThatIsNamed)
{
    Builder builder = animated("translation", "VEC3", {0, 1}, {0, 0, 0, 1, 0, 0});
    Json other = builder.json["animations"][0];
    other["name"] = "other";
    other["samplers"][0]["interpolation"] = "STEP";
    builder.json["animations"].push_back(other);
    EXPECT_EQ(place_of(read_at(builder, 0.5))[0], 0.5f);
    EXPECT_EQ(place_of(read_at(builder, 0.5, "own"))[0], 0.5f);
    EXPECT_EQ(place_of(read_at(builder, 0.5, "other"))[0], 0);
    EXPECT_EQ(place_of(read_at(builder, 0.5, "1"))[0], 0);
    EXPECT_TRUE(notes(read_at(builder, 0.5), "other animations: 1, not played"));
    EXPECT_THROW(read_at(builder, 0.5, "2"), Error);
    EXPECT_NO_THROW(read_at(one_triangle(), 1)) << "no animation at all";
}

TEST(GltfAnimation, ReplacesAMatrix)
{
    Builder builder = animated("translation", "VEC3", {0}, {1, 2, 3});
    builder.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 9, 9, 9, 1};
    EXPECT_EQ(place_of(read_at(builder, 0)), (Float3{1, 2, 3}));
}

std::string fault_at(const Builder& builder)
{
    try {
        read_at(builder, 0.5);
    } catch (const Error& e) {
        EXPECT_EQ(e.fault(), Fault::input);
        EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
        return e.what();
    }
    return "none";
}

TEST(GltfAnimation, SaysWhatIsWrong)
{
    const float infinite = std::numeric_limits<float>::infinity();
    const auto moved = [](const std::vector<float>& times, const std::vector<float>& values) {
        return animated("translation", "VEC3", times, values);
    };
    const std::string sampler = "test.gltf: animations[0].samplers[0].";
    const std::pair<Builder, std::string> faults[] = {
        {moved({}, {}), sampler + "input: must be SCALAR, of floats, one at least"},
        {moved({0, 0}, {0, 0, 0, 1, 1, 1}), sampler + "input: time 1 is not after"},
        {moved({0, infinite}, {0, 0, 0, 1, 1, 1}), "holds what is infinite"},
        {moved({0, 1}, {0, 0, 0, 1, infinite, 1}), "holds what is infinite"},
        {moved({0, 1}, {0, 0, 0}), sampler + "output: has 1 elements for 2 times"},
        {moved({0}, {0, 0, 0, 1, 1, 1}), sampler + "output: has 2 elements for 1 times"},
        {animated("scale", "SCALAR", {0}, {1}), sampler + "output: must have 3 floats"},
        {animated("rotation", "VEC4", {0}, {0, 0, 0, 0}), sampler + "output: must hold unit"},
        {animated("translation", "VEC3", {0}, {1, 1, 1}, "CUBICSPLINE"), sampler + "output: has 1"},
        {animated("translation", "VEC3", {0}, {1, 1, 1}, "odd"),
         sampler + "interpolation: must be"}};
    for (const auto& [builder, text] : faults) {
        EXPECT_NE(fault_at(builder).find(text), std::string::npos) << text << "\n"
                                                                   << fault_at(builder);
        EXPECT_EQ(fault_of(builder), "") << "no fault where nothing plays";
    }
    Builder lost = moved({0}, {1, 1, 1});
    lost.json["animations"][0]["channels"][0]["sampler"] = 1;
    EXPECT_NE(fault_at(lost).find("channels[0].sampler: there is no sampler 1"), std::string::npos);
    lost.json["animations"][0].erase("samplers");
    EXPECT_NE(fault_at(lost).find("\"samplers\" is missing"), std::string::npos) << fault_at(lost);
    Builder morph = animated("weights", "SCALAR", {0}, {1, 1});
    EXPECT_NE(fault_at(morph).find("0 morph targets, but there are 2 weights"), std::string::npos);
}

}  // namespace
}  // namespace sheer::test
