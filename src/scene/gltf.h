// glTF 2.0 scenes, as .gltf with its files beside it or as one .glb.
#pragma once

#include <string>

#include <sheer/sheer.h>

#include "support/read_file.h"

namespace sheer {

// Throws Error with Fault::input, "<path>: <where in the file>: <what is wrong>", in one line. What
// is found and not drawn is told in Scene::ignored.
Scene read_gltf(const std::string& path, const LoadOptions& options = {});

// The same from a file's content; `path` is for messages and for the files it names.
Scene read_gltf(const std::string& path, Bytes content, const LoadOptions& options = {});

}  // namespace sheer
