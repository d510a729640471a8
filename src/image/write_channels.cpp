// Debug channels to OpenEXR.
#include "image/write_channels.h"

#include <array>

#include <sheer/error.h>

#include "image/exr.h"
#include "image/format.h"
#include "support/whole_file.h"

namespace sheer {

void write_channels(const std::string& path, int width, int height, const Channels& channels)
{
    const std::array<ExrChannel, 5> all = {{
        {"fragments", channels.fragments.data(), 1},
        {"depth_complexity", channels.depth_complexity.data(), 1},
        {"coverage", channels.coverage.data(), 1},
        {"depth", channels.depth.data(), 1},
        {"frames", channels.frames.data(), 1},
    }};
    write_whole_file(path, encode_exr(width, height, all));
}

void check_channels_path(const std::string& path)
{
    if (format_to_write(path).suffix != ".exr") {
        throw Error(Fault::input, path + ": channels go into an .exr file");
    }
    check_writable(path);
}

}  // namespace sheer
