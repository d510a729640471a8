// Where on a triangle a fragment is shaded: what its vertices count for there, how that changes
// across the screen, and which place in the world it is.
#pragma once

#include "geometry/triangles.h"
#include "reference/fragments.h"
#include "reference/vector.h"

namespace sheer::reference {

// What the vertices' attributes count for, perspective-correct.
struct Interpolation {
    Weights at;            // their sum is 1
    Weights per_x, per_y;  // the change for one pixel to the right and down; their sums are 0
};

// From affine weights: docs/numerics.md, "Fragments" and "Textures" (J. Blinn, "Hyperbolic
// interpolation", 1992).
Interpolation interpolation_at(const Triangle& triangle, const Weights& affine, bool orthographic);

// An attribute from its values at the vertices; one that is equal there is exactly so between them.
double interpolate(const Weights& weights, double at0, double at1, double at2);

// An attribute's change, from Interpolation::per_x or per_y.
double change_of(const Weights& per_pixel, double at0, double at1, double at2);

struct Place {
    Vec3 position;  // world space
    Vec3 to_eye;    // unit length
};

// The place in the world that is seen at affine weights: the inverse of Projection in
// scene/camera.h.
Place place_at(const Triangle& triangle, const Weights& affine, const Eye& eye);

}  // namespace sheer::reference
