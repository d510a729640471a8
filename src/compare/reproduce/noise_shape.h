// The shape of noise in a square picture, by its autocorrelation along the screen's two axes.
#pragma once

#include <vector>

namespace sheer {

// Of pixels that are 0 or 1 with about the same chance. Pixels along which they are alike:
// 1 + 2 (r(1) + r(2) + ...), r the autocorrelation, up to kMostLag.
struct NoiseLengths {
    static constexpr int kMostLag = 24;

    double across = 0, down = 0;
    std::vector<double> along_x = std::vector<double>(kMostLag);  // r(1), r(2), ...
    std::vector<double> along_y = std::vector<double>(kMostLag);

    // The mean over so many pictures, one of which is this.
    void add(const std::vector<double>& pixels, int side, int pictures);
    void finish();  // after the last of them
};

}  // namespace sheer
