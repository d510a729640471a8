// Which pixels can have a sample inside a triangle.
#pragma once

#include <algorithm>

#include "geometry/triangles.h"

namespace sheer {

// Pixels [x0, x1] x [y0, y1], both ends included; empty where x0 > x1 or y0 > y1.
struct PixelBounds {
    int x0, y0, x1, y1;
};

inline PixelBounds pixel_bounds(const Triangle& t, const SampleExtent& samples)
{
    const auto [left, right] = std::minmax({t.x[0], t.x[1], t.x[2]});
    const auto [top, bottom] = std::minmax({t.y[0], t.y[1], t.y[2]});
    // Ceiling and floor of (coordinate - sample) / kSubpixels; the shift rounds down.
    return {(left - samples.x_max + kSubpixels - 1) >> kSubpixelBits,
            (top - samples.y_max + kSubpixels - 1) >> kSubpixelBits,
            (right - samples.x_min) >> kSubpixelBits, (bottom - samples.y_min) >> kSubpixelBits};
}

}  // namespace sheer
