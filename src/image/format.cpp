// The table of formats.
#include "image/format.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <sheer/error.h>

#include "image/exr.h"
#include "image/png.h"

namespace sheer {
namespace {

constexpr std::array<ImageFormat, 2> kFormats = {
    {{".exr", encode_exr, decode_exr}, {".png", encode_png, decode_png}}};

}  // namespace

const ImageFormat& image_format(const std::string& path)
{
    std::string suffix = std::filesystem::path(path).extension().string();
    for (char& c : suffix) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    const auto* found =
        std::find_if(kFormats.begin(), kFormats.end(),
                     [&](const ImageFormat& format) { return format.suffix == suffix; });
    if (found == kFormats.end()) {
        throw Error(Fault::input, path + ": unknown picture format; use .exr or .png");
    }
    return *found;
}

}  // namespace sheer
