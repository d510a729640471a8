// The debug channels of a tile, gathered from its stream.
#pragma once

#include <vector>

#include <sheer/render.h>

#include "geometry/tile_grid.h"
#include "methods/method.h"

namespace sheer {

struct ChannelShape {
    int samples;
    int width;  // of the picture
    EyeSpace eye;
};

class ChannelTile {
public:
    ChannelTile() : pixels_(kTilePixels) {}

    void clear();
    void add(const FragmentStream& stream);
    // Writes the pixels of `interior`, a part of `rect`.
    void write(const PixelRect& rect, const PixelRect& interior, const ChannelShape& shape,
               Channels& channels) const;

private:
    struct Pixel {
        std::uint32_t fragments = 0;
        std::uint32_t layers = 0;  // over all samples
        std::uint64_t covered = 0;
        float depth = 0;
    };
    std::vector<Pixel> pixels_;
};

}  // namespace sheer
