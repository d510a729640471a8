// Debug channels to a file.
#pragma once

#include <string>

#include <sheer/render.h>

namespace sheer {

// OpenEXR, one 32-bit float channel each: fragments, depth_complexity, coverage, depth. Throws
// Error as write_image does.
void write_channels(const std::string& path, int width, int height, const Channels& channels);

// What that would find wrong with the path. All of it is Fault::input.
void check_channels_path(const std::string& path);

}  // namespace sheer
