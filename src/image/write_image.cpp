// Pictures to files.
#include "image/write_image.h"

#include "image/format.h"
#include "support/whole_file.h"

namespace sheer {

void write_image(const std::string& path, const Image& image)
{
    write_whole_file(path, format_to_write(path).encode(image));
}

void check_image_path(const std::string& path)
{
    format_to_write(path);
    check_writable(path);
}

}  // namespace sheer
