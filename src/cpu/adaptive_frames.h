// How many frames each pixel of a random method's picture gets.
#pragma once

#include <cstdint>
#include <vector>

#include <sheer/render.h>

#include "cpu/frame.h"

namespace sheer {

// Frames that measure the variance and are not shown.
inline constexpr int kPilotFrames = 4;

// Of each pixel, row by row, from pilot frames, whose times `pilots` gets; options.adaptive asks
// for them.
std::vector<std::uint16_t> plan_frames(const Scene& scene, const View& view, const Options& options,
                                       Stats& pilots);

// The same from what the pilots gave: the variance of one frame's pixels, and their mean, which
// `relative` looks at. Variances are averaged over 5x5 pixels first: of so few frames each pixel's
// own says little.
std::vector<std::uint16_t> share_frames(const AdaptiveFrames& adaptive, const Image& variance,
                                        const Image& mean);

// Over the picture; and of each pixel.
double mean_frames(const Take& take);
std::vector<float> frames_channel(const Take& take, const View& view);

}  // namespace sheer
