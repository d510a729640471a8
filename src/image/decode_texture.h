// Pictures for textures, from files in memory: PNG and JPEG.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <sheer/scene.h>

namespace sheer {

// What is refused before memory is asked for.
struct TextureLimits {
    int most_size = kMaxImageSize;           // texels, of the width and of the height
    std::uint64_t most_texels = 1ull << 28;  // a gibibyte: the largest of these
};

// True of what begins as PNG and JPEG files do.
bool is_texture_known(std::span<const std::uint8_t> bytes);

// A PNG's or JPEG's content as 8-bit straight RGBA: 16 bits are rounded to the nearest of 8, grey
// and palettes become RGB, ink (CMYK) what is left of white light. Texels are taken as they are:
// gamma, colour profiles and orientations in the file are not looked at. The name is left empty.
// `what` is for messages. Throws Error(Fault::input), "<what>: <fault>", where the file is neither,
// is broken or cut short, or is beyond the limits.
TextureImage decode_texture(const std::string& what, std::span<const std::uint8_t> bytes,
                            const TextureLimits& limits = {});

}  // namespace sheer
