// Images for cards: leaves on a twig, a fern's frond, blades of grass.
#pragma once

#include <string>

#include <sheer/scene.h>

#include "scene/builtin/shapes.h"

namespace sheer {

// The twig or the roots are at the middle of the bottom edge, the tip at the top. About two thirds
// of each image is empty.
struct LeafColors {
    shapes::Vec blade, vein, tip;
};

TextureImage make_twig_image(const std::string& name, const LeafColors& colors);
TextureImage make_frond_image(const std::string& name, const LeafColors& colors);
TextureImage make_grass_image(const std::string& name, const LeafColors& colors);

}  // namespace sheer
