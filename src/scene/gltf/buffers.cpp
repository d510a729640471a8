// Buffers and buffer views (glTF 2.0, section 3.6.1).
//
// A buffer that is shorter than it says is used as far as it goes: whoever reads an element checks
// that the element is there.

#include "scene/gltf/buffers.h"

#include <algorithm>
#include <filesystem>

#include "scene/gltf/meshopt.h"
#include "scene/gltf/uri.h"

namespace sheer::gltf {

namespace {

constexpr std::uint64_t kMaxStride = 252;
constexpr std::uint64_t kMaxDecompressed = std::uint64_t{1} << 32;

}  // namespace

std::span<const std::uint8_t> Buffers::content(const Document& document, std::size_t index,
                                               Notes& notes)
{
    if (const auto known = contents_.find(index); known != contents_.end()) return known->second;
    const Value buffer = document.item("buffers", index);
    const std::uint64_t declared = buffer.member("byteLength").whole();
    std::span<const std::uint8_t> bytes;
    if (const auto uri = buffer.find("uri"); !uri) {
        if (index != 0 || !document.binary()) {
            buffer.fail("has no uri, and the file has no binary chunk for it");
        }
        bytes = *document.binary();
    } else if (is_data_uri(uri->text())) {
        bytes = decoded_[index] = decode_data_uri(*uri);
    } else {
        const std::string path = path_of_uri(*uri, document.path(), files_anywhere_);
        // However often and by whatever names, it is read once.
        std::error_code fault;
        std::string place = std::filesystem::weakly_canonical(path, fault).string();
        if (fault) place = path;
        if (!files_.contains(place)) files_[place] = read_referenced_file(*uri, path);
        bytes = files_[place];
    }
    if (bytes.size() < declared)
        notes.add("buffers shorter than declared", "used as far as they go");
    bytes = bytes.first(static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), declared)));
    contents_[index] = bytes;
    return bytes;
}

// The bytes that the members buffer, byteOffset and byteLength of `owner` tell.
BufferView Buffers::range(const Document& document, const Value& owner, Notes& notes)
{
    const Value buffer_reference = owner.member("buffer");
    const std::size_t index = document.index_in("buffers", buffer_reference);
    const std::uint64_t buffer_length =
        document.item("buffers", index).member("byteLength").whole();
    const std::uint64_t offset = whole_or(owner, "byteOffset", 0);
    BufferView result;
    result.length = owner.member("byteLength").whole();
    if (offset + result.length > buffer_length) {
        owner.fail("byteOffset " + std::to_string(offset) + " and byteLength " +
                   std::to_string(result.length) + " reach past the " +
                   std::to_string(buffer_length) + " bytes of buffers[" + std::to_string(index) +
                   "]");
    }
    const std::span<const std::uint8_t> bytes = content(document, index, notes);
    if (offset < bytes.size()) {
        const std::uint64_t there = std::min<std::uint64_t>(result.length, bytes.size() - offset);
        result.bytes =
            bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(there));
    }
    return result;
}

// The view's own buffer need not have any data then.
BufferView Buffers::decompressed(const Document& document, const Value& view,
                                 const Value& compression, Notes& notes)
{
    const std::uint64_t length = view.member("byteLength").whole();
    if (!decompressed_.contains(view.where())) {
        const BufferView compressed = range(document, compression, notes);
        if (compressed.bytes.size() < compressed.length) {
            compression.fail("its data is missing, the buffer is cut off");
        }
        decompressed_bytes_ += std::min(length, kMaxDecompressed + 1);
        if (decompressed_bytes_ > kMaxDecompressed) {
            compression.fail("more compressed data than Sheer reads (2^32 bytes)");
        }
        decompressed_[view.where()] = decode_meshopt(compression, compressed.bytes, length);
    }
    return {.bytes = decompressed_[view.where()], .length = length};
}

BufferView Buffers::view(const Document& document, const Value& reference, Notes& notes)
{
    const Value view = document.item("bufferViews", reference);
    const auto compression = extension(view, "EXT_meshopt_compression");
    BufferView result = compression ? decompressed(document, view, *compression, notes)
                                    : range(document, view, notes);
    result.stride = whole_or(view, "byteStride", 0);
    if (view.find("byteStride") && (result.stride == 0 || result.stride > kMaxStride)) {
        view.member("byteStride").fail("must be from 4 to 252");
    }
    return result;
}

}  // namespace sheer::gltf
