// Images made larger.
#pragma once

#include <sheer/scene.h>

namespace sheer {

// The image with at least as many texels each way: linear between the centres of the old ones, of
// colours in linear light, and repeating at the borders.
TextureImage enlarged(const TextureImage& image, int width, int height);

}  // namespace sheer
