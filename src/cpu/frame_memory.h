// What a frame will take, before it takes it.
#pragma once

#include <cstdint>

#include <sheer/render.h>
#include <sheer/scene.h>

#include "cpu/frame_job.h"
#include "cpu/memory_plan.h"

namespace sheer {

// Of the scene's geometry, at most.
std::uint64_t geometry_bytes(const Scene& scene, const PlaceSpaces& places = {});

// Throws Error(Fault::work) as plan_memory does. `reserved`: bytes that the caller will need
// besides; `threads`: wanted. Where there is no room to keep a tile's fragments for the passes over
// them, job.stream_capacity becomes smaller.
MemoryPlan plan_frame_memory(FrameJob& job, const Options& options, std::uint64_t reserved,
                             int threads);

}  // namespace sheer
