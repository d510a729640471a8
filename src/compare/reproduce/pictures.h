// Pictures of figures: several in a row, and what several have in common.
#pragma once

#include <span>
#include <vector>

#include <sheer/image.h>

#include "compare/metrics.h"

namespace sheer {

// From left to right, white between them. They are of one height.
Image side_by_side(std::span<const Image> pictures);

// From top to bottom likewise. They are of one width.
Image one_below_another(std::span<const Image> pictures);

// A rectangle of pixels.
struct Crop {
    int x, y, width, height;
};

// What is within, each pixel `times` x `times` large.
Image enlarge(const Image& picture, const Crop& crop, int times);

// Opaque, what is behind it white.
Image over_white(Image picture);

// Of pictures of one size, two or more, each of a seed of its own.
Moments moments_of(const std::vector<Image>& images);

// Whether some pixels are biased, of whatever sign: in standard errors, what is left of the squared
// differences from the truth without the part that so many seeds have anyway. NaN without noise.
double bias_z(const Moments& moments, const Image& truth);

}  // namespace sheer
