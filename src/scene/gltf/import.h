// What the parts of the reader share while one file is read.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <sheer/scene.h>

#include "scene/gltf.h"
#include "scene/gltf/animation.h"
#include "scene/gltf/buffers.h"
#include "scene/gltf/document.h"
#include "scene/notes.h"

namespace sheer::gltf {

struct Import {
    Document document;
    LoadOptions options = {};
    Buffers buffers{options.allow_any_file};
    Notes notes = {};
    // Elements read so far, in all and of accessors that have no data in the file: a few bytes can
    // ask for any number of them.
    std::uint64_t elements = 0;
    std::uint64_t elements_without_data = 0;
    std::uint64_t texels = 0;                            // decoded so far
    std::optional<std::uint32_t> default_material = {};  // in Scene::materials, once it is needed
    // Copies of materials for lines and points: by the material, and whether the copy is unlit.
    std::map<std::pair<std::uint32_t, bool>, std::uint32_t> line_materials = {};
    // Meshes in the base shape, by their primitives' JSON without the material.
    std::map<std::string, std::uint32_t> base_meshes = {};
    Poses poses = {};  // once they are read
    Scene scene = {};
};

}  // namespace sheer::gltf
