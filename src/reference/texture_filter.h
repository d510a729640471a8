// A texture's value at a point of the screen: docs/numerics.md, "Level" and "Wrapping".
#pragma once

#include <array>
#include <cstdint>

#include <sheer/scene.h>

#include "reference/mipmap.h"

namespace sheer::reference {

// Texture coordinates at a point and their change for one pixel to the right and down.
struct Footprint {
    std::array<double, 2> at, per_x, per_y;
};

// Texture::transform applied to all of it.
Footprint transformed(const std::array<float, 6>& transform, const Footprint& footprint);

struct Filtered {
    Texel texel = {0, 0, 0, 0};
    std::uint8_t discontinuities = 0;  // kNearestTexel, kProbeCount
};

// Anisotropic probes, levels and texels as the sampler has them: docs/numerics.md, "Level". The
// footprint is finite.
Filtered filter_texture(const MipChain& chain, const Sampler& sampler, const Footprint& footprint);

}  // namespace sheer::reference
