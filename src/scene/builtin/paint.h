// Texture images from functions.
#pragma once

#include <functional>
#include <string>

#include <sheer/scene.h>

#include "scene/builtin/shapes.h"

namespace sheer {

struct Paint {
    shapes::Vec color;  // linear, straight
    double alpha = 1;
};

// `front` over `back`.
Paint over(const Paint& front, const Paint& back);

// What has this colour at (u, v), (0, 0) the image's top left corner and (1, 1) its bottom right
// one: each texel is the mean of `grid` by `grid` points. Texels of opacity 0 take
// `color_of_nothing`.
TextureImage paint_image(const std::string& name, int width, int height, int grid,
                         const std::function<Paint(double u, double v)>& paint,
                         shapes::Vec color_of_nothing = {});

double clamp_unit(double t);
double mix(double a, double b, double t);
shapes::Vec mix(shapes::Vec a, shapes::Vec b, double t);
// 0 up to `from`, 1 from `to` on, smooth between; from > to turns it round.
double smooth_step(double from, double to, double t);

}  // namespace sheer
