// Visibility as a curve of straight pieces within a bound, in double precision: T. Lokovic, E.
// Veach, "Deep shadow maps", 2000.
#pragma once

#include <span>
#include <vector>

#include "reference/reference.h"

namespace sheer::reference {

// V(z), straight between vertices in ascending z, constant before the first and behind the last. Of
// two vertices at the same z the first is the limit from the front, and V(z) is that limit: a
// surface does not hide itself.
struct CurveVertex {
    double z, v;
};
using VisibilityCurve = std::vector<CurveVertex>;

double curve_value(const VisibilityCurve& curve, double z);
// Behind all vertices; 1 for none.
double curve_end(const VisibilityCurve& curve);

// The exact steps of all fragments, in any order: two vertices for each depth.
VisibilityCurve step_curve(std::span<const Fragment> fragments);

// Nowhere off by more than `error`. From a vertex on, one line as far as there is a slope that
// passes all vertices within the bound; it ends at the last of them, with the middle of the slopes
// that are left. A step at a line's end that is larger than the bound becomes one of the new curve,
// to the exact value.
VisibilityCurve compressed(const VisibilityCurve& curve, double error);

// The product, at the vertices of both (between them, where both are slanted, it is not straight).
VisibilityCurve product(const VisibilityCurve& a, const VisibilityCurve& b);

enum class CurveResolve {
    // U = sum of V(z) alpha c over all fragments, T what all fragments let through
    curve,     // U + V(infinity) backdrop
    total,     // U + T backdrop
    corrected  // (1 - T) U / U1 + T backdrop, U1 the sum without c
};
// V(z) is taken as 0 below 0 and as 1 above 1.
Rgba through_curve(std::span<const Fragment> fragments, const VisibilityCurve& curve,
                   CurveResolve resolve, Rgba backdrop);

}  // namespace sheer::reference
