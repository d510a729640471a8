// A tile of a shadow map takes what a light sees there.
#pragma once

#include <cstdint>

#include "geometry/tile_grid.h"
#include "lanes/targets.h"
#include "methods/method.h"
#include "raster/fragments.h"
#include "raster/opaque_tile.h"
#include "raster/sample_set.h"
#include "shade/shadow_map.h"

namespace sheer {

struct ShadowTile {
    ShadowMap& map;
    const SampleSet& set;
    PixelRect rect;
    ShadowMasks masks;
};

// What one thread has, tile after tile of one map, where a tile's texels have something that the
// map has not.
class ShadowTileStore {
public:
    virtual ~ShadowTileStore() = default;
    // `frame`: of the picture that the map is for.
    virtual void begin(const ShadowTile& tile, const FrameOfPicture& frame) = 0;
    virtual void insert(const ShadowTile& tile, const FragmentStream& fragments) = 0;
    // What is kept goes to the map.
    virtual void end(const ShadowTile& tile) = 0;
};

// Nothing in the light's way.
void clear_shadow_tile(const ShadowTile& tile);

// Each fragment at the samples of its random mask. What is kept does not depend on their order.
using InsertShadows = void (*)(const ShadowTile& tile, const FragmentStream& fragments);
InsertShadows insert_shadows_for(TargetSet targets);

// What is opaque, at every sample; last of all.
void insert_opaque_shadows(const ShadowTile& tile, const OpaqueTile& opaque);

}  // namespace sheer
