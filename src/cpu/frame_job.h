// What is known of a frame before its tiles are drawn, and what draws them.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cpu/channels.h"
#include "cpu/filter.h"
#include "cpu/take_groups.h"
#include "cpu/tile_picture.h"
#include "cpu/tile_passes.h"

namespace sheer {

struct DrawnBackdrop;
struct ReducedPicture;

// What all tiles read.
struct FrameJob {
    std::span<const Take> takes;
    std::vector<TakeGroup> groups;
    const Geometry& geometry;
    const FrameSurfaces& surfaces;
    const SampleSet& samples;
    const SampleFilter& filter;
    TileGrid grid;
    Float4 background;
    EyeSpace eye;
    std::vector<StoreVerbs> verbs;  // of each take
    TileFragmentsFunction tile_fragments;
    int stream_capacity;
    std::size_t store_bytes;  // for a store that grows
    FragmentSink* sink;       // or null
    // Of each take, or null.
    std::vector<const ReducedPicture*> reduced = {};
    const DrawnBackdrop* backdrop = nullptr;  // or none
    PictureShading shading = {};
};

// What one thread works with, tile after tile.
struct Worker {
    TilePasses passes;
    SampleColors colors;
    std::vector<TileStore> stores;  // of each take
    TilePicture picture;
    TileMean<4> mean;
    ChannelTile channels;
};

using Workers = std::vector<std::unique_ptr<Worker>>;

}  // namespace sheer
