// Draco meshes, by Google's library. Its decoder trusts the numbers of triangles and vertices in
// the stream's head when it asks for memory, so those are compared with the accessors' first.
//
// Draco Bitstream Specification, version 2.2, which is the one that glTF allows.
// https://google.github.io/draco/spec/

#include "scene/gltf/draco.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>
#include <stdexcept>

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

namespace sheer::gltf {

namespace {

static_assert(std::endian::native == std::endian::little, "accessors' bytes are little-endian");

constexpr std::string_view kExtension = "KHR_draco_mesh_compression";
// Regular meshes take far less than a bit for a triangle, but only small ones are that regular.
constexpr std::uint64_t kTrianglesOfAnySize = std::uint64_t{1} << 20;
constexpr std::uint64_t kTrianglesOfAByte = 64;

struct Stream {
    Value value;  // the extension's object, for complaints
    std::span<const std::uint8_t> bytes;

    draco::DecoderBuffer buffer() const
    {
        draco::DecoderBuffer result;
        result.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        return result;
    }
};

Stream open_stream(Import& import, const Value& value)
{
    const Value reference = value.member("bufferView");
    const BufferView view = import.buffers.view(import.document, reference, import.notes);
    if (view.bytes.size() < view.length)
        reference.fail("its data is missing, the buffer is cut off");
    return {value, view.bytes};
}

struct Counts {
    std::uint32_t triangles = 0;
    std::uint32_t vertices = 0;  // at most; attributes that differ at a vertex make it several
};

Counts read_counts(const Stream& stream)
{
    draco::DecoderBuffer buffer = stream.buffer();
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) {
        stream.value.fail("the data is not Draco's");
    }
    if (header.version_major != 2 || header.version_minor != 2) {
        stream.value.fail("Draco bitstream " + std::to_string(header.version_major) + "." +
                          std::to_string(header.version_minor) + " is not supported, only 2.2 is");
    }
    if (header.encoder_type != draco::TRIANGULAR_MESH) stream.value.fail("the data is no mesh");
    buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(2, 2));
    Counts counts;
    draco::GeometryMetadata metadata;
    std::uint8_t traversal = 0;
    bool good = true;
    if ((header.flags & METADATA_FLAG_MASK) != 0) {
        good = draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata);
    }
    if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
        good = good && buffer.Decode(&traversal) &&
               draco::DecodeVarint(&counts.vertices, &buffer) &&
               draco::DecodeVarint(&counts.triangles, &buffer);
    } else {
        good = good && draco::DecodeVarint(&counts.triangles, &buffer) &&
               draco::DecodeVarint(&counts.vertices, &buffer);
    }
    if (!good) stream.value.fail("the Draco data is cut off");
    return counts;
}

struct Expected {
    std::optional<std::uint64_t> indices;
    std::uint64_t vertices = 0;
};

void check_counts(Import& import, const Stream& stream, const Expected& expected)
{
    const Counts counts = read_counts(stream);
    // Of those that are compared with an accessor its elements are counted.
    if (!expected.indices) {
        count_elements(import, stream.value, std::uint64_t{counts.triangles} * 3);
    }
    const std::uint64_t most =
        std::max(kTrianglesOfAnySize, kTrianglesOfAByte * stream.bytes.size());
    if (counts.triangles > most) {
        stream.value.fail(std::to_string(counts.triangles) + " triangles cannot be in " +
                          std::to_string(stream.bytes.size()) + " bytes");
    }
    if (expected.indices && *expected.indices != std::uint64_t{counts.triangles} * 3) {
        stream.value.fail("has " + std::to_string(counts.triangles) +
                          " triangles, its accessor has " + std::to_string(*expected.indices) +
                          " indices");
    }
    if (counts.vertices > expected.vertices) {
        stream.value.fail("has " + std::to_string(counts.vertices) +
                          " vertices, its accessors have " + std::to_string(expected.vertices));
    }
}

std::unique_ptr<draco::Mesh> decode(const Stream& stream)
{
    try {
        draco::DecoderBuffer buffer = stream.buffer();
        auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
        if (mesh.ok()) return std::move(mesh).value();
    } catch (const std::length_error&) {  // of a vector, where a count in the data is absurd
    }
    stream.value.fail("the Draco data is broken");
}

// The attribute's values, one for each vertex, as an accessor would have them.
template <class T>
bool copy_values(const draco::PointAttribute& attribute, const Accessor& accessor, Bytes& bytes)
{
    std::array<T, 16> values;
    const std::size_t size = accessor.width * sizeof(T);
    bytes.resize(accessor.count * size);
    for (std::size_t i = 0; i < accessor.count; ++i) {
        const auto vertex = draco::PointIndex(static_cast<std::uint32_t>(i));
        const draco::AttributeValueIndex index = attribute.mapped_index(vertex);
        const auto width = static_cast<std::int8_t>(accessor.width);
        if (index.value() >= attribute.size() ||
            !attribute.ConvertValue<T>(index, width, values.data())) {
            return false;
        }
        std::memcpy(&bytes[i * size], values.data(), size);
    }
    return true;
}

bool copy_values(const draco::PointAttribute& attribute, const Accessor& accessor, Bytes& bytes)
{
    switch (accessor.component) {
        case ComponentType::int8: return copy_values<std::int8_t>(attribute, accessor, bytes);
        case ComponentType::uint8: return copy_values<std::uint8_t>(attribute, accessor, bytes);
        case ComponentType::int16: return copy_values<std::int16_t>(attribute, accessor, bytes);
        case ComponentType::uint16: return copy_values<std::uint16_t>(attribute, accessor, bytes);
        case ComponentType::uint32: return copy_values<std::uint32_t>(attribute, accessor, bytes);
        case ComponentType::float32: break;
    }
    return copy_values<float>(attribute, accessor, bytes);
}

DracoAttribute take_attribute(const draco::Mesh& mesh, const Value& id, const Accessor& described)
{
    const auto number = static_cast<std::uint32_t>(std::min<std::uint64_t>(id.whole(), ~0u));
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(number);
    if (attribute == nullptr) id.fail("the Draco data has no such attribute");
    if (mesh.num_points() != described.count) {
        id.fail("has " + std::to_string(mesh.num_points()) + " elements, its accessor has " +
                std::to_string(described.count));
    }
    if (static_cast<std::size_t>(attribute->num_components()) != described.width) {
        id.fail("has " + std::to_string(attribute->num_components()) +
                " components, its accessor has " + std::to_string(described.width));
    }
    DracoAttribute result{{}, described};
    if (!copy_values(*attribute, described, result.bytes)) {
        id.fail("its values are not of the accessor's type");
    }
    if (described.count > 0) {
        result.accessor.elements = {result.bytes.data(), result.bytes.size() / described.count};
    }
    return result;
}

std::vector<std::uint32_t> take_indices(const Stream& stream, const draco::Mesh& mesh)
{
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t{3} * mesh.num_faces());
    for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face) {
        for (const draco::PointIndex& vertex : mesh.face(face)) {
            if (vertex.value() >= mesh.num_points()) stream.value.fail("the Draco data is broken");
            indices.push_back(vertex.value());
        }
    }
    return indices;
}

}  // namespace

std::optional<DracoMesh> decode_draco(Import& import, const Value& primitive)
{
    const auto value = extension(primitive, kExtension);
    if (!value) return std::nullopt;
    const Stream stream = open_stream(import, *value);
    const Value ids = value->member("attributes");
    const Value references = primitive.member("attributes");
    std::map<std::string, Accessor> described;
    for (const std::string& name : ids.keys()) {
        described.emplace(name, describe_accessor(import, references.member(name)));
    }
    Expected expected;
    if (const auto indices = primitive.find("indices")) {
        // Strips are lists in Draco.
        const bool is_list = whole_or(primitive, "mode", 4) == 4;
        const Accessor accessor = describe_accessor(import, *indices);
        if (is_list) expected.indices = accessor.count;
    }
    for (const auto& [name, accessor] : described) {
        expected.vertices = std::max<std::uint64_t>(expected.vertices, accessor.count);
    }
    check_counts(import, stream, expected);
    const std::unique_ptr<draco::Mesh> mesh = decode(stream);
    DracoMesh result{take_indices(stream, *mesh), {}};
    for (const auto& [name, accessor] : described) {
        result.attributes.emplace(name, take_attribute(*mesh, ids.member(name), accessor));
    }
    return result;
}

}  // namespace sheer::gltf
