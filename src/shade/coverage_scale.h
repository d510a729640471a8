// What a mipmap level's alphas are multiplied by so that as large a part of them passes an alpha
// test as of the image: I. Castaño. Computing Alpha Mipmaps. 2010, as C. Wyman and M. McGuire,
// Improved Alpha Testing Using Hashed Sampling (IEEE TVCG 25(2), 2019), section 3, describe it.
#pragma once

#include <vector>

namespace sheer {

// `part`: of the image's texels that reach `threshold`. Of the parts that a level can have the
// nearest is taken, of two as near the larger.
double coverage_scale(std::vector<double> alphas, double part, double threshold);

}  // namespace sheer
