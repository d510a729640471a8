// The picture formats that there are.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sheer/image.h>

namespace sheer {

struct ImageFormat {
    std::string_view suffix;
    std::vector<std::byte> (*encode)(const Image& image);
    Image (*decode)(std::span<const std::byte> bytes, const std::string& path);
};

// By the path's suffix, .exr or .png, in small or capital letters. Throws Error(Fault::input) for
// another.
const ImageFormat& image_format(const std::string& path);

}  // namespace sheer
