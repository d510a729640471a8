// What MTL files say of materials, before anything is made of it.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <sheer/scene.h>

#include "scene/notes.h"
#include "support/read_file.h"

namespace sheer::obj {

// An image and where it lies; v goes up.
struct Map {
    std::string file;
    Float2 scale = {1, 1}, offset = {0, 0};
    bool clamp = false;
};

struct MtlMaterial {
    std::optional<Float3> kd, ks, ke;  // diffuse, sharply reflected, emitted
    std::optional<float> d, tr;        // opacity, and its opposite
    std::optional<float> ns;           // Blinn and Phong's exponent
    std::optional<float> pm, pr;       // metallic, roughness
    std::optional<Map> map_kd, map_d, map_ke, norm;
    std::shared_ptr<const std::string> path;  // of the file that says it
};

using Library = std::map<std::string, MtlMaterial, std::less<>>;  // by name

// Adds a file's materials. Throws Error with Fault::input, "<path>: line <n>: <what>".
void read_mtl(const std::string& path, const Bytes& content, Library& library, Notes& notes);

}  // namespace sheer::obj
