// What `exact` keeps of fragments, and puts in order.
#pragma once

#include <bit>
#include <cstdint>

#include "raster/depth_plane.h"

namespace sheer {

// A kept fragment.
struct PlainLayer {
    float red, green, blue, opacity;
    float depth;  // at the pixel's centre
    std::uint32_t pixel, run;
    std::uint32_t samples, samples_high;

    std::uint64_t bits() const { return samples | static_cast<std::uint64_t>(samples_high) << 32; }
};
static_assert(sizeof(PlainLayer) == 36);

// Of coloured glass.
struct ColoredLayer : PlainLayer {
    float through_red, through_green, through_blue;
};
static_assert(sizeof(ColoredLayer) == 48);

struct LayerRun {
    DepthPlane depth;
    std::uint32_t primitive;
};

// A layer of the pixel at hand.
template <class Layer>
struct Placed {
    const Layer* layer;
    const LayerRun* run;
};

// The same at one sample.
template <class Layer>
struct PreciselyPlaced {
    double depth;
    std::uint32_t primitive;
    const Layer* layer;

    bool operator<(const PreciselyPlaced& b) const
    {
        return depth < b.depth || (depth == b.depth && primitive < b.primitive);
    }
};

// Floats in the order of unsigned integers.
inline std::uint64_t ordered_bits(float x)
{
    const auto bits = std::bit_cast<std::uint32_t>(x + 0.0f);  // -0 becomes 0
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

// The first `size` items are sorted; puts another one among them.
template <class Item>
inline void insert_sorted(Item* items, std::size_t size, const Item& item)
{
    for (; size > 0 && item < items[size - 1]; --size) items[size] = items[size - 1];
    items[size] = item;
}

}  // namespace sheer
