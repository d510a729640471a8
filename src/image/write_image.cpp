// The table of formats, and writing through it.
#include "image/write_image.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include <sheer/error.h>

#include "image/exr.h"
#include "image/png.h"
#include "support/whole_file.h"

namespace sheer {
namespace {

struct Format {
    std::string_view suffix;
    std::vector<std::byte> (*encode)(const Image& image);
};

constexpr std::array<Format, 2> kFormats = {{{".exr", encode_exr}, {".png", encode_png}}};

const Format& format_of(const std::string& path)
{
    std::string suffix = std::filesystem::path(path).extension().string();
    for (char& c : suffix) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    const auto* found = std::find_if(kFormats.begin(), kFormats.end(),
                                     [&](const Format& format) { return format.suffix == suffix; });
    if (found == kFormats.end()) {
        throw Error(Fault::input, path + ": unknown picture format; use .exr or .png");
    }
    return *found;
}

}  // namespace

void write_image(const std::string& path, const Image& image)
{
    write_whole_file(path, format_of(path).encode(image));
}

void check_image_path(const std::string& path)
{
    format_of(path);
    check_writable(path);
}

}  // namespace sheer
