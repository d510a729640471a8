// OpenEXR files in memory.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <sheer/image.h>

namespace sheer {

// 32-bit float channels R, G, B, A, linear and premultiplied as they are, every bit kept; ZIP
// compression. The same picture gives the same bytes.
std::vector<std::byte> encode_exr(const Image& image);

// One channel of a file: element (x, y) is first[(y * width + x) * step].
struct ExrChannel {
    const char* name;
    const float* first;
    std::size_t step;
};

// The same for any channels of a picture of that size.
std::vector<std::byte> encode_exr(int width, int height, std::span<const ExrChannel> channels);

// Any file with channels R, G and B, or Y for grey; without A it is opaque. The picture is the
// display window, clear where the data window does not reach. Throws Error (Fault::input), with the
// path before what is wrong.
Image decode_exr(std::span<const std::byte> bytes, const std::string& path);

}  // namespace sheer
