// What a frame's takes are told to have taken.
#pragma once

#include <cstddef>

#include <sheer/render.h>

#include "cpu/frame_job.h"

namespace sheer {

// Of take `number`; `common`: what all takes share.
Stats make_stats(const Workers& workers, const FrameJob& job, std::size_t number, Stats common);

// Of another picture of the same scene and view.
void add_times(const Stats& one, Stats& sum);

}  // namespace sheer
