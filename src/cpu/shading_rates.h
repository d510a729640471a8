// Foveation: which pixels of a tile are shaded together (docs/numerics.md, "Foveation").
#pragma once

#include <array>
#include <cstdint>

#include <sheer/render.h>

#include "geometry/tile_grid.h"
#include "raster/fragments.h"
#include "support/aligned.h"

namespace sheer {

// Squares of 1, 4 or 16 pixels, which a triangle shades once each. They lie as the picture does, so
// that no tile sees others than its neighbours do.
struct ShadingRates {
    bool coarse = false;  // some have more than one pixel
    // Of each of kTilePixels pixels: a side of its square, pixels; the square's middle, to the
    // right and down of the centre of the tile's first pixel; and its first pixel in the tile.
    AlignedArray<float> side{kTilePixels}, x{kTilePixels}, y{kTilePixels};
    AlignedArray<std::uint16_t> square{kTilePixels};

    void set(const Foveation& foveation, const PixelRect& rect);
};

// A triangle's squares on their way to its fragments.
struct ShadedSquares {
    static constexpr int kRoom = kTilePixels + FragmentStream::kSlack;

    // One fragment of each, as a coverage list.
    AlignedArray<std::uint32_t> pixel{kRoom}, low{kRoom}, high{kRoom};
    // Red, green, blue, opacity, and what passes through of each channel.
    std::array<AlignedArray<float>, 7> shaded{
        AlignedArray<float>{kRoom}, AlignedArray<float>{kRoom}, AlignedArray<float>{kRoom},
        AlignedArray<float>{kRoom}, AlignedArray<float>{kRoom}, AlignedArray<float>{kRoom},
        AlignedArray<float>{kRoom}};
    // Of each fragment its square's number; and, at squares' first pixels, of the last triangle
    // that was there, and its number.
    AlignedArray<std::uint16_t> number{kRoom}, number_at{kTilePixels};
    AlignedArray<std::uint64_t> triangle_at{kTilePixels};
    std::uint64_t triangle = 0;  // counted

    // Of the fragments of one triangle, `count` entries of a list. How many there are.
    int list(const ShadingRates& rates, const std::uint32_t* pixels, const std::uint32_t* lows,
             const std::uint32_t* highs, int count);
};

// What a thread needs for them.
struct FoveationScratch {
    ShadingRates rates;
    ShadedSquares squares;

    static constexpr std::size_t bytes()
    {
        return kTilePixels *
                   (3 * sizeof(float) + 2 * sizeof(std::uint16_t) + sizeof(std::uint64_t)) +
               ShadedSquares::kRoom * (10 * sizeof(float) + sizeof(std::uint16_t));
    }
};

}  // namespace sheer
