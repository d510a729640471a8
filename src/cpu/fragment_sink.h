// For whoever wants a frame's transparent fragments themselves, beside the pictures of them.
#pragma once

#include "cpu/channels.h"

namespace sheer {

class FragmentSink {
public:
    virtual ~FragmentSink() = default;

    // A part of what a tile's pixels show, in no particular order, as often as there are parts.
    // Pixels of `stream` count from `rect`; those of the tile alone are in `interior`, which no two
    // tiles share. Called from several threads, of each tile from one.
    virtual void take(const PixelRect& rect, const PixelRect& interior, const ChannelShape& shape,
                      const FragmentStream& stream) = 0;
};

}  // namespace sheer
