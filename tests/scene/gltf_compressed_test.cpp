// glTF data that is compressed: meshes by Draco, buffer views by meshoptimizer. The libraries'
// encoders make what is read.

#include "gltf_fixture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include <meshoptimizer.h>

#include "gltf_draco_file.h"
#include "scene/gltf/meshopt_filters.h"

namespace sheer::test {
namespace {

using Indices = std::vector<std::uint32_t>;

Json& compression_of(Builder& builder)
{
    return builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
}

// The triangles by the positions of their corners: Draco keeps neither order nor first corner.
std::multiset<std::vector<Float3>> corners_of(const Mesh& mesh)
{
    std::multiset<std::vector<Float3>> triangles;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::vector<Float3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners.push_back(mesh.positions[mesh.indices[i + k]]);
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                    corners.end());
        triangles.insert(corners);
    }
    return triangles;
}

TEST(GltfDraco, ReadsWhatWasWritten)
{
    for (const bool edgebreaker : {false, true}) {
        const draco_file::Grid grid = draco_file::make_grid(4);
        const Mesh mesh = read(draco_file::compressed(grid, edgebreaker)).meshes.at(0);
        Mesh plain;
        plain.positions = grid.positions;
        plain.indices = grid.indices;
        EXPECT_EQ(mesh.positions.size(), grid.positions.size());
        EXPECT_EQ(corners_of(mesh), corners_of(plain)) << edgebreaker;
        ASSERT_EQ(mesh.normals.size(), grid.positions.size());
        ASSERT_EQ(mesh.texcoords[0].size(), grid.positions.size());
        ASSERT_EQ(mesh.colors.size(), grid.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            // The grid's other attributes are functions of its positions.
            const Float3& p = mesh.positions[i];
            EXPECT_EQ(mesh.normals[i], (Float3{0, 0, 1}));
            EXPECT_EQ(mesh.texcoords[0][i], (Float2{p[0] / 4, p[1] / 4}));
            EXPECT_EQ(mesh.colors[i][0], std::min(p[0] * 51, 255.0f) / 255);
        }
    }
}

TEST(GltfDraco, CompressedDataGoesBeforeTheFallback)
{
    const draco_file::Grid grid = draco_file::make_grid(2);
    Builder builder = draco_file::compressed(grid, false);
    Json& primitive = builder.json["meshes"][0]["primitives"][0];
    const std::vector<float> zeros(3 * grid.positions.size(), 0);
    primitive["attributes"]["POSITION"] = builder.accessor("VEC3", zeros);
    EXPECT_NE(read(builder).meshes.at(0).positions[1], (Float3{0, 0, 0}));
    primitive.erase("extensions");
    primitive.erase("indices");
    primitive["attributes"] = {{"POSITION", primitive["attributes"]["POSITION"]}};
    EXPECT_EQ(read(builder).meshes.at(0).positions[1], (Float3{0, 0, 0}));
}

TEST(GltfDraco, Faults)
{
    const draco_file::Grid grid = draco_file::make_grid(2);  // 9 vertices, 8 triangles
    const std::string place =
        "test.gltf: meshes[0].primitives[0].extensions.KHR_draco_mesh_compression";
    const auto after = [&](auto change) {
        Builder builder = draco_file::compressed(grid, true);
        change(builder);
        return fault_of(builder);
    };
    const auto accessor = [](Builder& b, const char* name) -> Json& {
        return b.json["accessors"]
                     [b.json["meshes"][0]["primitives"][0]["attributes"][name].get<std::size_t>()];
    };
    EXPECT_EQ(after([](Builder&) {}), "");
    EXPECT_EQ(after([](Builder& b) { compression_of(b) = Json::object(); }),
              place + ": \"bufferView\" is missing");
    EXPECT_EQ(after([](Builder& b) { b.data[0] = 'X'; }), place + ": the data is not Draco's");
    EXPECT_EQ(after([](Builder& b) { b.data[6] = 1; }),
              place + ": Draco bitstream 2.1 is not supported, only 2.2 is");
    EXPECT_EQ(after([](Builder& b) { b.data[7] = 0; }), place + ": the data is no mesh");
    EXPECT_EQ(after([](Builder& b) {
                  const std::size_t view = compression_of(b)["bufferView"];
                  b.json["bufferViews"][view]["byteLength"] = 12;
              }),
              place + ": the Draco data is cut off");
    EXPECT_EQ(after([](Builder& b) {
                  const std::size_t view = compression_of(b)["bufferView"];
                  b.json["bufferViews"][view]["byteLength"] = 60;
              }),
              place + ": the Draco data is broken");
    EXPECT_EQ(after([](Builder& b) {
                  const std::size_t i = b.json["meshes"][0]["primitives"][0]["indices"];
                  b.json["accessors"][i]["count"] = 27;
              }),
              place + ": has 8 triangles, its accessor has 27 indices");
    EXPECT_EQ(after([&](Builder& b) {
                  for (const char* name : {"POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0"}) {
                      accessor(b, name)["count"] = 5;
                  }
              }),
              place + ": has 9 vertices, its accessors have 5");
    EXPECT_EQ(after([&](Builder& b) { accessor(b, "NORMAL")["count"] = 8; }),
              place + ".attributes.NORMAL: has 9 elements, its accessor has 8");
    EXPECT_EQ(after([&](Builder& b) { accessor(b, "NORMAL")["type"] = "VEC2"; }),
              place + ".attributes.NORMAL: has 3 components, its accessor has 2");
    EXPECT_EQ(after([](Builder& b) { compression_of(b)["attributes"]["NORMAL"] = 77; }),
              place + ".attributes.NORMAL: the Draco data has no such attribute");
    EXPECT_EQ(after([](Builder& b) { b.json["meshes"][0]["primitives"][0]["mode"] = 0; }),
              "test.gltf: meshes[0].primitives[0]: Draco meshes must be of triangles");
}

// One to four of the bytes from `first` on are changed.
void mutate(Bytes& bytes, std::size_t first, std::mt19937& random)
{
    for (std::uint32_t k = 0; k < 1 + random() % 4; ++k) {
        bytes[first + random() % (bytes.size() - first)] = static_cast<std::uint8_t>(random());
    }
}

TEST(GltfDraco, MutatedDataIsReadOrRefused)
{
    std::mt19937 random(3);
    int refused = 0;
    for (const bool edgebreaker : {false, true}) {
        const Builder good = draco_file::compressed(draco_file::make_grid(6), edgebreaker);
        for (int i = 0; i < 2000; ++i) {
            Builder builder = good;
            mutate(builder.data, 9, random);  // behind magic number and version
            refused += fault_of(builder).empty() ? 0 : 1;
        }
    }
    EXPECT_GT(refused, 0);
    RecordProperty("refused", refused);
}

// A bufferView of count * stride bytes that stand compressed in another one's place.
std::size_t compressed_view(Builder& builder, const Bytes& compressed, const char* mode,
                            std::size_t count, std::size_t stride)
{
    const std::size_t source = builder.view(compressed);
    Json view = {{"buffer", 1}, {"byteLength", count * stride}};
    Json& compression = view["extensions"]["EXT_meshopt_compression"];
    compression = builder.json["bufferViews"][source];
    compression["mode"] = mode;
    compression["count"] = count;
    compression["byteStride"] = stride;
    builder.json["bufferViews"].push_back(view);
    return builder.json["bufferViews"].size() - 1;
}

Bytes encode_attributes(const void* data, std::size_t count, std::size_t stride)
{
    Bytes bytes(meshopt_encodeVertexBufferBound(count, stride));
    bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), data, count, stride));
    return bytes;
}

// `list` with a placeholder buffer besides, which has no data.
std::string with_fallback(const Builder& builder)
{
    Json json = parse_json(builder.text());
    json["buffers"].push_back(
        {{"byteLength", 1 << 20},
         {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
    json["extensionsRequired"] = {"EXT_meshopt_compression"};
    return json.dump();
}

Builder compressed_positions(int vertices)
{
    Builder builder = one_triangle();
    const std::vector<float> positions = curve(vertices);
    const auto count = static_cast<std::size_t>(vertices);
    builder.json["accessors"][0]["bufferView"] = compressed_view(
        builder, encode_attributes(positions.data(), count, 12), "ATTRIBUTES", count, 12);
    builder.json["accessors"][0]["count"] = count;
    return builder;
}

TEST(GltfMeshopt, ReadsAttributesAndIndices)
{
    const Indices order = {0, 1, 2, 2, 1, 3, 2, 3, 4};
    for (const bool sequence : {false, true}) {
        Builder builder = compressed_positions(5);
        Bytes bytes(sequence ? meshopt_encodeIndexSequenceBound(order.size(), 5)
                             : meshopt_encodeIndexBufferBound(order.size(), 5));
        const auto encode = [&](auto function) {
            bytes.resize(function(bytes.data(), bytes.size(), order.data(), order.size()));
        };
        using Encoder = std::size_t(unsigned char*, std::size_t, const unsigned*, std::size_t);
        encode(sequence ? static_cast<Encoder*>(meshopt_encodeIndexSequence)
                        : static_cast<Encoder*>(meshopt_encodeIndexBuffer));
        for (const std::size_t stride : {2u, 4u}) {
            builder.json["accessors"].push_back(
                {{"bufferView", compressed_view(builder, bytes, sequence ? "INDICES" : "TRIANGLES",
                                                order.size(), stride)},
                 {"componentType", stride == 2 ? 5123 : 5125},
                 {"type", "SCALAR"},
                 {"count", order.size()}});
            builder.json["meshes"][0]["primitives"][0]["indices"] =
                builder.json["accessors"].size() - 1;
            const Mesh mesh = read_text(with_fallback(builder)).meshes.at(0);
            EXPECT_EQ(mesh.positions[4], (Float3{4, 16, 0}));
            ASSERT_EQ(mesh.indices.size(), order.size());
            for (std::size_t i = 0; i < order.size(); i += 3) {
                // The codec of triangles may begin with another corner.
                std::array<std::uint32_t, 3> triangle;
                std::copy_n(&mesh.indices[i], 3, triangle.begin());
                const auto first = std::find(triangle.begin(), triangle.end(), order[i]);
                ASSERT_NE(first, triangle.end());
                std::rotate(triangle.begin(), first, triangle.end());
                EXPECT_TRUE(std::equal(triangle.begin(), triangle.end(), &order[i]));
            }
        }
    }
}

TEST(GltfMeshopt, Faults)
{
    const std::string place = "test.gltf: bufferViews[2].extensions.EXT_meshopt_compression";
    const auto after = [](auto change) {
        Builder builder = compressed_positions(32);
        change(builder, builder.json["bufferViews"][2]["extensions"]["EXT_meshopt_compression"]);
        return fault_of_text(with_fallback(builder));
    };
    EXPECT_EQ(after([](Builder&, Json&) {}), "");
    EXPECT_EQ(after([](Builder&, Json& c) { c["mode"] = "POINTS"; }),
              place + ".mode: must be ATTRIBUTES, TRIANGLES or INDICES");
    EXPECT_EQ(after([](Builder&, Json& c) { c["count"] = 31; }),
              place + ": 31 elements of 12 bytes are not the bufferView's 384 bytes");
    EXPECT_EQ(after([](Builder&, Json& c) { c["count"] = std::uint64_t{1} << 53; }),
              place + ": 9007199254740992 elements of 12 bytes are not the bufferView's 384 bytes");
    EXPECT_EQ(after([](Builder& b, Json& c) {
                  c["byteStride"] = 3;
                  c["count"] = 128;
                  b.json["accessors"][0]["count"] = 1;
              }),
              place + ".byteStride: is not one that this mode has");
    EXPECT_EQ(after([](Builder&, Json& c) { c["mode"] = "TRIANGLES"; }),
              place + ".byteStride: is not one that this mode has");
    EXPECT_EQ(after([](Builder&, Json& c) {
                  c["mode"] = "TRIANGLES";
                  c["byteStride"] = 4;
                  c["count"] = 96;
                  c["filter"] = "EXPONENTIAL";
              }),
              place + ".filter: must be NONE in this mode");
    EXPECT_EQ(after([](Builder& b, Json& c) {
                  b.json["bufferViews"][2]["byteLength"] = 380;
                  c["mode"] = "TRIANGLES";
                  c["byteStride"] = 4;
                  c["count"] = 95;
              }),
              place + ".count: must be divisible by 3");
    EXPECT_EQ(after([](Builder&, Json& c) { c["filter"] = "OCTAHEDRAL"; }),
              place + ".filter: there is no such filter of elements of 12 bytes");
    EXPECT_EQ(after([](Builder& b, Json& c) {
                  b.json["bufferViews"][2]["byteLength"] = 12 << 20;
                  c["count"] = 1 << 20;
                  c["byteLength"] = 100;
              }),
              place + ": 12582912 bytes cannot be in 100");
    EXPECT_EQ(after([](Builder&, Json& c) { c["byteLength"] = 40; }),
              place + ": the compressed data is broken");
    EXPECT_EQ(after([](Builder&, Json& c) { c["byteOffset"] = 1 << 20; }).rfind(place, 0), 0u);
}

TEST(GltfMeshopt, MutatedDataIsReadOrRefused)
{
    std::mt19937 random(4);
    const Builder good = compressed_positions(200);
    const std::size_t first = 36;  // behind what is not compressed
    int refused = 0;
    for (int i = 0; i < 2000; ++i) {
        Builder builder = good;
        mutate(builder.data, first, random);
        refused += fault_of_text(with_fallback(builder)).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 0);
    RecordProperty("refused", refused);
}

TEST(GltfMeshopt, PlainDataServesWhereThereIsNoCompression)
{
    Builder builder = one_triangle();
    builder.json["bufferViews"][0]["buffer"] = 1;
    Json json = parse_json(builder.text());
    json["buffers"].push_back({{"byteLength", 36}});
    EXPECT_EQ(fault_of_text(json.dump()),
              "test.gltf: buffers[1]: has no uri, and the file has no binary chunk for it");
    json["buffers"][1] = json["buffers"][0];
    EXPECT_EQ(fault_of_text(json.dump()), "");
}

template <class T>
std::array<T, 4> filtered(void (*filter)(std::span<std::uint8_t>), std::array<T, 4> element)
{
    std::array<std::uint8_t, sizeof element> bytes;
    std::memcpy(bytes.data(), element.data(), sizeof element);
    filter(bytes);
    std::memcpy(element.data(), bytes.data(), sizeof element);
    return element;
}

TEST(GltfMeshopt, OctahedralFilterGivesUnitVectors)
{
    const auto decode = [](std::span<std::uint8_t> bytes) {
        gltf::decode_octahedral(bytes, bytes.size());
    };
    using Wide = std::array<std::int16_t, 4>;
    EXPECT_EQ(filtered<std::int16_t>(decode, {0, 0, 511, 7}), (Wide{0, 0, 32767, 7}));
    EXPECT_EQ(filtered<std::int16_t>(decode, {511, 0, 511, 7}), (Wide{32767, 0, 0, 7}));
    // The corners of the square are the vector down.
    EXPECT_EQ(filtered<std::int16_t>(decode, {-511, 511, 511, 7}), (Wide{0, 0, -32767, 7}));
    // (1 1 1) / sqrt(3): a third of the way along both.
    const Wide third = filtered<std::int16_t>(decode, {1023, 1023, 3069, 0});
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(third[k], 32767 / std::sqrt(3.0), 0.51);
    using Narrow = std::array<std::int8_t, 4>;
    EXPECT_EQ(filtered<std::int8_t>(decode, {0, -127, 127, -1}), (Narrow{0, -127, 0, -1}));
    EXPECT_EQ(filtered<std::int8_t>(decode, {1, 1, 0, 3})[3], 3);  // invalid; not a crash
}

TEST(GltfMeshopt, QuaternionFilterGivesUnitQuaternions)
{
    using Element = std::array<std::int16_t, 4>;
    const auto decode = gltf::decode_quaternions;
    // 1 is 2047 of 12 bits; its last two bits tell where the largest component goes.
    EXPECT_EQ(filtered<std::int16_t>(decode, {0, 0, 0, 2044 | 3}), (Element{0, 0, 0, 32767}));
    EXPECT_EQ(filtered<std::int16_t>(decode, {0, 0, 0, 2044 | 1}), (Element{0, 32767, 0, 0}));
    // 2047 is 1 / sqrt(2): the component behind the largest one, which is as large.
    const Element half = filtered<std::int16_t>(decode, {2047, 0, 0, 2044 | 0});
    const double expected = 32767 * std::sqrt(0.5);
    EXPECT_NEAR(half[0], expected, 0.51);
    EXPECT_NEAR(half[1], expected, 0.51);
    EXPECT_EQ(half[2], 0);
    EXPECT_EQ(half[3], 0);
}

TEST(GltfMeshopt, ExponentialFilterGivesFloats)
{
    const auto decode = [](std::int32_t exponent, std::int32_t mantissa) {
        const std::uint32_t bits = static_cast<std::uint32_t>(exponent) << 24 |
                                   (static_cast<std::uint32_t>(mantissa) & 0xFFFFFFu);
        std::array<std::uint8_t, 4> bytes;
        std::memcpy(bytes.data(), &bits, 4);
        gltf::decode_exponential(bytes);
        float value = 0;
        std::memcpy(&value, bytes.data(), 4);
        return value;
    };
    EXPECT_EQ(decode(0, 5), 5.0f);
    EXPECT_EQ(decode(-3, -20), -2.5f);
    EXPECT_EQ(decode(100, 1), std::ldexp(1.0f, 100));
    EXPECT_EQ(decode(-100, 8388607), std::ldexp(8388607.0f, -100));
}

TEST(GltfMeshopt, FiltersAreApplied)
{
    Builder builder = one_triangle();
    // 1 of 8 bits is 127; all three normals look down the second coordinate.
    const std::vector<std::int8_t> normals = {0, 127, 127, 0, 0, 127, 127, 0, 0, 127, 127, 0};
    const std::size_t view =
        compressed_view(builder, encode_attributes(normals.data(), 3, 4), "ATTRIBUTES", 3, 4);
    Json& made = builder.json["bufferViews"][view];
    made["byteStride"] = 4;
    made["extensions"]["EXT_meshopt_compression"]["filter"] = "OCTAHEDRAL";
    builder.json["accessors"].push_back({{"bufferView", view},
                                         {"componentType", 5120},
                                         {"normalized", true},
                                         {"type", "VEC3"},
                                         {"count", 3}});
    builder.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 1;
    EXPECT_EQ(read_text(with_fallback(builder)).meshes.at(0).normals,
              (std::vector<Float3>(3, {0, 1, 0})));
}

}  // namespace
}  // namespace sheer::test
