// The stream of a tile's transparent fragments: rasterised and shaded once, for every pass of every
// method.
#pragma once

#include <array>
#include <cstdint>

#include "raster/depth_plane.h"
#include "support/aligned.h"

namespace sheer {

// Fragments [first, first + count) of the stream come from one triangle, each from another pixel.
struct FragmentRun {
    std::uint32_t first, count;
    std::uint32_t primitive;  // stable identity; breaks ties in depth
    std::uint32_t object;     // Object::id
    DepthPlane depth;
    bool back_facing = false;  // seen from behind
};

// Structure of arrays; kSlack values past `size` may be written to, and read, of which nothing may
// come: pixels there are some of the tile's, samples none or some, the rest anything.
struct FragmentStream {
    static constexpr int kSlack = 16;  // one vector

    int capacity = 0;
    int size = 0;
    int run_count = 0;
    AlignedArray<FragmentRun> runs;
    AlignedArray<std::uint32_t> pixel;         // row * kTileSize + column in the tile
    AlignedArray<std::uint32_t> samples;       // covered and visible, samples 0 to 31: bit i
    AlignedArray<std::uint32_t> samples_high;  // samples 32 to 63
    AlignedArray<float> depth;                 // at the pixel's centre, not clamped
    AlignedArray<float> red, green, blue;      // straight, linear radiance
    AlignedArray<float> opacity;               // in (0, 1]
    // Where there is coloured glass: the part of each channel that passes through the fragment;
    // 1 - opacity is their mean. Else empty.
    AlignedArray<float> through_red, through_green, through_blue;
    bool colored = false;
    // Where wanted: the place on the surface at which the fragment is shaded, and how it changes
    // along a pixel to the right and down; three coordinates each. Else empty.
    std::array<AlignedArray<float>, 9> place;
    // Likewise, where levels are wanted: the mipmap level that the base colour texture is read at,
    // times a pixel's length over its width on the texture. Endless without a texture.
    AlignedArray<float> level;
    bool placed = false;

    FragmentStream() = default;
    explicit FragmentStream(int most, bool with_colors = false, bool with_places = false)
        : capacity(most),
          runs(static_cast<std::size_t>(most), Unwritten{}),
          pixel(most + kSlack),
          samples(most + kSlack),
          samples_high(most + kSlack),
          colored(with_colors),
          placed(with_places)
    {
        const auto make = [&](AlignedArray<float>& values) {
            values = AlignedArray<float>(static_cast<std::size_t>(most + kSlack), Unwritten{});
        };
        for (AlignedArray<float>* values : {&depth, &red, &green, &blue, &opacity}) make(*values);
        for (AlignedArray<float>* through : {&through_red, &through_green, &through_blue}) {
            if (colored) make(*through);
        }
        for (AlignedArray<float>& coordinate : place) {
            if (placed) make(coordinate);
        }
        if (placed) make(level);
    }

    void clear() { size = run_count = 0; }
    // A fragment to a place that is not after its own.
    void move(std::size_t to, std::size_t from)
    {
        pixel[to] = pixel[from];
        samples[to] = samples[from];
        samples_high[to] = samples_high[from];
        for (AlignedArray<float>* values : {&depth, &red, &green, &blue, &opacity}) {
            (*values)[to] = (*values)[from];
        }
        if (placed) move_place(to, from);
        if (!colored) return;
        for (AlignedArray<float>* values : {&through_red, &through_green, &through_blue}) {
            (*values)[to] = (*values)[from];
        }
    }
    void move_place(std::size_t to, std::size_t from)
    {
        for (AlignedArray<float>& coordinate : place) coordinate[to] = coordinate[from];
        level[to] = level[from];
    }
    std::uint64_t sample_bits(std::size_t i) const
    {
        return samples[i] | static_cast<std::uint64_t>(samples_high[i]) << 32;
    }
};

}  // namespace sheer
