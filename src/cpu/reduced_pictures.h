// What some methods add up of a picture of fewer pixels, before the tiles of the picture itself are
// drawn: they read what their pixels' neighbours have too.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cpu/frame.h"
#include "cpu/frame_job.h"
#include "methods/reduced_moments.h"

namespace sheer {

struct ReducedPicture {
    ReducedMoments moments;
    double ms;
};

// Of each take, or none. `job` is that of the whole picture, with its geometry and what measures
// depth. Throws Error(Fault::work) when the memory limit of the options is too low.
std::vector<std::optional<ReducedPicture>> draw_reduced_pictures(const FrameJob& job,
                                                                 const Scene& scene,
                                                                 const Projection& projection,
                                                                 TargetSet targets, int threads,
                                                                 const Options& options);

}  // namespace sheer
