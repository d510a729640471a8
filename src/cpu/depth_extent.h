// How near and how far what is transparent lies.
#pragma once

#include "geometry/triangles.h"
#include "methods/method.h"
#include "shade/surface.h"

namespace sheer {

// Sets EyeSpace::nearest and farthest, over all triangles on the screen; on no threads and no
// tiles do they depend.
void find_depth_extent(const Geometry& geometry, const FrameSurfaces& surfaces, EyeSpace& eye);

}  // namespace sheer
