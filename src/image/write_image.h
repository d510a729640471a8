// Pictures to files, in the format that the file's name asks for.
#pragma once

#include <string>

#include <sheer/image.h>

namespace sheer {

// .exr or .png, in small or capital letters; the file appears whole or not at all. Throws Error:
// Fault::input for another suffix, Fault::work where writing fails.
void write_image(const std::string& path, const Image& image);

// Throws what write_image(path, ...) would find wrong before it has a picture; for use before
// rendering. All of it is Fault::input.
void check_image_path(const std::string& path);

}  // namespace sheer
