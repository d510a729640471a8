// What a caller's own scene and view must fulfil before the pipeline trusts them.
#pragma once

#include <sheer/render.h>

namespace sheer {

// Both throw Error(Fault::input) with one line that names the argument or the mesh.
void check_scene(const Scene& scene);
void check_view(const View& view, const Options& options);

}  // namespace sheer
