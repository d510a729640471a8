// Rectangles of pixels that overlap.
#pragma once

#include "geometry/tile_grid.h"

namespace sheer {

// Whether they share a pixel.
inline bool meet(const PixelRect& a, const PixelRect& b)
{
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

}  // namespace sheer
