// How much two pictures differ to someone who flips between them.
#pragma once

#include <vector>

#include <sheer/image.h>

namespace sheer {

struct FlipErrors {
    int width = 0, height = 0;
    std::vector<float> errors;  // of each pixel, row by row, from 0 to 1
    double mean = 0;
};

// LDR-FLIP: Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom and Fairchild. FLIP: A
// Difference Evaluator for Alternating Images. PACM CGIT 3(2), 2020; with 67.02 pixels a degree,
// which is a monitor of 0.7 m and 3840 pixels from 0.7 m away. Colours outside of [0, 1] are
// clamped, as the pictures' sRGB encoding would; alpha doesn't count. It is symmetric.
//
// Throws Error(Fault::input) where the sizes differ. The same bits with any number of threads.
FlipErrors flip_errors(const Image& test, const Image& reference, int threads);

}  // namespace sheer
