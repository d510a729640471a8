// Rasterises and shades one tile: opaque surfaces into samples, transparent ones into the stream.
#pragma once

#include <vector>

#include "geometry/triangles.h"
#include "lanes/targets.h"
#include "raster/coverage_list.h"
#include "raster/fragments.h"
#include "raster/opaque_tile.h"
#include "raster/sample_set.h"
#include "geometry/tile_grid.h"
#include "shade/surface.h"

namespace sheer {

struct FrameSurfaces {
    std::vector<Surface> surfaces;  // one for each object
    Light light;
    bool any_opaque = false;  // OPAQUE or MASK somewhere in the scene
};

struct TileJob {
    const Geometry* geometry;
    const FrameSurfaces* surfaces;
    const SampleSet* samples;
    int tile;
    PixelRect rect;  // of the picture; at most kTileSize across
};

// A triangle's part of the stream while it is covered but not yet shaded.
struct PendingRun {
    const TriangleChunk* chunk;
    const Triangle* triangle;
    int first, count;
};

// What a thread needs besides, tile after tile.
struct TileScratch {
    std::vector<PendingRun> pending;
    // Of one opaque triangle.
    AlignedArray<std::uint32_t> pixel, low, high;

    TileScratch()
        : pixel(kTilePixels + FragmentStream::kSlack),
          low(kTilePixels + FragmentStream::kSlack),
          high(kTilePixels + FragmentStream::kSlack)
    {
    }
};

// Takes the fragments that the stream holds when it is full, and at the end of the tile.
struct FragmentConsumer {
    void (*take)(void* context, const FragmentStream& stream);
    void* context;
};

using TileFragmentsFunction = void (*)(const TileJob&, TileScratch&, OpaqueTile&, FragmentStream&,
                                       const FragmentConsumer&);

TileFragmentsFunction tile_fragments_for(TargetSet targets);

}  // namespace sheer
