// The picture of what is behind everything transparent, for the methods that look at more of it
// than a tile has.
#pragma once

#include <optional>

#include <sheer/render.h>

#include "cpu/frame_job.h"
#include "methods/backdrop_picture.h"
#include "scene/camera.h"

namespace sheer {

struct DrawnBackdrop {
    BackdropPicture picture;
    double ms;
};

// Or none, where no method of the job wants it. Throws Error(Fault::work) when the memory limit of
// the options is too low.
std::optional<DrawnBackdrop> draw_backdrop_picture(const FrameJob& job,
                                                   const Projection& projection, int threads,
                                                   const Options& options);

}  // namespace sheer
