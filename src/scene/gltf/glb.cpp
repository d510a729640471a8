// The GLB container (glTF 2.0, section 4): a 12-byte header and chunks of length, type and data,
// all little-endian. The first chunk is the JSON, the second may be the binary buffer.
//
// More lenient than the text: chunks need not be padded to 4 bytes, and bytes after the declared
// length are not looked at.

#include "scene/gltf/document.h"

#include <sheer/error.h>

namespace sheer::gltf {

namespace {

constexpr std::uint32_t kMagic = 0x46546C67;        // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN"
constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;

std::uint32_t u32_at(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[at + 2]) << 16 |
           static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

[[noreturn]] void fail(const std::string& path, const std::string& what)
{
    throw Error(Fault::input, path + ": GLB: " + what);
}

struct Chunk {
    std::uint32_t type;
    std::span<const std::uint8_t> data;
};

// Takes the first chunk off `rest`.
Chunk take_chunk(const std::string& path, std::span<const std::uint8_t>& rest)
{
    if (rest.size() < kChunkHeaderSize) fail(path, "a chunk's header is cut off");
    const std::size_t length = u32_at(rest, 0);
    if (length > rest.size() - kChunkHeaderSize) {
        fail(path, "a chunk of " + std::to_string(length) + " bytes reaches past the end");
    }
    const Chunk chunk = {u32_at(rest, 4), rest.subspan(kChunkHeaderSize, length)};
    rest = rest.subspan(kChunkHeaderSize + length);
    return chunk;
}

}  // namespace

bool is_glb(std::span<const std::uint8_t> content)
{
    return content.size() >= 4 && u32_at(content, 0) == kMagic;
}

Container split_glb(const std::string& path, std::span<const std::uint8_t> content)
{
    if (content.size() < kHeaderSize) fail(path, "the header is cut off");
    const std::uint32_t version = u32_at(content, 4);
    if (version != 2) {
        fail(path, "version " + std::to_string(version) + " is not supported, only glTF 2.0 is");
    }
    const std::size_t length = u32_at(content, 8);
    if (length < kHeaderSize) fail(path, "the declared length is shorter than the header");
    if (length > content.size()) {
        fail(path, "cut off: " + std::to_string(length) + " bytes are declared, " +
                       std::to_string(content.size()) + " are there");
    }
    std::span<const std::uint8_t> rest = content.subspan(kHeaderSize, length - kHeaderSize);
    const Chunk json = take_chunk(path, rest);
    if (json.type != kJsonChunk) fail(path, "the first chunk is not JSON");
    Container container = {json.data, std::nullopt};
    if (!rest.empty()) {
        const Chunk second = take_chunk(path, rest);
        if (second.type == kBinaryChunk) container.binary = second.data;
    }
    return container;
}

}  // namespace sheer::gltf
