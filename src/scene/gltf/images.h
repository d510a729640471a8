// The images that what is drawn is textured with.
#pragma once

#include "scene/gltf/import.h"

namespace sheer::gltf {

// Decodes the images of materials that meshes use, each once, into Scene::images, and has the
// textures say which it is. Textures of other materials, and those on an image that is neither PNG
// nor JPEG, are taken away.
void load_images(Import& import);

}  // namespace sheer::gltf
