// Materials, as far as Sheer has a word for what they say.
#pragma once

#include <cstdint>
#include <string>

#include "scene/gltf/import.h"

namespace sheer::gltf {

// All of the file's materials, in its order.
void read_materials(Import& import);

// The number in Scene::materials of the primitive's material, or of glTF's default one.
std::uint32_t material_of(Import& import, const Value& primitive);

// That of a mesh of lines or points, which is lit only where it has normals and bumpy only where it
// has tangents: `material`, or a copy of it that is unlit or without normal texture.
std::uint32_t material_of_line(Import& import, const Mesh& mesh, std::uint32_t material);

// Notes the extensions of `owner`, one of the file's `things`, that are not supported.
void note_extensions(Import& import, const Value& owner, const std::string& things);

}  // namespace sheer::gltf
