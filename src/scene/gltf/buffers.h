// The binary data behind a glTF file, brought into memory when something first needs it.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "scene/gltf/document.h"
#include "scene/notes.h"
#include "support/read_file.h"

namespace sheer::gltf {

struct BufferView {
    std::span<const std::uint8_t> bytes;  // what is there; less than `length` of a damaged buffer
    std::uint64_t length = 0;             // as declared
    std::uint64_t stride = 0;             // 0: elements follow each other
};

class Buffers {
public:
    // Whether buffers may lie outside of the folder of the file that names them.
    explicit Buffers(bool files_anywhere) : files_anywhere_(files_anywhere) {}

    // `reference` is the place that holds the bufferView's number.
    BufferView view(const Document& document, const Value& reference, Notes& notes);

private:
    BufferView range(const Document& document, const Value& owner, Notes& notes);
    BufferView decompressed(const Document& document, const Value& view, const Value& compression,
                            Notes& notes);
    std::span<const std::uint8_t> content(const Document& document, std::size_t index,
                                          Notes& notes);

    bool files_anywhere_;
    std::map<std::size_t, std::span<const std::uint8_t>> contents_;  // by buffer, cut to its length
    std::map<std::size_t, Bytes> decoded_;                           // by buffer, from data URIs
    std::map<std::string, Bytes> decompressed_;                      // by the place of the view
    std::uint64_t decompressed_bytes_ = 0;
    std::map<std::string, Bytes> files_;  // by path: several buffers may name one file
};

}  // namespace sheer::gltf
