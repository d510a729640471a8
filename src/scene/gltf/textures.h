// How a material uses an image: texture, sampler, coordinates.
#pragma once

#include <optional>
#include <string_view>

#include "scene/gltf/import.h"

namespace sheer::gltf {

// The member `key` of a part of a material. Texture::image is the number in the file's list of
// images until `load_images` (images.h) puts the scene's there. Nothing where there is no such
// texture, or where it is noted as one that is not drawn.
std::optional<Texture> read_texture(Import& import, const Value& owner, std::string_view key);

}  // namespace sheer::gltf
