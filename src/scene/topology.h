// What a mesh's indices mean.
#pragma once

#include <cstddef>

#include <sheer/scene.h>

namespace sheer {

// Of a triangle, a piece of a line, a point.
inline std::size_t vertices_of_one(Topology topology)
{
    switch (topology) {
        case Topology::triangles: return 3;
        case Topology::lines: return 2;
        case Topology::points: return 1;
    }
    return 1;
}

}  // namespace sheer
