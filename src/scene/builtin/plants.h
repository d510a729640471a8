// Small plants made of bent cards.
#pragma once

#include <sheer/scene.h>

#include "scene/builtin/draws.h"
#include "scene/builtin/shapes.h"

namespace sheer {

// A strip that rises from `foot` along `up` and bends over towards `lean`, `rows` quads long. Its
// image's bottom edge is at the foot.
struct BentCard {
    shapes::Vec foot;
    shapes::Vec up = {0, 1, 0};
    shapes::Vec lean;    // how far the tip is off, as parts of the length
    shapes::Vec across;  // half the way from one side to the other at the foot, metres
    double length = 1;
    int rows = 3;
    shapes::Vec color = {1, 1, 1};
    double foot_shade = 0.45;  // of the colour at the foot; 1 at the tip
    // Mixed into the shading normals where it does not turn them round; zero: none.
    shapes::Vec normal = {};
};

void add_bent_card(Mesh& mesh, const BentCard& card);

// Fronds that arch out of one point.
void add_fern(Mesh& mesh, shapes::Vec foot, double size, Draws& draws);

// `cards` cards of grass at random turns about one point, blown over by `wind` (parts of a length).
void add_grass(Mesh& mesh, shapes::Vec foot, double size, int cards, shapes::Vec wind,
               Draws& draws);

}  // namespace sheer
