// Pictures to files.
#include "image/write_image.h"

#include "image/format.h"
#include "support/whole_file.h"

namespace sheer {

void write_image(const std::string& path, const Image& image)
{
    write_whole_file(path, image_format(path).encode(image));
}

void check_image_path(const std::string& path)
{
    image_format(path);
    check_writable(path);
}

}  // namespace sheer
