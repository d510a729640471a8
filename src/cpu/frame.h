// Frames on the CPU.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <sheer/render.h>

#include "geometry/tile_grid.h"
#include "methods/method.h"
#include "raster/sample_set.h"

namespace sheer {

class FragmentSink;

// A picture to be made over fragments that others are made over too.
struct Take {
    ChosenMethod method;
    std::vector<std::uint32_t> keys;  // of random numbers: a frame each
    int frames = 1;                   // of one picture; the mean over all pictures is wanted
    bool variance = false;            // over the pictures is wanted as well
    // Of one picture: how many of the keys each pixel's frames are, 1 at least; empty: all.
    std::vector<std::uint16_t> frames_of_pixels = {};
    bool transparent = false;   // TakeFrame::transparent is wanted; of one picture
    bool apart = false;         // TakeFrame::fraction is wanted, and not part of the image
    FrameOfPicture alone = {};  // of several that are drawn one by one, the take's only one
    FrameOfFilm film = {};      // of the first key; the next ones follow

    // Of the frame that has the i-th key.
    FrameOfPicture frame_of_picture(std::size_t i) const
    {
        if (alone.count > 1) return alone;
        const std::size_t number = i % static_cast<std::size_t>(frames);
        return {keys[i - number], static_cast<int>(number), frames};
    }
};

struct TakeFrame {
    Image image;
    Image variance;  // of the pictures, divided by their number less 1; empty if not wanted
    // Of a method that divides: what it adds to the dimmed background, and total alpha.
    Image transparent;
    // Of such a method, of each pixel: a sum of colours, its weight and total alpha, not divided
    // yet.
    std::vector<std::array<float, 5>> fraction;
    Stats stats;
};

struct FrameTakes {
    std::vector<TakeFrame> frames;  // one for each take
    std::optional<Channels> channels;
};

// The key of one frame of a seed's sequence.
std::uint32_t frame_key(std::uint64_t seed, std::int64_t frame);

// What is not the view's or the options'.
struct TakesRequest {
    std::span<const Take> takes;
    SubpixelShift shift = {};           // of all samples
    std::uint64_t reserved_memory = 0;  // of options.memory_limit: what the caller needs besides
    // Of the options' seed, whose random shadows they all have; and of how many frames, which are
    // one picture.
    int shadow_frame = 0, shadow_frames = 1;
    FragmentSink* sink = nullptr;  // takes the transparent fragments too
    // Tiles without a pixel of it are left out; null: none are.
    const PixelRect* only = nullptr;
};

// The pictures of the takes; options.method and accumulate are not looked at, and the seed is only
// noted. Fragments are rasterised and shaded once for all takes that want them in the same order.
// The stats of a take hold shared times as if it were alone, and the process's peak memory.
FrameTakes render_takes(const Scene& scene, const View& view, const Options& options,
                        const TakesRequest& request);

// As sheer::render, for a scene that has passed check_scene.
Frame render_frame(const Scene& scene, const View& view, const Options& options);

}  // namespace sheer
