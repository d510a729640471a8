// Pictures from files.
#pragma once

#include <string>

#include <sheer/image.h>

namespace sheer {

// .exr, .png or .jpg, in small or capital letters, whatever wrote it. Throws Error(Fault::input),
// with the path before what is wrong: another suffix, no such file, no picture in it.
Image read_image(const std::string& path);

}  // namespace sheer
