// PNG files in memory.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <sheer/image.h>

namespace sheer {

// 8 bits, sRGB, rounded to the nearest; RGB where all of the picture is opaque (to 8 bits), else
// RGBA with straight colour. Values are clamped to [0, 1], NaN counts as 0. The same picture gives
// the same bytes.
std::vector<std::byte> encode_png(const Image& image);

// Any PNG: grey, palette, 1 to 16 bits, with or without transparency, interlaced. A gAMA chunk is
// honoured where neither an sRGB nor an iCCP chunk overrules it; all else counts as sRGB. Throws
// Error (Fault::input), with the path before what is wrong.
Image decode_png(std::span<const std::byte> bytes, const std::string& path);

}  // namespace sheer
