// Buffers and buffer views (glTF 2.0, section 3.6.1).
//
// A buffer that is shorter than it says is used as far as it goes: whoever reads an element checks
// that the element is there.

#include "scene/gltf/buffers.h"

#include <algorithm>

#include "scene/gltf/uri.h"

namespace sheer::gltf {

namespace {

constexpr std::uint64_t kMaxStride = 252;

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
        if (!files_.contains(path)) files_[path] = read_referenced_file(*uri, path);
        bytes = files_[path];
    }
    if (bytes.size() < declared)
        notes.add("buffers shorter than declared", "used as far as they go");
    bytes = bytes.first(static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), declared)));
    contents_[index] = bytes;
    return bytes;
}

BufferView Buffers::view(const Document& document, const Value& reference, Notes& notes)
{
    const Value view = document.item("bufferViews", reference);
    const Value buffer_reference = view.member("buffer");
    const std::size_t index = document.index_in("buffers", buffer_reference);
    const std::uint64_t buffer_length =
        document.item("buffers", index).member("byteLength").whole();
    const std::uint64_t offset = whole_or(view, "byteOffset", 0);
    BufferView result;
    result.length = view.member("byteLength").whole();
    if (offset + result.length > buffer_length) {
        view.fail("byteOffset " + std::to_string(offset) + " and byteLength " +
                  std::to_string(result.length) + " reach past the " +
                  std::to_string(buffer_length) + " bytes of buffers[" + std::to_string(index) +
                  "]");
    }
    result.stride = whole_or(view, "byteStride", 0);
    if (view.find("byteStride") && (result.stride == 0 || result.stride > kMaxStride)) {
        view.member("byteStride").fail("must be from 4 to 252");
    }
    const std::span<const std::uint8_t> bytes = content(document, index, notes);
    if (offset < bytes.size()) {
        const std::uint64_t there = std::min<std::uint64_t>(result.length, bytes.size() - offset);
        result.bytes =
            bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(there));
    }
    return result;
}

}  // namespace sheer::gltf
