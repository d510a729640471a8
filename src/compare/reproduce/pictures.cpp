// Row by row.
#include "compare/reproduce/pictures.h"

#include <algorithm>
#include <cstddef>

namespace sheer {

Image side_by_side(std::span<const Image> pictures)
{
    constexpr int kGap = 8;  // pixels
    int width = -kGap;
    for (const Image& picture : pictures) width += picture.width + kGap;
    Image row(width, pictures.front().height);
    std::fill(row.pixels.begin(), row.pixels.end(), std::array<float, 4>{1, 1, 1, 1});
    int left = 0;
    for (const Image& picture : pictures) {
        for (int y = 0; y < picture.height; ++y) {
            std::copy_n(&picture.at(0, y), picture.width, &row.at(left, y));
        }
        left += picture.width + kGap;
    }
    return row;
}

}  // namespace sheer
