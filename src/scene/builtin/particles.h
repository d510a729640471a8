// Smoke and fire as textured squares that face one point, the scene's camera.
#pragma once

#include <sheer/scene.h>

#include "scene/builtin/draws.h"
#include "scene/builtin/paint.h"
#include "scene/builtin/shapes.h"

namespace sheer {

// White, four puffs of different shapes; `softness` in (0, 1]: the part of the radius over which
// the edge fades.
TextureImage make_puffs(double softness);

struct Puff {
    shapes::Vec center;
    double radius = 1;
    Paint paint;
    // Where the surface of the whole faces; the puff's own roundness is added. Unit length or zero.
    shapes::Vec outward = {};
};

// A square around the puff at right angles to the view from `eye`, turned by chance.
void add_puff(Mesh& mesh, const Puff& puff, shapes::Vec eye, Draws& draws);

// Blended, coloured by puffs of that softness.
std::uint32_t add_puff_material(Scene& scene, double softness, Shading shading);

// Noise in three directions: moves points as turbulence does.
shapes::Vec swirl(shapes::Vec p, int octaves);

}  // namespace sheer
