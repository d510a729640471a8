// What the parts of the reader share while one file is read.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include <sheer/scene.h>

#include "scene/gltf/buffers.h"
#include "scene/gltf/document.h"
#include "scene/gltf/notes.h"

namespace sheer::gltf {

struct Import {
    Document document;
    Buffers buffers = {};
    Notes notes = {};
    // Elements read so far, in all and of accessors that have no data in the file: a few bytes can
    // ask for any number of them.
    std::uint64_t elements = 0;
    std::uint64_t elements_without_data = 0;
    std::optional<std::uint32_t> default_material = {};  // in Scene::materials, once it is needed
    // Of lit materials that lines and points without normals use, by the material's number.
    std::map<std::uint32_t, std::uint32_t> unlit_copies = {};
    Scene scene = {};
};

}  // namespace sheer::gltf
