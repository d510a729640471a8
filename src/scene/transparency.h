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

// Whether that goes to a method, which may test what is MASK itself.
inline bool makes_fragments(const Material& material, const Object& object, bool tests_masks)
{
    return is_transparent(material, object) ||
           (tests_masks && material.alpha_mode == AlphaMode::mask);
}

}  // namespace sheer
