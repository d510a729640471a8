// A triangle's depth as a function of the place on the screen.
//
// Floats serve where surfaces lie apart. Where two depths differ by less than their slacks, floats
// can't tell which is nearer; doubles, rounded to 32 significant bits, then do, and what is equal
// in them is a tie (docs/numerics.md, "Visibility").
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geometry/tile_grid.h"
#include "raster/sample_set.h"

namespace sheer {

struct DepthPlane {
    float dx, dy;       // a pixel to the right and down
    float least, most;  // over the triangle; depth at a sample is clamped to them
    float slack;        // bounds the error of depth at a sample in floats
    double precise_at;  // at the centre of the tile's first pixel
    double precise_dx, precise_dy;

    // So many pixels to the right of there and down, not clamped.
    double precise(double x, double y) const
    {
        return precise_at + (x * precise_dx + y * precise_dy);
    }
};

// `terms`: the largest that the two vertices' shares in the depth at a pixel's centre get, in
// magnitude; far more than the depth itself in slivers, whose weights leave [0, 1] there and
// cancel. Some eight roundings of such terms, of the depths and of the change of depth over a
// pixel; the factor leaves four times that.
inline float depth_slack(const DepthPlane& plane, double terms)
{
    constexpr double kRoundings = 32.0 * 0x1p-24;
    const float depth = std::max(std::abs(plane.least), std::abs(plane.most));
    const float change = std::abs(plane.dx) + std::abs(plane.dy);
    return static_cast<float>(kRoundings *
                              (static_cast<double>(depth) + static_cast<double>(change) + terms));
}

// At sample s of a pixel, from the depth at its centre.
inline float sample_depth_at(const DepthPlane& plane, const SampleSet& set, float center,
                             std::size_t s)
{
    const float offset = set.offset_x[s] * plane.dx + set.offset_y[s] * plane.dy;
    return std::clamp(center + offset, plane.least, plane.most);
}

// Veltkamp's splitting: the nearest number of 53 - 21 bits is big - (big - x), big = this times x.
inline constexpr double kSplitTo32Bits = 0x1p21 + 1;

inline double round_to_32_bits(double x)
{
    const double big = x * kSplitTo32Bits;
    return big - (big - x);
}

// At sample s of a pixel of the tile (row * kTileSize + column).
inline double precise_depth(const DepthPlane& plane, const SampleSet& set, std::uint32_t pixel,
                            std::size_t s)
{
    const double x = pixel % kTileSize + static_cast<double>(set.offset_x[s]);
    const double y = pixel / kTileSize + static_cast<double>(set.offset_y[s]);
    return round_to_32_bits(std::clamp(plane.precise(x, y), static_cast<double>(plane.least),
                                       static_cast<double>(plane.most)));
}

}  // namespace sheer
