// One method's part of a tile.
#pragma once

#include "cpu/frame_job.h"

namespace sheer {

// Draws the tile that `setting` is for by take `number` of the job's, and writes it to the images
// that `frame` has.
void draw_take(const FrameJob& job, std::size_t number, TileSetting& setting, Worker& worker,
               TakeFrame& frame);

}  // namespace sheer
