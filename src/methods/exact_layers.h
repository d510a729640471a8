// What `exact` keeps of fragments.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "raster/depth_plane.h"
#include "raster/fragments.h"

namespace sheer {

// A kept fragment.
struct PlainLayer {
    float red, green, blue, opacity;
    float depth;        // at the pixel's centre
    std::uint32_t run;  // of the fragments of one triangle
    std::uint32_t samples, samples_high;

    PlainLayer() {}  // clears nothing: what a vector grows by is written at once
    void set(const FragmentStream& f, std::size_t i, std::uint32_t run_of_store)
    {
        red = f.red[i];
        green = f.green[i];
        blue = f.blue[i];
        opacity = f.opacity[i];
        depth = f.depth[i];
        run = run_of_store;
        samples = f.samples[i];
        samples_high = f.samples_high[i];
    }
    std::uint64_t bits() const { return samples | static_cast<std::uint64_t>(samples_high) << 32; }
};
static_assert(sizeof(PlainLayer) == 32);

// Of coloured glass.
struct ColoredLayer : PlainLayer {
    float through_red, through_green, through_blue;

    ColoredLayer() {}
    void set(const FragmentStream& f, std::size_t i, std::uint32_t run_of_store)
    {
        PlainLayer::set(f, i, run_of_store);
        through_red = f.through_red[i];
        through_green = f.through_green[i];
        through_blue = f.through_blue[i];
    }
};
static_assert(sizeof(ColoredLayer) == 44);

struct LayerRun {
    DepthPlane depth;
    std::uint32_t primitive;
    std::uint32_t first;  // of its layers, which lie one after the other
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

}  // namespace sheer
