// The mean of several pictures of a tile, and their variance.
#pragma once

#include <array>
#include <vector>

#include <sheer/image.h>
#include <sheer/scene.h>

#include "geometry/tile_grid.h"

namespace sheer {

// Sums are those of differences from the first picture, in doubles: one picture is its own mean,
// bit for bit, and what hardly varies loses no digits.
class TileMean {
public:
    void clear() { count_ = 0; }

    void add(const std::vector<Float4>& pixels)
    {
        if (count_++ == 0) {
            first_ = pixels;
            sums_.assign(pixels.size(), {});
            squares_.assign(pixels.size(), {});
            return;
        }
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            for (std::size_t c = 0; c < 4; ++c) {
                const double d = double{pixels[i][c]} - double{first_[i][c]};
                sums_[i][c] += d;
                squares_[i][c] += d * d;
            }
        }
    }

    void write_mean(const PixelRect& interior, Image& image) const
    {
        for_each(interior, image, [&](std::size_t i, std::size_t c) {
            return static_cast<float>(double{first_[i][c]} + sums_[i][c] / count_);
        });
    }
    void write_variance(const PixelRect& interior, Image& image) const
    {
        for_each(interior, image, [&](std::size_t i, std::size_t c) {
            if (count_ < 2) return 0.0f;
            const double rest = squares_[i][c] - sums_[i][c] * sums_[i][c] / count_;
            return static_cast<float>(std::max(rest, 0.0) / (count_ - 1));
        });
    }

private:
    template <class Value>
    void for_each(const PixelRect& interior, Image& image, Value&& value) const
    {
        std::size_t i = 0;
        for (int y = interior.y0; y < interior.y1; ++y) {
            for (int x = interior.x0; x < interior.x1; ++x, ++i) {
                for (std::size_t c = 0; c < 4; ++c) image.at(x, y)[c] = value(i, c);
            }
        }
    }

    int count_ = 0;
    std::vector<Float4> first_;
    std::vector<std::array<double, 4>> sums_, squares_;
};

}  // namespace sheer
