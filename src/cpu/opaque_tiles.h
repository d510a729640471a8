// What is opaque of a frame, tile by tile, for what is made before the frame's own tiles.
#pragma once

#include <functional>

#include "cpu/frame_job.h"

namespace sheer {

// The pixels of `interior` are the tile's own; `rect` is all that it holds.
using OpaqueVisit =
    std::function<void(const PixelRect& rect, const PixelRect& interior, const OpaqueTile& opaque)>;

// Calls visit for each tile, on so many threads.
void for_each_opaque_tile(const FrameJob& job, int threads, const OpaqueVisit& visit);

// At most what a thread takes for that, but for the lists of triangles.
std::size_t opaque_thread_bytes(const FrameJob& job);

}  // namespace sheer
