// The geometry stage: from a scene and a camera to screen triangles in tiles.
#pragma once

#include "geometry/tile_grid.h"
#include "geometry/triangles.h"
#include "scene/camera.h"

namespace sheer {

struct GeometryJob {
    const Scene& scene;
    const Projection& projection;
    TileGrid grid;
    SampleExtent samples;
    int threads;
    PlaceSpaces places = {};  // Geometry::places that are wanted
    int line_rows = 0;        // of the picture that lines' widths in pixels are of; 0: the grid's
};

// Throws Error(Fault::input) when the scene is too large for its numbering.
Geometry build_geometry(const GeometryJob& job);

}  // namespace sheer
