// How alike the structures of two pictures are.
#pragma once

#include <optional>

#include <sheer/image.h>

namespace sheer {

// Wang, Bovik, Sheikh and Simoncelli. Image quality assessment: from error visibility to structural
// similarity. IEEE Transactions on Image Processing 13(4), 2004: the mean of their SSIM over all
// windows of 11x11 pixels inside of the picture, weighted by a Gaussian of standard deviation 1.5,
// with K1 = 0.01 and K2 = 0.03. Here of the sRGB encoded values from 0 to 1 (clamped; L = 1), and
// the mean over red, green and blue, where the paper has grey pictures. 1 where they are the same,
// -1 at the least. None of a picture that is smaller than a window.
//
// Throws Error(Fault::input) where the sizes differ. The same bits with any number of threads.
std::optional<double> ssim(const Image& a, const Image& b, int threads);

}  // namespace sheer
