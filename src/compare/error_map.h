// Pictures of where two pictures differ.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <sheer/image.h>

#include "compare/flip.h"

namespace sheer {

// A pixel's error is the root of the mean square, over red, green and blue, of its difference in
// linear colour times 255; the root of the mean square of all of them is Difference::rmse.
//
// The map shows errors from 0 to `scale`, and more as that, from black by violet and orange to pale
// yellow, and green where the error is infinite or NaN. Equal steps of error look about equal. The
// picture is linear, as all are: written as PNG it holds the sRGB colours of the table. Throws
// Error(Fault::input) where the sizes differ.
Image error_map(const Image& a, const Image& b, double scale);

// The map's colours at equal steps from 0 to `scale`, straight lines between them: sRGB, 0 to 255.
std::span<const std::array<double, 3>> error_colors();

// A scale for that: 1, 2 or 5 times a power of ten, the least that leaves at most one in a thousand
// of the differing pixels above it; 0 where none differs.
double error_scale(const Image& a, const Image& b);

// One for several maps of these scales: the middle one of those that are not 0 (the larger of two;
// 0 if there are none), so that a method that is far off does not leave the others' maps black.
double shared_scale(std::vector<double> scales);

// The same colours for errors that were measured otherwise, as FLIP's from 0 to 1.
Image error_map(const FlipErrors& flip);

}  // namespace sheer
