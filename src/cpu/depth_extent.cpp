// One look at every triangle.
#include "cpu/depth_extent.h"

#include <algorithm>
#include <limits>

namespace sheer {

void find_depth_extent(const Geometry& geometry, const FrameSurfaces& surfaces, EyeSpace& eye)
{
    float least = std::numeric_limits<float>::infinity(), most = -least;
    for (const TriangleChunk& chunk : geometry.chunks) {
        for (const Triangle& t : chunk.triangles) {
            if (!is_seen_through(surfaces.surfaces[t.object])) continue;
            for (const float depth : t.depth) {
                least = std::min(least, depth);
                most = std::max(most, depth);
            }
        }
    }
    if (!(least <= most)) return;
    eye.nearest = geometry.orthographic ? least : -1 / least;
    eye.farthest = geometry.orthographic ? most : -1 / most;
}

}  // namespace sheer
