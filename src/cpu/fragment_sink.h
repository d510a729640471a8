// For whoever wants a frame's transparent fragments themselves, beside the pictures of them.
#pragma once

#include <algorithm>
#include <cstddef>

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

// What such a part has of the tile alone: visit(run, i, x, y, depth) for each fragment i in a pixel
// (x, y) of `interior`; its depth is within those of its triangle.
template <class Visit>
void for_each_inside(const PixelRect& rect, const PixelRect& interior, const FragmentStream& stream,
                     Visit&& visit)
{
    for (std::size_t r = 0; r < static_cast<std::size_t>(stream.run_count); ++r) {
        const FragmentRun& run = stream.runs[r];
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            const auto place = static_cast<int>(stream.pixel[i]);
            const int x = rect.x0 + place % kTileSize, y = rect.y0 + place / kTileSize;
            if (x < interior.x0 || x >= interior.x1) continue;
            if (y < interior.y0 || y >= interior.y1) continue;
            visit(run, i, x, y, std::clamp(stream.depth[i], run.depth.least, run.depth.most));
        }
    }
}

}  // namespace sheer
