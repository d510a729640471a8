// A pixel of layers for functions of depth: what each of them takes for the transmittance.
#pragma once

#include <cstdint>
#include <vector>

#include "compare/pixel_fragments.h"
#include "support/random.h"

namespace sheer {

// Places are from -1 to 1, over which the methods' depth goes.
struct Layer {
    double place, opacity;
};
using Layers = std::vector<Layer>;

// Optical depths vary by a factor of three and add up to that of all, which let a tenth through.
void set_opacities(const CounterRandom& random, Layers& layers);

// Anywhere, with such opacities; in no order.
Layers random_layers(int count, std::uint64_t trial);

// Seen straight on by an eye without perspective, from 2 to 4 m, between which floats are equally
// far apart: a place is a depth of 3 m more.
PixelFragments pixel_of(const Layers& layers);

// Of each fragment, in their order.
std::vector<float> own_depths(const PixelFragments& pixel);

}  // namespace sheer
