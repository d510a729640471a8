// The part of the circle of trigonometric moments that belongs to no depth, as
// shaders/sheer/circle_fraction.glsl wants it.
#pragma once

#include "support/math.h"

namespace sheer {

struct WrappingZone {
    double half_depth, rest, edge, cosine, sine, begins;
};

// Of 0.1 pi, as the paper has it.
inline WrappingZone wrapping_zone()
{
    constexpr double kPi = 0x1.921fb54442d18p+1, kAngle = 0.1 * kPi;
    WrappingZone zone;
    zone.half_depth = kPi / 2 - kAngle / 4;
    zone.rest = kAngle / 4;
    zone.edge = own_tan(zone.half_depth);
    zone.cosine = own_cos(kAngle / 2);
    zone.sine = own_sin(kAngle / 2);
    // |y| - |x| of a point on the circle, turned into a number that grows from -1 to 7.
    zone.begins = 6 + own_cos(kAngle) - own_sin(kAngle);
    return zone;
}

}  // namespace sheer
