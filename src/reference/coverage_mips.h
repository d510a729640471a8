// Mip levels of which as large a part passes an alpha test as of the texture: I. Castaño,
// "Computing alpha mipmaps", 2010.
#pragma once

#include <span>
#include <vector>

namespace sheer::reference {

// The part of the texels with more than `threshold`.
double passing_part(std::span<const double> alphas, double threshold);

// The threshold that a part of a level's texels passes: half way between the alphas of two texels,
// or of one and 0 or 1, where the part is closest to the wanted one; of two such thresholds the
// lower. Above 0.
double threshold_for_part(std::span<const double> alphas, double part);

// Alphas times threshold / threshold_for_part(...), at most 1: with `threshold` they pass as with
// the other before.
std::vector<double> scaled_for_part(std::span<const double> alphas, double part, double threshold);

// The mean of each two by two texels, row by row; width and height even.
std::vector<double> halved(std::span<const double> alphas, int width, int height);

}  // namespace sheer::reference
