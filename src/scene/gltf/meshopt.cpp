// EXT_meshopt_compression. The three codecs are those of the meshoptimizer library, which checks
// what it reads; the filters are in a file of their own beside this one.

#include "scene/gltf/meshopt.h"

#include <string_view>

#include <meshoptimizer.h>

#include "scene/gltf/meshopt_filters.h"

namespace sheer::gltf {

namespace {

// A byte of an attribute stream's heads stands for four groups of 16 bytes; the other codecs'
// output is smaller still.
constexpr std::uint64_t kMostOfAByte = 64;

enum class Codec { attributes, triangles, indices };

Codec read_codec(const Value& mode)
{
    if (mode.text() == "ATTRIBUTES") return Codec::attributes;
    if (mode.text() == "TRIANGLES") return Codec::triangles;
    if (mode.text() == "INDICES") return Codec::indices;
    mode.fail("must be ATTRIBUTES, TRIANGLES or INDICES");
}

struct Layout {
    Codec codec;
    std::size_t count;
    std::size_t stride;
    std::string_view filter;
};

void check_stride(const Value& value, const Layout& layout)
{
    const std::size_t stride = layout.stride;
    const bool is_good = layout.codec == Codec::attributes
                             ? stride >= 4 && stride <= 256 && stride % 4 == 0
                             : stride == 2 || stride == 4;
    if (!is_good) value.member("byteStride").fail("is not one that this mode has");
    if (layout.codec == Codec::triangles && layout.count % 3 != 0) {
        value.member("count").fail("must be divisible by 3");
    }
}

void check_filter(const Value& value, const Layout& layout)
{
    if (layout.filter == "NONE") return;
    const Value filter = value.member("filter");
    if (layout.codec != Codec::attributes) filter.fail("must be NONE in this mode");
    const std::size_t stride = layout.stride;
    const bool fits = layout.filter == "OCTAHEDRAL"    ? stride == 4 || stride == 8
                      : layout.filter == "QUATERNION"  ? stride == 8
                      : layout.filter == "EXPONENTIAL" ? stride % 4 == 0
                                                       : false;
    if (!fits)
        filter.fail("there is no such filter of elements of " + std::to_string(stride) + " bytes");
}

Layout read_layout(const Value& value, std::size_t compressed, std::uint64_t length)
{
    const std::uint64_t count = value.member("count").whole();
    const std::uint64_t stride = value.member("byteStride").whole();
    if (stride > 256) value.member("byteStride").fail("is not one that this mode has");
    if (count > length || count * stride != length) {
        value.fail(std::to_string(count) + " elements of " + std::to_string(stride) +
                   " bytes are not the bufferView's " + std::to_string(length) + " bytes");
    }
    if (length > kMostOfAByte * compressed) {
        value.fail(std::to_string(length) + " bytes cannot be in " + std::to_string(compressed));
    }
    Layout layout = {read_codec(value.member("mode")), static_cast<std::size_t>(count),
                     static_cast<std::size_t>(stride), "NONE"};
    if (const auto filter = value.find("filter")) layout.filter = filter->text();
    check_stride(value, layout);
    check_filter(value, layout);
    return layout;
}

bool decode(const Layout& layout, std::span<const std::uint8_t> from, Bytes& to)
{
    const std::size_t count = layout.count, stride = layout.stride;
    int fault = 0;
    switch (layout.codec) {
        case Codec::attributes:
            fault = meshopt_decodeVertexBuffer(to.data(), count, stride, from.data(), from.size());
            break;
        case Codec::triangles:
            fault = meshopt_decodeIndexBuffer(to.data(), count, stride, from.data(), from.size());
            break;
        case Codec::indices:
            fault = meshopt_decodeIndexSequence(to.data(), count, stride, from.data(), from.size());
            break;
    }
    return fault == 0;
}

void apply_filter(const Layout& layout, Bytes& bytes)
{
    if (layout.filter == "EXPONENTIAL") {
        decode_exponential(bytes);
    } else if (layout.filter == "QUATERNION") {
        decode_quaternions(bytes);
    } else if (layout.filter == "OCTAHEDRAL") {
        decode_octahedral(bytes, layout.stride);
    }
}

}  // namespace

Bytes decode_meshopt(const Value& value, std::span<const std::uint8_t> compressed,
                     std::uint64_t length)
{
    const Layout layout = read_layout(value, compressed.size(), length);
    Bytes bytes(static_cast<std::size_t>(length));
    if (bytes.empty()) return bytes;
    if (!decode(layout, compressed, bytes)) value.fail("the compressed data is broken");
    apply_filter(layout, bytes);
    return bytes;
}

}  // namespace sheer::gltf
