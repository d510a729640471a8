// The whole picture of what is behind everything transparent, for methods that look at more of it
// than a sample's own backdrop: blurred, or beside where it is.
//
// Level l of the pyramid has pixels 2^l across, each the mean of 4x4 of the level below with
// weights 1, 3, 3, 1, over 8, along each axis. Levels are read with quadratic B-splines. Both add
// the same variance wherever they are: 3/4 and 1/4 of the square of a pixel of theirs, so that what
// is read of level l is blurred with the variance 4^l / 2 - 1/4, and a mean of two levels with the
// mean of theirs. Straight lines stay straight, but for the picture's border, beyond which its last
// pixels go on: coarser levels have two more pixels on each side, the outer of which is what goes
// on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sheer/scene.h>

#include "geometry/tile_grid.h"

namespace sheer {

class BackdropPicture {
public:
    // Pixels that a step of 1 along x and y takes, a metre away, or of any distance where there is
    // no perspective.
    struct Scale {
        float x, y;
    };

    BackdropPicture(int width, int height, Scale scale);

    int width() const { return levels_[0].width; }
    int height() const { return levels_[0].height; }
    Scale scale() const { return scale_; }

    // The mean over a pixel's samples: the colour, premultiplied, and 1 over the distance from the
    // eye, 0 for what is infinitely far.
    Float4& color(int x, int y) { return levels_[0].pixels[at(x, y)]; }
    float& nearness(int x, int y) { return nearness_[at(x, y)]; }
    float nearness(int x, int y) const { return nearness_[at(x, y)]; }

    // All pixels of the first level are there.
    void make_levels();

    // The colour around a place in pixels, blurred with `variance`, in square pixels, of which no
    // more than the coarsest level has; `sharp`: what is to be read where that is 0.
    Float4 blurred(float x, float y, float variance, const Float4& sharp) const;
    // Mixed from the nearest four pixels.
    Float4 between(float x, float y) const;

    // Of a picture, a pixel: all levels, and the nearness.
    static constexpr double kPixelBytes = 16.0 * 4 / 3 + 4;
    static std::uint64_t bytes(int width, int height);

private:
    // Of all but the first level. The tap that is farthest out of pixel -2 is -5 of the level
    // below, where all from -2 on are the same; of -1 it is -3.
    static constexpr int kMargin = 2;

    struct Level {
        int width = 0, height = 0, margin = 0;
        std::vector<Float4> pixels = {};  // with the margin

        std::size_t in_row() const { return static_cast<std::size_t>(width + 2 * margin); }
    };

    std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) +
               static_cast<std::size_t>(x);
    }
    Float4 read(std::size_t level, float x, float y) const;
    static Level half_of(const Level& level);

    Scale scale_;
    std::vector<Level> levels_;
    std::vector<float> nearness_;
};

}  // namespace sheer
