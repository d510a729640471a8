// A picture in memory: linear, premultiplied RGBA, 32-bit float, rows from the top.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace sheer {

// Larger pictures are refused: the rasteriser's fixed-point coordinates end there.
inline constexpr int kMaxImageSize = 16384;

struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::array<float, 4>> pixels;  // width * height, row by row, top left first

    Image() = default;
    Image(int w, int h)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h))
    {
    }

    std::array<float, 4>& at(int x, int y)
    {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    const std::array<float, 4>& at(int x, int y) const
    {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

}  // namespace sheer
