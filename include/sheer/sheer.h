// Everything that Sheer offers to a program.
#pragma once

#include <string>

#include <sheer/error.h>
#include <sheer/image.h>
#include <sheer/render.h>
#include <sheer/scene.h>

namespace sheer {

// Reads a scene. `source` is a file's path (.gltf, .glb), or "builtin:NAME?key=value&key=value".
// Throws Error with Fault::input when there is no such scene or when it is broken.
Scene load(const std::string& source);

}  // namespace sheer
