// glTF textures: images from all places, samplers, transforms.

#include "gltf_fixture.h"

#include <cmath>
#include <filesystem>

#include "image/jpeg_file.h"
#include "image/png_file.h"

namespace sheer::test {
namespace {

using Texel = std::array<std::uint8_t, 4>;

// A PNG of one texel.
Bytes one_texel(int r, int g, int b, int a = 255)
{
    const png_file::Bytes bytes =
        png_file::make_png({1, 1, 8, png_file::kRgba, png_file::text_of({0, r, g, b, a})});
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    return Bytes(data, data + bytes.size());
}

// A triangle whose material has one texture, on an image in a data URI.
Builder textured()
{
    Builder builder = one_triangle();
    builder.json["materials"] =
        parse_json(R"([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}])");
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    builder.json["textures"] = parse_json(R"([{"source": 0}])");
    builder.json["images"] = {
        {{"name", "red"}, {"uri", "data:image/png;base64," + base64(one_texel(255, 0, 0))}}};
    return builder;
}

Json& info_of(Builder& builder)
{
    return builder.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
}

Texture texture_of(const Builder& builder)
{
    return read(builder).materials.at(0).base_color_texture.value();
}

TEST(GltfTextures, ReadsATextureAndItsImage)
{
    const Scene scene = read(textured());
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].name, "red");
    EXPECT_EQ(scene.images[0].width, 1);
    EXPECT_EQ(scene.images[0].height, 1);
    EXPECT_EQ(scene.images[0].texels, (std::vector<Texel>{{255, 0, 0, 255}}));
    const Texture texture = scene.materials.at(0).base_color_texture.value();
    EXPECT_EQ(texture.image, 0u);
    EXPECT_EQ(texture.set, 0u);
    EXPECT_EQ(texture.transform, (std::array<float, 6>{1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(texture.sampler.wrap_u, Wrap::repeat);
    EXPECT_EQ(texture.sampler.wrap_v, Wrap::repeat);
    EXPECT_EQ(texture.sampler.magnify, TexelFilter::linear);
    EXPECT_EQ(texture.sampler.minify, TexelFilter::linear);
    EXPECT_EQ(texture.sampler.mip, MipFilter::linear);
    EXPECT_TRUE(scene.ignored.empty());
}

TEST(GltfTextures, ReadsTexturesOfEveryKind)
{
    Builder builder = textured();
    builder.json["materials"][0] = parse_json(R"({
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
                                 "metallicRoughnessTexture": {"index": 1, "texCoord": 1}},
        "normalTexture": {"index": 2, "scale": -0.5}, "emissiveTexture": {"index": 3},
        "extensions": {"KHR_materials_transmission": {"transmissionTexture": {"index": 4}}}})");
    builder.json["textures"] = Json::array();
    builder.json["images"] = Json::array();
    for (int i = 0; i < 5; ++i) {
        builder.json["textures"].push_back({{"source", 4 - i}});
        builder.json["images"].push_back(
            {{"uri", "data:image/png;base64," + base64(one_texel(4 - i, 0, 0))}});
    }
    const Scene scene = read(builder);
    const Material& material = scene.materials.at(0);
    const auto red = [&](const std::optional<Texture>& texture) {
        return scene.images.at(texture.value().image).texels.at(0)[0];
    };
    EXPECT_EQ(red(material.base_color_texture), 0);
    EXPECT_EQ(red(material.metallic_roughness_texture), 1);
    EXPECT_EQ(red(material.normal_texture), 2);
    EXPECT_EQ(red(material.emission_texture), 3);
    EXPECT_EQ(red(material.transmission_texture), 4);
    EXPECT_EQ(material.metallic_roughness_texture->set, 1u);
    EXPECT_EQ(material.normal_scale, -0.5f);
}

TEST(GltfTextures, ReadsImagesFromBuffersAndFiles)
{
    Builder builder = textured();
    builder.json["images"][0] = {{"bufferView", builder.view(one_texel(0, 255, 0))},
                                 {"mimeType", "image/png"}};
    EXPECT_EQ(read(builder).images.at(0).texels[0], (Texel{0, 255, 0, 255}));

    const Bytes blue = one_texel(0, 0, 255, 51);
    in_temp_dir("deep blue.png", std::string(blue.begin(), blue.end()));
    builder.json["images"][0] = {{"uri", "deep%20blue.png"}};
    const std::string path = in_temp_dir("textured.gltf", builder.text());
    const Scene scene = read_gltf(path);
    EXPECT_EQ(scene.images.at(0).texels[0], (Texel{0, 0, 255, 51}));
    EXPECT_EQ(scene.images[0].name, "deep%20blue.png");
}

TEST(GltfTextures, WhatAnImageIsItsContentSays)
{
    Builder builder = textured();
    const Bytes jpeg = jpeg_file::make_jpeg({8, 8, JCS_GRAYSCALE, JCS_GRAYSCALE, {{77}}});
    builder.json["images"][0] = {{"bufferView", builder.view(jpeg)}, {"mimeType", "image/png"}};
    const Scene scene = read(builder);
    EXPECT_EQ(scene.images.at(0).texels.size(), 64u);
    EXPECT_EQ(scene.images[0].texels[63], (Texel{77, 77, 77, 255}));
}

TEST(GltfTextures, DecodesOnlyWhatIsDrawnAndOnce)
{
    Builder builder = textured();
    builder.json["materials"].push_back(builder.json["materials"][0]);
    builder.json["materials"].push_back(builder.json["materials"][0]);
    builder.primitive({{"POSITION", 0}})["material"] = 2;
    builder.json["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 1;
    builder.json["textures"].push_back({{"source", 1}});
    builder.json["images"].push_back({{"uri", "no-such-file.png"}});
    const Scene scene = read(builder);
    EXPECT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.materials.at(0).base_color_texture.value().image, 0u);
    EXPECT_FALSE(scene.materials.at(1).base_color_texture);  // nothing uses it
    EXPECT_EQ(scene.materials.at(2).base_color_texture.value().image, 0u);
}

TEST(GltfTextures, DrawsWithoutImagesOfOtherKinds)
{
    Builder builder = textured();
    const std::string webp = "RIFF\x04\0\0\0WEBP";
    builder.json["images"][0] = {{"bufferView", builder.view(Bytes(webp.begin(), webp.end()))}};
    const Scene scene = read(builder);
    EXPECT_TRUE(scene.images.empty());
    EXPECT_FALSE(scene.materials.at(0).base_color_texture);
    EXPECT_TRUE(notes(scene, "images that are neither PNG nor JPEG: 1, drawn without"));
    builder.json["textures"][0] =
        parse_json(R"({"extensions": {"KHR_texture_basisu": {"source": 0}}})");
    EXPECT_TRUE(
        notes(read(builder), "textures without an image that is PNG or JPEG: 1, drawn without"));
}

TEST(GltfTextures, ReadsSamplers)
{
    const auto sampler_of = [](const char* text) {
        Builder builder = textured();
        builder.json["textures"][0]["sampler"] = 0;
        builder.json["samplers"] = Json::array({parse_json(text)});
        return texture_of(builder).sampler;
    };
    EXPECT_EQ(sampler_of("{}").mip, MipFilter::linear);
    EXPECT_EQ(sampler_of(R"({"wrapS": 33071})").wrap_u, Wrap::clamp_to_edge);
    EXPECT_EQ(sampler_of(R"({"wrapS": 33071})").wrap_v, Wrap::repeat);
    EXPECT_EQ(sampler_of(R"({"wrapT": 33648})").wrap_v, Wrap::mirrored_repeat);
    EXPECT_EQ(sampler_of(R"({"wrapT": 10497})").wrap_v, Wrap::repeat);
    EXPECT_EQ(sampler_of(R"({"magFilter": 9728})").magnify, TexelFilter::nearest);
    EXPECT_EQ(sampler_of(R"({"magFilter": 9729})").magnify, TexelFilter::linear);
    struct Row {
        const char* text;
        TexelFilter minify;
        MipFilter mip;
    };
    for (const Row& row : {Row{R"({"minFilter": 9728})", TexelFilter::nearest, MipFilter::none},
                           Row{R"({"minFilter": 9729})", TexelFilter::linear, MipFilter::none},
                           Row{R"({"minFilter": 9984})", TexelFilter::nearest, MipFilter::nearest},
                           Row{R"({"minFilter": 9985})", TexelFilter::linear, MipFilter::nearest},
                           Row{R"({"minFilter": 9986})", TexelFilter::nearest, MipFilter::linear},
                           Row{R"({"minFilter": 9987})", TexelFilter::linear, MipFilter::linear}}) {
        EXPECT_EQ(sampler_of(row.text).minify, row.minify) << row.text;
        EXPECT_EQ(sampler_of(row.text).mip, row.mip) << row.text;
    }
}

// Where (u, v) goes.
Float2 transformed(const std::array<float, 6>& t, float u, float v)
{
    return {t[0] * u + t[1] * v + t[2], t[3] * u + t[4] * v + t[5]};
}

TEST(GltfTextures, TransformsCoordinates)
{
    Builder builder = textured();
    // The extension's own example: the lower left quarter of the image, turned clockwise by 90
    // degrees. Lower is larger v. The image's lower left corner, (0, 1), is then seen at the top
    // left, (0, 0), and its upper left corner of the quarter, (0, 0.5), at the top right.
    info_of(builder)["extensions"]["KHR_texture_transform"] =
        parse_json(R"({"offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5]})");
    const auto turned = texture_of(builder).transform;
    const Float2 top_left = transformed(turned, 0, 0), top_right = transformed(turned, 1, 0);
    const Float2 bottom_left = transformed(turned, 0, 1);
    EXPECT_NEAR(top_left[0], 0, 1e-6);
    EXPECT_NEAR(top_left[1], 1, 1e-6);
    EXPECT_NEAR(top_right[0], 0, 1e-6);
    EXPECT_NEAR(top_right[1], .5, 1e-6);
    EXPECT_NEAR(bottom_left[0], .5, 1e-6);
    EXPECT_NEAR(bottom_left[1], 1, 1e-6);
    // And its other one, which turns the v axis round.
    info_of(builder)["extensions"]["KHR_texture_transform"] =
        parse_json(R"({"offset": [0, 1], "scale": [1, -1]})");
    EXPECT_EQ(texture_of(builder).transform, (std::array<float, 6>{1, 0, 0, 0, -1, 1}));
    // Scale comes before rotation: (1, 1) goes to (2, 3) and is turned from there.
    info_of(builder)["extensions"]["KHR_texture_transform"] =
        parse_json(R"({"rotation": 1.57079632679, "scale": [2, 3]})");
    const Float2 corner = transformed(texture_of(builder).transform, 1, 1);
    EXPECT_NEAR(corner[0], 3, 1e-5);
    EXPECT_NEAR(corner[1], -2, 1e-5);
}

TEST(GltfTextures, TheTransformMayNameTheSet)
{
    Builder builder = textured();
    info_of(builder)["texCoord"] = 7;
    info_of(builder)["extensions"]["KHR_texture_transform"]["texCoord"] = 1;
    EXPECT_EQ(texture_of(builder).set, 1u);
    info_of(builder)["extensions"]["KHR_texture_transform"]["texCoord"] = 2;
    const Scene scene = read(builder);
    EXPECT_FALSE(scene.materials.at(0).base_color_texture);
    EXPECT_TRUE(scene.images.empty());
    EXPECT_TRUE(notes(scene, "textures on a third or later set of coordinates: 1, drawn without"));
}

TEST(GltfTextures, LitLinesWithoutTangentsLoseTheNormalTexture)
{
    Builder builder = textured();
    builder.json["materials"][0]["normalTexture"]["index"] = 0;
    Json& primitive = builder.json["meshes"][0]["primitives"][0];
    primitive["mode"] = 3;
    primitive["attributes"]["NORMAL"] =
        builder.accessor("VEC3", std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1});
    Scene scene = read(builder);
    const Material& copy = scene.materials.at(scene.meshes.at(0).material);
    EXPECT_EQ(copy.shading, Shading::metallic_roughness);
    EXPECT_TRUE(copy.base_color_texture);
    EXPECT_FALSE(copy.normal_texture);
    primitive["attributes"]["TANGENT"] =
        builder.accessor("VEC4", std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
    scene = read(builder);
    EXPECT_EQ(scene.meshes.at(0).material, 0u);
    EXPECT_TRUE(scene.materials.at(0).normal_texture);
}

TEST(GltfTextures, Faults)
{
    const auto after = [](auto change) {
        Builder builder = textured();
        change(builder);
        return fault_of(builder);
    };
    const std::string info = "test.gltf: materials[0].pbrMetallicRoughness.baseColorTexture";
    EXPECT_EQ(after([](Builder& b) { info_of(b)["index"] = 1; }),
              info + ".index: there is no textures[1], the file has 1");
    EXPECT_EQ(after([](Builder& b) { info_of(b).erase("index"); }),
              info + ": \"index\" is missing");
    EXPECT_EQ(after([](Builder& b) { b.json["textures"][0]["source"] = 5; }),
              "test.gltf: textures[0].source: there is no images[5], the file has 1");
    EXPECT_EQ(after([](Builder& b) {
                  b.json["textures"][0]["sampler"] = 0;
                  b.json["samplers"] = {{{"wrapT", 1}}};
              }),
              "test.gltf: samplers[0].wrapT: there is no wrapping mode 1");
    EXPECT_EQ(after([](Builder& b) {
                  b.json["textures"][0]["sampler"] = 0;
                  b.json["samplers"] = {{{"magFilter", 9987}}};
              }),
              "test.gltf: samplers[0].magFilter: there is no such filter 9987");
    EXPECT_EQ(after([](Builder& b) {
                  b.json["textures"][0]["sampler"] = 0;
                  b.json["samplers"] = {{{"minFilter", 1}}};
              }),
              "test.gltf: samplers[0].minFilter: there is no such filter 1");
    EXPECT_EQ(after([](Builder& b) {
                  info_of(b)["extensions"]["KHR_texture_transform"]["rotation"] = 1e7;
              }),
              info + ".extensions.KHR_texture_transform: a number is beyond 1,000,000");
    EXPECT_EQ(after([](Builder& b) { b.json["images"][0] = Json::object(); }),
              "test.gltf: images[0]: has neither a uri nor a bufferView");
    EXPECT_EQ(after([](Builder& b) {
                  b.json["images"][0] = {{"uri", "nothing.png"}};
              }),
              "test.gltf: images[0].uri: nothing.png: no such file");
    EXPECT_EQ(after([](Builder& b) {
                  b.json["materials"][0]["normalTexture"] = {{"index", 0}, {"scale", 1e7}};
              }),
              "test.gltf: materials[0].normalTexture: its scale is beyond 1,000,000");
}

TEST(GltfTextures, BrokenImagesAreFaults)
{
    Builder builder = textured();
    Bytes cut = one_texel(1, 2, 3);
    cut.resize(cut.size() / 2);
    builder.json["images"][0] = {{"uri", "data:;base64," + base64(cut)}};
    EXPECT_EQ(fault_of(builder).rfind("test.gltf: images[0]: ", 0), 0u) << fault_of(builder);
}

TEST(GltfTextures, ImagesOfTheSameBytesAreDecodedOnce)
{
    Builder builder = textured();
    builder.json["images"].push_back(builder.json["images"][0]);
    builder.json["textures"].push_back({{"source", 1}});
    builder.json["materials"][0]["emissiveTexture"]["index"] = 1;
    const std::string text = builder.text();
    const Scene scene = read_gltf("test.gltf", Bytes(text.begin(), text.end()));
    EXPECT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.materials[0].emission_texture->image, 0u);
}

TEST(GltfTextures, TheSchemeMayBeInCapitals)
{
    Builder builder = textured();
    builder.json["images"][0] = {{"uri", "DATA:;base64," + base64(one_texel(1, 2, 3))}};
    EXPECT_EQ(read(builder).images.size(), 1u);
}

TEST(GltfTextures, NamesThatAreTooLongAreCalledThat)
{
    Builder builder = textured();
    builder.json["images"][0] = {{"uri", std::string(5000, 'a')}};
    EXPECT_NE(fault_of(builder).find("is too long for a file's name"), std::string::npos);
}

TEST(GltfTextures, BoundsTexels)
{
    Builder builder = textured();
    builder.json["images"].push_back({{"bufferView", builder.view(one_texel(1, 2, 3))}});
    builder.json["textures"].push_back({{"source", 1}});
    builder.json["materials"][0]["emissiveTexture"]["index"] = 1;
    const std::string text = builder.text();
    const Bytes content(text.begin(), text.end());
    LoadOptions options;
    options.most_texels = 2;
    EXPECT_EQ(read_gltf("test.gltf", content, options).images.size(), 2u);
    options.most_texels = 1;
    EXPECT_THROW(read_gltf("test.gltf", content, options), Error);
}

TEST(GltfTextures, FilesOutsideOfTheFolderMustBeAllowed)
{
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(testing::TempDir()) / "scene folder";
    fs::create_directories(folder / "inner");
    const Bytes red = one_texel(255, 0, 0);
    const std::string png(red.begin(), red.end());
    in_temp_dir("outside.png", png);
    in_temp_dir("scene folder/beside.png", png);
    in_temp_dir("scene folder/inner/below.png", png);
    fs::remove(folder / "link.png");
    fs::create_symlink("../outside.png", folder / "link.png");
    const auto fault = [&](const std::string& uri, bool anywhere = false) -> std::string {
        Builder builder = textured();
        builder.json["images"][0] = {{"uri", uri}};
        const std::string path = in_temp_dir("scene folder/scene.gltf", builder.text());
        try {
            LoadOptions options;
            options.allow_any_file = anywhere;
            read_gltf(path, options);
        } catch (const Error& e) {
            return std::string(e.what()).substr(path.size());
        }
        return "";
    };
    EXPECT_EQ(fault("beside.png"), "");
    EXPECT_EQ(fault("inner/below.png"), "");
    EXPECT_EQ(fault("inner/../beside.png"), "");
    EXPECT_EQ(fault("../scene%20folder/beside.png"), "");
    const std::string absolute = testing::TempDir() + "outside.png";
    for (const std::string& uri : {std::string("../outside.png"), std::string("%2e%2e/outside.png"),
                                   std::string("link.png"), absolute}) {
        EXPECT_EQ(fault(uri), ": images[0].uri: \"" + uri + "\" is outside of the scene's folder " +
                                  "(--allow-any-file lets it be read)");
        EXPECT_EQ(fault(uri, true), "") << uri;
    }
}

}  // namespace
}  // namespace sheer::test
