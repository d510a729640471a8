// glTF 2.0 scenes, as .gltf with its files beside it or as one .glb.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <sheer/scene.h>

#include "image/decode_texture.h"
#include "support/read_file.h"

namespace sheer {

struct GltfOptions {
    // Of a file with several scenes: a name, or a number counted from 0. Unset: the file's choice.
    std::optional<std::string> scene = std::nullopt;
    // Buffers and images may lie outside of the folder of the file that names them.
    bool files_anywhere = false;
    TextureLimits each_image = {};
    std::uint64_t most_texels = std::uint64_t{1} << 29;  // of all images: two gibibytes
};

// Throws Error with Fault::input, "<path>: <where in the file>: <what is wrong>", in one line. What
// is found and not drawn is told in Scene::ignored.
Scene read_gltf(const std::string& path, const GltfOptions& options = {});

// The same from a file's content; `path` is for messages and for the files it names.
Scene read_gltf(const std::string& path, Bytes content, const GltfOptions& options = {});

}  // namespace sheer
