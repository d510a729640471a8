// glTF materials: what they say of light, colour and opacity. Their textures have a file beside
// this.

#include "gltf_fixture.h"

namespace sheer::test {
namespace {

TEST(GltfMaterials, ReadsMaterials)
{
    Builder builder = one_triangle();
    builder.json["meshes"][0]["primitives"][0]["material"] = 1;
    builder.json["materials"] = parse_json(R"([{}, {
        "name": "pane", "alphaMode": "BLEND", "doubleSided": true,
        "pbrMetallicRoughness": {"baseColorFactor": [0.25, 0.5, 0.75, 0.5]},
        "extensions": {"KHR_materials_unlit": {}}},
        {"alphaMode": "MASK", "alphaCutoff": 0.25}])");
    const Scene scene = read(builder);
    ASSERT_EQ(scene.materials.size(), 3u);
    EXPECT_EQ(scene.meshes.at(0).material, 1u);
    EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(scene.materials[0].opacity, 1.0f);
    const Material& pane = scene.materials[1];
    EXPECT_EQ(pane.name, "pane");
    EXPECT_EQ(pane.base_color, (Float3{.25f, .5f, .75f}));
    EXPECT_EQ(pane.opacity, .5f);
    EXPECT_EQ(pane.alpha_mode, AlphaMode::blend);
    EXPECT_TRUE(pane.double_sided);
    EXPECT_EQ(pane.shading, Shading::unlit);
    EXPECT_EQ(scene.materials[0].shading, Shading::metallic_roughness);
    EXPECT_EQ(scene.materials[2].alpha_mode, AlphaMode::mask);
    EXPECT_EQ(scene.materials[2].alpha_cutoff, .25f);
    EXPECT_TRUE(scene.ignored.empty());
}

TEST(GltfMaterials, PrimitivesWithoutMaterialShareADefaultOne)
{
    Builder builder = one_triangle();
    builder.json["materials"] = {{{"name", "unused"}}};
    builder.primitive({{"POSITION", 0}});
    const Scene scene = read(builder);
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(material_number(scene, scene.objects.at(0)), 1u);
    EXPECT_EQ(material_number(scene, scene.objects.at(1)), 1u);
    const Material& material = scene.materials[1];
    EXPECT_EQ(material.base_color, (Float3{1, 1, 1}));
    EXPECT_EQ(material.shading, Shading::metallic_roughness);
    EXPECT_EQ(material.metallic, 1.0f);
    EXPECT_EQ(material.roughness, 1.0f);
    EXPECT_EQ(material.emission, (Float3{0, 0, 0}));
    EXPECT_EQ(material.transmission, 0.0f);
}

Material material_of(const char* text)
{
    Builder builder = one_triangle();
    builder.json["materials"] = Json::array({parse_json(text)});
    return read(builder).materials.at(0);
}

TEST(GltfMaterials, ReadsMetalAndRoughness)
{
    const Material material = material_of(
        R"({"pbrMetallicRoughness": {"metallicFactor": 0.25, "roughnessFactor": 0.5}})");
    EXPECT_EQ(material.metallic, 0.25f);
    EXPECT_EQ(material.roughness, 0.5f);
    const Material other = material_of(R"({"pbrMetallicRoughness": {"metallicFactor": 0}})");
    EXPECT_EQ(other.metallic, 0.0f);
    EXPECT_EQ(other.roughness, 1.0f);
    EXPECT_EQ(material_of(R"({"name": "plain"})").metallic, 1.0f);
}

TEST(GltfMaterials, ReadsEmissionAndItsStrength)
{
    EXPECT_EQ(material_of(R"({"emissiveFactor": [0.5, 0.25, 1]})").emission,
              (Float3{.5f, .25f, 1}));
    EXPECT_EQ(material_of(R"({"emissiveFactor": [0.5, 0.25, 1],
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}}})")
                  .emission,
              (Float3{4, 2, 8}));
    EXPECT_EQ(material_of(R"({"emissiveFactor": [0.5, 0.25, 1],
        "extensions": {"KHR_materials_emissive_strength": {}}})")
                  .emission,
              (Float3{.5f, .25f, 1}));
}

TEST(GltfMaterials, ReadsTransmission)
{
    EXPECT_EQ(material_of(R"({"extensions": {
        "KHR_materials_transmission": {"transmissionFactor": 0.75}}})")
                  .transmission,
              0.75f);
    EXPECT_EQ(material_of(R"({"extensions": {"KHR_materials_transmission": {}}})").transmission,
              0.0f);
}

TEST(GltfMaterials, WhatIsUnlitNeitherEmitsNorTransmits)
{
    const Material material = material_of(R"({"emissiveFactor": [1, 1, 1], "extensions": {
        "KHR_materials_unlit": {}, "KHR_materials_transmission": {"transmissionFactor": 1}}})");
    EXPECT_EQ(material.shading, Shading::unlit);
    EXPECT_EQ(material.emission, (Float3{0, 0, 0}));
    EXPECT_EQ(material.transmission, 0.0f);
}

TEST(GltfMaterials, ClampsFactorsAndSaysSo)
{
    Builder builder = one_triangle();
    builder.json["materials"] = parse_json(R"([{"emissiveFactor": [0, 2, -1],
        "pbrMetallicRoughness": {"metallicFactor": 3, "roughnessFactor": -1,
                                 "baseColorFactor": [2, 0.5, 0.5, 1]}}])");
    const Scene scene = read(builder);
    EXPECT_EQ(scene.materials[0].emission, (Float3{0, 1, 0}));
    EXPECT_EQ(scene.materials[0].metallic, 1.0f);
    EXPECT_EQ(scene.materials[0].roughness, 0.0f);
    EXPECT_EQ(scene.materials[0].base_color, (Float3{1, .5f, .5f}));
    EXPECT_EQ(scene.ignored,
              (std::vector<std::string>{
                  "materials with a baseColorFactor outside of [0, 1]: 1, clamped",
                  "materials with a emissiveFactor outside of [0, 1]: 1, clamped",
                  "materials with a metallicFactor outside of [0, 1]: 1, clamped",
                  "materials with a roughnessFactor outside of [0, 1]: 1, clamped"}));
}

TEST(GltfMaterials, NotesWhatItDoesNotDraw)
{
    Builder builder = one_triangle();
    builder.json["materials"] = parse_json(R"([
        {"occlusionTexture": {"index": 0}},
        {"occlusionTexture": {"index": 0},
         "extensions": {"KHR_materials_volume": {}, "KHR_materials_clearcoat": {}}}])");
    builder.json["animations"] = {Json::object(), Json::object()};
    EXPECT_EQ(read(builder).ignored,
              (std::vector<std::string>{
                  "animations: 2, not played",
                  "materials with KHR_materials_clearcoat: 1, drawn without it",
                  "materials with KHR_materials_volume: 1, drawn without it",
                  "materials with an occlusionTexture: 2, drawn without it",
              }));
}

TEST(GltfMaterials, RefusesWhatNoFloatHolds)
{
    const auto fault = [](const char* text) {
        Builder builder = one_triangle();
        builder.json["materials"] = Json::array({parse_json(text)});
        return fault_of(builder);
    };
    const std::string where =
        "test.gltf: materials[0].extensions.KHR_materials_emissive_strength.emissiveStrength: must "
        "be from 0 to 1,000,000";
    EXPECT_EQ(fault(R"({"extensions": {"KHR_materials_emissive_strength": {
                        "emissiveStrength": -1}}})"),
              where);
    EXPECT_EQ(fault(R"({"extensions": {"KHR_materials_emissive_strength": {
                        "emissiveStrength": 1e300}}})"),
              where);
    EXPECT_EQ(fault(R"({"pbrMetallicRoughness": {"metallicFactor": "all"}})"),
              "test.gltf: materials[0].pbrMetallicRoughness.metallicFactor: must be a number, not "
              "string");
}

}  // namespace
}  // namespace sheer::test
