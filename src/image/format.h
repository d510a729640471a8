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
    std::vector<std::byte> (*encode)(const Image& image);  // null: is read only
    Image (*decode)(std::span<const std::byte> bytes, const std::string& path);
};

// By the path's suffix, in small or capital letters: .exr or .png, and to read .jpg or .jpeg too.
// Throws Error(Fault::input) for another.
const ImageFormat& format_to_read(const std::string& path);
const ImageFormat& format_to_write(const std::string& path);

}  // namespace sheer
