// What a method adds up of a picture of fewer pixels than the one that it is for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sheer {

// A pixel of the reduced picture is a texel here. The whole of each picture is the whole of the
// other, so that where their sizes do not divide, texels are a little smaller than they might be.
struct ReducedMoments {
    int picture_width, picture_height;
    int width, height;  // texels
    int numbers;        // of a texel
    std::vector<double> sums;

    // `reduction`: pixels across, at most, that are a texel.
    ReducedMoments(int picture_width_, int picture_height_, int reduction, int numbers_)
        : picture_width(picture_width_),
          picture_height(picture_height_),
          width((picture_width_ + reduction - 1) / reduction),
          height((picture_height_ + reduction - 1) / reduction),
          numbers(numbers_),
          sums(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               static_cast<std::size_t>(numbers))
    {
    }

    // Number k of a row of texels.
    double* row(int y, std::size_t k) { return sums.data() + at(y, k); }
    const double* row(int y, std::size_t k) const { return sums.data() + at(y, k); }

private:
    std::size_t at(int y, std::size_t k) const
    {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(numbers) + k) *
               static_cast<std::size_t>(width);
    }
};

// The two texels in a row or column whose centres are on both sides of a pixel's centre, and how
// far on the way from the one to the other that is.
struct TexelPair {
    int first = 0, second = 0;
    double part = 0;

    TexelPair() = default;
    TexelPair(int pixel, int pixels, int texels)
    {
        const double at = (pixel + 0.5) * texels / pixels - 0.5;
        const double least = std::clamp(at, 0.0, static_cast<double>(texels - 1));
        first = std::min(static_cast<int>(least), texels - 1);
        second = std::min(first + 1, texels - 1);
        part = least - first;
    }
};

}  // namespace sheer
