// Rasterises and shades one tile: opaque surfaces into samples, transparent ones into the stream.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "cpu/shading_rates.h"
#include "geometry/tile_grid.h"
#include "geometry/triangles.h"
#include "lanes/targets.h"
#include "methods/method.h"
#include "raster/coverage_list.h"
#include "raster/fragments.h"
#include "raster/opaque_tile.h"
#include "raster/sample_set.h"
#include "shade/surface.h"

namespace sheer {

// Of a tile's surfaces.
enum class TilePart { all, opaque, transparent };

class OcclusionRays;

// What the eye's picture has beside the light; nothing by itself.
struct PictureShading {
    const OcclusionRays* occlusion = nullptr;  // or all of the sky is seen
    const Foveation* foveation = nullptr;      // or all is shaded at full rate
};

struct TileJob {
    const Geometry* geometry;
    const FrameSurfaces* surfaces;
    const SampleSet* samples;
    int tile;
    PixelRect rect;    // of the picture; at most kTileSize across
    PixelRect region;  // the part of it that is wanted
    FragmentWants wants = {};
    TilePart part = TilePart::all;  // the others are left out
    PictureShading shading = {};
};

struct TileTriangle {
    const TriangleChunk* chunk;
    const Triangle* triangle;
};

// A transparent triangle on its way into another order.
struct SortedTriangle {
    float distance;
    std::uint32_t id;  // of its object, or its own
    const TriangleChunk* chunk;
    const Triangle* triangle;
};

// What a thread needs besides, tile after tile.
struct TileScratch {
    std::vector<TileTriangle> triangles;
    std::vector<SortedTriangle> sorted;
    // Fragments left out of the last tile, FragmentConsumer, but for those of whole triangles.
    std::uint64_t hidden = 0;
    // As one triangle sees them.
    std::vector<Float3> light_places;
    std::vector<ShadowReceiver> receivers;
    // Of a batch of opaque triangles.
    AlignedArray<std::uint32_t> pixel, low, high;
    // Of surfaces that are drawn conservatively, or at each sample.
    OverlapList overlaps;
    std::vector<std::uint32_t> sampled_pixel;
    std::vector<std::uint64_t> sampled;
    std::unique_ptr<FoveationScratch> foveation;  // or null

    TileScratch()
        : pixel(kTilePixels + FragmentStream::kSlack),
          low(kTilePixels + FragmentStream::kSlack),
          high(kTilePixels + FragmentStream::kSlack)
    {
    }
};

// Takes the fragments that the stream holds when it is full. False: no more are wanted.
struct FragmentConsumer {
    bool (*take)(void* context, const FragmentStream& stream);
    void* context;
    // Of kTilePixels: fragments behind are not wanted, and need not be shaded. It may come nearer
    // with each call of `take`. Null: all are wanted.
    const float* hidden_behind = nullptr;
};

// What is left at the end, which may be nothing, stays in the stream. False: the consumer wanted no
// more.
using TileFragmentsFunction = bool (*)(const TileJob&, TileScratch&, OpaqueTile&, FragmentStream&,
                                       const FragmentConsumer&);

TileFragmentsFunction tile_fragments_for(TargetSet targets);

}  // namespace sheer
