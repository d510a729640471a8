// Scenes from files of every format there is.
#pragma once

#include <string>

#include <sheer/sheer.h>

namespace sheer {

// glTF, OBJ, PLY, STL or TressFX hair: what the content says it is, where it does, else what the
// suffix says. Throws Error with Fault::input, one line that begins with the path.
Scene read_scene(const std::string& path, const LoadOptions& options = {});

}  // namespace sheer
