// JPEG files in memory.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <sheer/image.h>

namespace sheer {

// Any JPEG, as sRGB, opaque: grey becomes RGB, ink (CMYK) what is left of white light. Profiles and
// orientations in the file are not looked at. Throws Error(Fault::input), with the path before what
// is wrong.
Image decode_jpeg(std::span<const std::byte> bytes, const std::string& path);

}  // namespace sheer
