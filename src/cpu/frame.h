// A frame on the CPU.
#pragma once

#include <sheer/render.h>

namespace sheer {

// As sheer::render, for a scene that has passed check_scene.
Frame render_frame(const Scene& scene, const View& view, const Options& options);

}  // namespace sheer
