// What FLIP's model of an eye filters pictures with, as products of filters for x and for y.
#pragma once

#include <cstddef>
#include <vector>

namespace sheer {

// A contrast sensitivity function: the sum of one or two Gaussians, all weights together 1.
struct SpatialFilter {
    std::vector<std::vector<double>> gaussians;  // for x and for y alike
};

struct FlipFilters {
    std::size_t radius;  // in pixels, of those below
    SpatialFilter achromatic, red_green, blue_yellow;
    // Of what finds edges and points: a Gaussian, and its first and second derivative, whose
    // weights above 0 sum to 1 and those below to -1.
    std::vector<double> smooth, edge, point;
};

FlipFilters make_flip_filters();

}  // namespace sheer
