// What the glTF reader says to broken files: one line that names the file, the place and the fault.

#include "gltf_fixture.h"

#include <limits>

namespace sheer::test {
namespace {

Json& primitive_of(Builder& builder)
{
    return builder.json["meshes"][0]["primitives"][0];
}

// The complaint after `change` was made to a good triangle.
template <class Change>
std::string after(Change change)
{
    Builder builder = one_triangle();
    change(builder);
    return fault_of(builder);
}

void expect_has(const std::string& text, const std::string& part)
{
    EXPECT_NE(text.find(part), std::string::npos) << "got: " << text << "\nnot: " << part;
}

TEST(GltfFaults, Files)
{
    const auto fault = [](const std::string& path) -> std::string {
        try {
            read_gltf(path);
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_EQ(fault("/no/such/file.glb"), "/no/such/file.glb: no such file");
    expect_has(fault(testing::TempDir()), "is a directory, not a file");
    expect_has(fault("/dev/zero"), "/dev/zero: is not a regular file");
    EXPECT_EQ(fault_of_text(""), "test.gltf: the file is empty");
}

TEST(GltfFaults, Json)
{
    expect_has(fault_of_text("{\"asset\": }"), "test.gltf: JSON: parse error at line 1, column 11");
    EXPECT_EQ(fault_of_text("[]"), "test.gltf: JSON: must be an object");
    expect_has(fault_of_text("{\"a\": 1e999}"), "JSON: number overflow");
    expect_has(fault_of_text("{\"a\": \"\n\"}"), "JSON: parse error");
    EXPECT_EQ(fault_of_text("{}"), "test.gltf: \"asset\" is missing");
    const auto nested = [](std::size_t depth) {
        return "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(depth, '[') +
               std::string(depth, ']') + "}";
    };
    EXPECT_EQ(fault_of_text(nested(63)), "");
    EXPECT_EQ(fault_of_text(nested(64)), "test.gltf: JSON: nested deeper than 64 levels");
    EXPECT_EQ(fault_of_text(nested(1000000)), "test.gltf: JSON: nested deeper than 64 levels");
    EXPECT_EQ(fault_of_text(std::string(1000000, '[')),
              "test.gltf: JSON: nested deeper than 64 levels");
}

TEST(GltfFaults, Versions)
{
    const auto with_asset = [](const char* asset) {
        return fault_of_text(std::string("{\"asset\":") + asset + "}");
    };
    EXPECT_EQ(with_asset(R"({"version": "1.0"})"),
              "test.gltf: asset: glTF 1.0 is not supported, only glTF 2.0 is");
    EXPECT_EQ(with_asset(R"({"version": 1})"),
              "test.gltf: asset: glTF 1.0 is not supported, only glTF 2.0 is");
    EXPECT_EQ(with_asset("{}"), "test.gltf: asset: glTF 1.0 is not supported, only glTF 2.0 is");
    EXPECT_EQ(with_asset(R"({"version": "2.1"})"), "");
    EXPECT_EQ(with_asset(R"({"version": "2.1", "minVersion": "2.1"})"),
              "test.gltf: asset.minVersion: glTF 2.1 is needed, only 2.0 is supported");
    EXPECT_EQ(with_asset(R"({"version": "two"})"),
              "test.gltf: asset.version: must be a version such as \"2.0\", not \"two\"");
    EXPECT_EQ(with_asset(R"({"version": 2})"),
              "test.gltf: asset.version: must be a string, not number");
}

TEST(GltfFaults, RequiredExtensions)
{
    EXPECT_EQ(after([](Builder& b) {
                  b.json["extensionsRequired"] = {"KHR_materials_unlit", "EXT_not_yet"};
              }),
              "test.gltf: extensionsRequired[1]: the extension EXT_not_yet is not supported");
}

TEST(GltfFaults, Glb)
{
    const std::string good = as_glb(one_triangle());
    EXPECT_EQ(fault_of_text(good), "");
    for (std::size_t length = 1; length < good.size(); ++length) {
        EXPECT_NE(fault_of_text(good.substr(0, length)), "") << length;
    }
    expect_has(fault_of_text(good.substr(0, 100)), "test.gltf: GLB: cut off");
    std::string old = good;
    old[4] = 1;
    EXPECT_EQ(fault_of_text(old), "test.gltf: GLB: version 1 is not supported, only glTF 2.0 is");
    std::string long_chunk = good;
    long_chunk[15] = '\x7F';
    expect_has(fault_of_text(long_chunk), "reaches past the end");
}

TEST(GltfFaults, Types)
{
    EXPECT_EQ(after([](Builder& b) { b.json["nodes"] = 5; }),
              "test.gltf: nodes: must be an array, not number");
    EXPECT_EQ(after([](Builder& b) { b.json["nodes"][0] = Json::array(); }),
              "test.gltf: nodes[0]: must be an object, not array");
    EXPECT_EQ(after([](Builder& b) { b.json["accessors"][0]["count"] = -3; }),
              "test.gltf: accessors[0].count: must be a whole number from 0 to 2^53");
    EXPECT_EQ(after([](Builder& b) { b.json["accessors"][0]["count"] = 2.5; }),
              "test.gltf: accessors[0].count: must be a whole number from 0 to 2^53");
    EXPECT_EQ(after([](Builder& b) { b.json["accessors"][0]["count"] = 3.0; }), "");
    EXPECT_EQ(after([](Builder& b) { b.json["accessors"][0]["count"] = nullptr; }),
              "test.gltf: accessors[0].count: must be a number, not null");
    EXPECT_EQ(after([](Builder& b) { b.json["nodes"][0]["name"] = "a\nb"; }), "");
    expect_has(after([](Builder& b) { b.json["accessors"][0]["type"] = "VEC\n3"; }),
               "accessors[0].type: the type \"VEC?3\" has no use here");
}

TEST(GltfFaults, SizesAndOffsets)
{
    EXPECT_EQ(after([](Builder& b) { b.json["accessors"][0]["byteOffset"] = 4; }),
              "test.gltf: accessors[0]: needs 40 bytes of a bufferView that has 36");
    EXPECT_EQ(
        after([](Builder& b) { b.json["bufferViews"][0]["byteOffset"] = 4; }),
        "test.gltf: bufferViews[0]: byteOffset 4 and byteLength 36 reach past the 36 bytes of "
        "buffers[0]");
    EXPECT_EQ(after([](Builder& b) { b.json["bufferViews"][0]["byteStride"] = 8; }),
              "test.gltf: accessors[0]: its elements of 12 bytes overlap in a bufferView of "
              "byteStride 8");
    EXPECT_EQ(after([](Builder& b) { b.json["bufferViews"][0]["byteStride"] = 256; }),
              "test.gltf: bufferViews[0].byteStride: must be from 4 to 252");
    for (const std::uint64_t huge : {std::uint64_t{1} << 53, (std::uint64_t{1} << 53) - 1,
                                     std::numeric_limits<std::uint64_t>::max()}) {
        for (const char* key : {"byteOffset", "byteLength"}) {
            EXPECT_NE(after([&](Builder& b) { b.json["bufferViews"][0][key] = huge; }), "");
        }
        for (const char* key : {"byteOffset", "count"}) {
            EXPECT_NE(after([&](Builder& b) { b.json["accessors"][0][key] = huge; }), "");
        }
    }
    EXPECT_EQ(after([](Builder& b) {
                  b.json["accessors"][0]["count"] = 4000000000u;
                  b.json["accessors"][0].erase("bufferView");
              }),
              "test.gltf: accessors[0]: more elements than --most-elements allows (268435456)");
    EXPECT_EQ(after([](Builder& b) {
                  b.json["accessors"][0]["count"] = 1 << 25;
                  b.json["accessors"][0].erase("bufferView");
              }),
              "test.gltf: accessors[0]: more elements without a bufferView than a 256th of "
              "--most-elements (1048576)");
}

TEST(GltfFaults, Vertices)
{
    EXPECT_EQ(
        after([](Builder& b) {
            primitive_of(b)["indices"] = b.accessor("SCALAR", std::vector<std::uint16_t>{0, 1, 3});
        }),
        "test.gltf: accessors[1]: element 2 is 3, but there are only 3 vertices");
    EXPECT_EQ(
        after([](Builder& b) {
            primitive_of(b)["indices"] = b.accessor("SCALAR", std::vector<std::uint8_t>{0, 255, 1});
        }),
        "test.gltf: accessors[1]: element 1 is the primitive restart mark, which glTF does "
        "not allow");
    EXPECT_EQ(
        after([](Builder& b) {
            primitive_of(b)["attributes"]["NORMAL"] = b.accessor("VEC3", curve(4));
        }),
        "test.gltf: meshes[0].primitives[0].attributes.NORMAL: has 4 elements, POSITION has 3");
    EXPECT_EQ(after([](Builder& b) {
                  std::vector<float> positions = curve(3);
                  positions[7] = std::numeric_limits<float>::infinity();
                  primitive_of(b)["attributes"]["POSITION"] = b.accessor("VEC3", positions);
              }),
              "test.gltf: accessors[1]: vertex 2 is infinite or not a number");
    EXPECT_EQ(after([](Builder& b) { primitive_of(b)["mode"] = 7; }),
              "test.gltf: meshes[0].primitives[0].mode: there is no mode 7");
    EXPECT_EQ(after([](Builder& b) { primitive_of(b)["material"] = 0; }),
              "test.gltf: meshes[0].primitives[0].material: there is no materials[0], the file has "
              "0");
}

TEST(GltfFaults, SparseIndices)
{
    const auto with_indices = [](const std::vector<std::uint8_t>& indices) {
        return after([&](Builder& b) {
            b.json["accessors"][0]["sparse"] = {
                {"count", indices.size()},
                {"indices", {{"bufferView", b.view(indices)}, {"componentType", 5121}}},
                {"values", {{"bufferView", b.view(curve(static_cast<int>(indices.size())))}}}};
        });
    };
    EXPECT_EQ(with_indices({0, 2}), "");
    EXPECT_EQ(with_indices({2, 1}),
              "test.gltf: accessors[0]: sparse.indices: must grow from one to the next");
    EXPECT_EQ(with_indices({3}), "test.gltf: accessors[0]: sparse.indices: element 3 of 3");
    EXPECT_EQ(with_indices({0, 1, 2, 2}),
              "test.gltf: accessors[0].sparse.count: is larger than the accessor's");
}

TEST(GltfFaults, Materials)
{
    const auto with_material = [](const char* material) {
        return after(
            [&](Builder& b) { b.json["materials"] = Json::array({parse_json(material)}); });
    };
    EXPECT_EQ(with_material(R"({"alphaMode": "GLASS"})"),
              "test.gltf: materials[0].alphaMode: must be OPAQUE, MASK or BLEND, not \"GLASS\"");
    EXPECT_EQ(with_material(R"({"alphaCutoff": -1})"),
              "test.gltf: materials[0].alphaCutoff: must not be negative");
    EXPECT_EQ(with_material(R"({"doubleSided": 1})"),
              "test.gltf: materials[0].doubleSided: must be true or false, not number");
    EXPECT_EQ(with_material(R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1]}})"),
              "test.gltf: materials[0].pbrMetallicRoughness.baseColorFactor: must be an array of 4 "
              "numbers");
}

TEST(GltfFaults, Addresses)
{
    const auto with_uri = [](const std::string& uri) {
        return after([&](Builder& b) { b.json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}}; });
    };
    EXPECT_EQ(with_uri("https://example.org/a.bin"),
              "test.gltf: buffers[0].uri: https: addresses are not read, only files and data URIs "
              "are");
    EXPECT_EQ(with_uri("no-such-file.bin"),
              "test.gltf: buffers[0].uri: no-such-file.bin: no such file");
    EXPECT_EQ(with_uri("a%00b"), "test.gltf: buffers[0].uri: a path cannot hold a zero byte");
    EXPECT_EQ(with_uri("data:;base64"),
              "test.gltf: buffers[0].uri: the data URI has no comma before its data");
    EXPECT_EQ(with_uri("data:;base64,AA!A"),
              "test.gltf: buffers[0].uri: the base64 data holds a character that is not base64");
    EXPECT_EQ(with_uri("data:;base64,AAAAA"),
              "test.gltf: buffers[0].uri: the base64 data is cut off");
    EXPECT_EQ(with_uri("data:;base64,AAAA"),
              "test.gltf: accessors[0]: its data is missing, the buffer is cut off");
    EXPECT_EQ(after([](Builder& b) {
                  b.json["buffers"] = {{{"byteLength", 36}}};
              }),
              "test.gltf: buffers[0]: has no uri, and the file has no binary chunk for it");
}

TEST(GltfFaults, ShortBufferServesAsFarAsItGoes)
{
    Builder builder = one_triangle();
    builder.json["buffers"] = {
        {{"byteLength", 1000}, {"uri", "data:;base64," + base64(builder.data)}}};
    EXPECT_TRUE(notes(read(builder), "buffers shorter than declared: 1, used as far as they go"));
}

}  // namespace
}  // namespace sheer::test
