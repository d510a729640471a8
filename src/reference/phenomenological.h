// What phenomenological transparency must answer for one sample, in double precision: M. McGuire,
// M. Mara, "Phenomenological transparency", 2017. Sums and products of weighted fragments, and what
// they say of a backdrop that is blurred and displaced.
#pragma once

#include <span>

#include "reference/reference.h"

namespace sheer::reference {

// The weight of a fragment. `opacity` is its coverage times what of the light, on the mean of the
// channels, it does not transmit; d is the depth that a projection to [0, 1] gives it.
double phenomenological_weight(double opacity, double d);

// Fragments' depth is d in [0, 1]. Each adds weight times its premultiplied colour and opacity to
// sums, and multiplies what is seen of the backdrop by its transmittance. The mean colour stands
// for what is not seen of the backdrop: `mean` of the channels, which one fragment alone makes
// exact, or `each` channel's own part.
enum class BackdropPart { mean, each };
Rgba phenomenological(std::span<const Fragment> fragments, BackdropPart part, Rgba backdrop);

// What a fragment adds to the variance of the blur of the backdrop: z is its distance from the eye,
// `behind` how much farther the backdrop is, both positive; collimation in [0, 1] is 1 for what
// does not diffuse at all. 0 where the backdrop touches.
double phenomenological_diffusion(double opacity, double collimation, double z, double behind);

// Where a ray that enters a surface of index eta goes on, less where it would have gone, a metre
// farther along the axis of view (x, y); by Snell's law of angles. The ray is (x, y, 1); the normal
// is of length 1 and turned towards the eye.
struct Displacement {
    double x, y;
};
Displacement phenomenological_refraction(const double (&ray)[3], const double (&normal)[3],
                                         double eta);

}  // namespace sheer::reference
