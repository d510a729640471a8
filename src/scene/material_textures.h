// The textures of a material, for what goes over all of them.
#pragma once

#include <array>
#include <optional>

#include <sheer/scene.h>

namespace sheer {

inline constexpr std::array<std::optional<Texture> Material::*, 5> kMaterialTextures = {
    &Material::base_color_texture, &Material::metallic_roughness_texture, &Material::normal_texture,
    &Material::emission_texture,   &Material::transmission_texture,
};

}  // namespace sheer
