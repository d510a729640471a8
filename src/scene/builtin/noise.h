// Smooth random fields over space.
#pragma once

#include "scene/builtin/shapes.h"

namespace sheer {

// Gradient noise (Perlin. Improving Noise. SIGGRAPH 2002), gradients from a hash: in (-1.1, 1.1), 0
// at whole coordinates, features about one unit across. |coordinates| < 2^31.
double noise(shapes::Vec p);

// Octaves of noise, each of half the size and half the strength of the one before; the first counts
// whole.
double fractal_noise(shapes::Vec p, int octaves);

}  // namespace sheer
