// The table of formats.
#include "image/format.h"

#include <array>
#include <filesystem>

#include <sheer/error.h>

#include "image/exr.h"
#include "image/jpeg.h"
#include "image/png.h"

namespace sheer {
namespace {

constexpr std::array<ImageFormat, 4> kFormats = {{{".exr", encode_exr, decode_exr},
                                                  {".png", encode_png, decode_png},
                                                  {".jpg", nullptr, decode_jpeg},
                                                  {".jpeg", nullptr, decode_jpeg}}};

// Null for a suffix that is none of a format's.
const ImageFormat* find_format(const std::string& path)
{
    std::string suffix = std::filesystem::path(path).extension().string();
    for (char& c : suffix) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    for (const ImageFormat& format : kFormats) {
        if (format.suffix == suffix) return &format;
    }
    return nullptr;
}

}  // namespace

const ImageFormat& format_to_read(const std::string& path)
{
    if (const ImageFormat* format = find_format(path)) return *format;
    throw Error(Fault::input, path + ": unknown picture format; use .exr, .png or .jpg");
}

const ImageFormat& format_to_write(const std::string& path)
{
    const ImageFormat* format = find_format(path);
    if (format == nullptr) {
        throw Error(Fault::input, path + ": unknown picture format; use .exr or .png");
    }
    if (format->encode == nullptr) {
        throw Error(Fault::input, path + ": JPEG files are only read; use .exr or .png");
    }
    return *format;
}

}  // namespace sheer
