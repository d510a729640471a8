// Pictures from files.
#include "image/read_image.h"

#include <span>

#include "image/format.h"
#include "support/read_file.h"

namespace sheer {

Image read_image(const std::string& path)
{
    const ImageFormat& format = format_to_read(path);
    const Bytes bytes = read_file(path);
    return format.decode(std::as_bytes(std::span(bytes)), path);
}

}  // namespace sheer
