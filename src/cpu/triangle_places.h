// Where the corners of a triangle of the picture are in the world.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/triangles.h"

namespace sheer {

// A triangle's corner in the world, relative to the eye.
inline std::array<double, 3> place_of(const Eye& eye, const Triangle& t, std::size_t corner)
{
    const double x = 2.0 * t.x[corner] / (kSubpixels * eye.width) - 1;
    const double y = 1 - 2.0 * t.y[corner] / (kSubpixels * eye.height);
    const double depth = static_cast<double>(t.depth[corner]);
    const double distance = eye.orthographic ? depth : -1 / depth;
    const double w = eye.orthographic ? 1 : distance;
    std::array<double, 3> place;
    for (std::size_t i = 0; i < 3; ++i) {
        place[i] = x * w / eye.scale_x * eye.right[i] + y * w / eye.scale_y * eye.up[i] -
                   distance * eye.back[i];
    }
    return place;
}

}  // namespace sheer
