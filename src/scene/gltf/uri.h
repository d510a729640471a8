// The addresses that a glTF file gives for its buffers and images.
#pragma once

#include <string>
#include <string_view>

#include "scene/gltf/value.h"
#include "support/read_file.h"

namespace sheer::gltf {

bool is_data_uri(std::string_view uri);

// The bytes inside a data URI.
Bytes decode_data_uri(const Value& uri);

// The path of the file that a relative or absolute reference means, seen from the file at `base`.
// Fails for addresses with a scheme: nothing is fetched from anywhere. Fails, too, for files
// outside of the folder of `base`, unless they may be `anywhere`; links count for where they lead.
std::string path_of_uri(const Value& uri, const std::string& base, bool anywhere);

// read_file, with the complaint told as one about `uri`.
Bytes read_referenced_file(const Value& uri, const std::string& path);

}  // namespace sheer::gltf
