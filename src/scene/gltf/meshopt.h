// Compressed buffer views: EXT_meshopt_compression.
#pragma once

#include <cstdint>
#include <span>

#include "scene/gltf/value.h"
#include "support/read_file.h"

namespace sheer::gltf {

// `value` is the extension's object on a buffer view, whose decompressed size is `length`.
Bytes decode_meshopt(const Value& value, std::span<const std::uint8_t> compressed,
                     std::uint64_t length);

}  // namespace sheer::gltf
