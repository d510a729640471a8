// Which surfaces are transparent, whatever the textures on them say.
#pragma once

#include <sheer/scene.h>

namespace sheer {

// Coloured glass. Of transmission only Shading::metallic_roughness knows.
inline bool is_glass(const Material& material)
{
    return material.shading == Shading::metallic_roughness && material.transmission > 0;
}

// Goes to the methods; else it is drawn first, opaque where it is not absent.
inline bool is_transparent(const Material& material, const Object& object)
{
    return material.alpha_mode == AlphaMode::blend || is_glass(material) || object.opacity < 1;
}

}  // namespace sheer
