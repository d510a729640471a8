// JPEG through libjpeg.
#include "image/jpeg.h"

#include <array>
#include <cstdint>
#include <vector>

#include <sheer/error.h>

#include "image/color.h"
#include "image/jpeg_reader.h"

namespace sheer {

Image decode_jpeg(std::span<const std::byte> bytes, const std::string& path)
{
    JpegReader reader({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, path);
    const std::size_t width = reader.header().width, height = reader.header().height;
    if (width > kMaxImageSize || height > kMaxImageSize) {
        reader.refuse("larger than " + std::to_string(kMaxImageSize) + " pixels");
    }
    std::vector<std::uint8_t> samples(4 * width * height);
    reader.read_samples(samples.data());

    std::array<float, 256> linear;
    for (std::size_t i = 0; i < linear.size(); ++i) {
        linear[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / 255));
    }
    Image image(static_cast<int>(width), static_cast<int>(height));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const std::uint8_t* rgb = &samples[4 * i];
        image.pixels[i] = {linear[rgb[0]], linear[rgb[1]], linear[rgb[2]], 1};
    }
    return image;
}

}  // namespace sheer
