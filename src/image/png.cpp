// PNG through libpng: its simplified interface for writing, the full one for reading, which keeps
// 16 bits as they are.
#include "image/png.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <png.h>
#include <sheer/error.h>

#include "image/color.h"
#include "image/png_reader.h"
#include "support/math.h"

namespace sheer {
namespace {

std::uint8_t alpha8(float alpha)
{
    return static_cast<std::uint8_t>(alpha >= 1 ? 255 : alpha > 0 ? 255 * double{alpha} + 0.5 : 0);
}

double straight(float premultiplied, float alpha)
{
    if (!(alpha > 0)) return 0;
    return double{premultiplied} / std::min(double{alpha}, 1.0);
}

// Rows of 8-bit samples, 3 or 4 to the pixel.
std::vector<std::uint8_t> to_srgb8(const Image& image, bool with_alpha)
{
    std::vector<std::uint8_t> samples;
    samples.reserve(image.pixels.size() * (with_alpha ? 4 : 3));
    for (const std::array<float, 4>& pixel : image.pixels) {
        for (std::size_t c = 0; c < 3; ++c) {
            samples.push_back(srgb8_from_linear(straight(pixel[c], pixel[3])));
        }
        if (with_alpha) samples.push_back(alpha8(pixel[3]));
    }
    return samples;
}

// Linear values of all samples a file can hold.
std::vector<float> linear_table(const PngHeader& header)
{
    std::vector<float> table(header.depth == 16 ? 65536 : 256);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double encoded = static_cast<double>(i) / static_cast<double>(table.size() - 1);
        table[i] = static_cast<float>(header.gamma > 0 ? own_pow(encoded, 1 / header.gamma)
                                                       : linear_from_srgb(encoded));
    }
    return table;
}

Image to_linear(const PngHeader& header, const std::vector<std::uint8_t>& bytes)
{
    const std::vector<float> table = linear_table(header);
    const auto largest = static_cast<float>(table.size() - 1);
    Image image(static_cast<int>(header.width), static_cast<int>(header.height));
    const std::uint8_t* next = bytes.data();
    for (std::array<float, 4>& pixel : image.pixels) {
        std::array<std::size_t, 4> sample;
        for (std::size_t& s : sample) {
            s = *next++;
            if (header.depth == 16) s = s << 8 | *next++;
        }
        const float alpha = static_cast<float>(sample[3]) / largest;
        pixel = {table[sample[0]] * alpha, table[sample[1]] * alpha, table[sample[2]] * alpha,
                 alpha};
    }
    return image;
}

}  // namespace

std::vector<std::byte> encode_png(const Image& image)
{
    if (image.pixels.empty()) throw Error(Fault::work, "PNG: the picture has no pixels");
    const bool opaque = std::all_of(image.pixels.begin(), image.pixels.end(),
                                    [](const auto& pixel) { return alpha8(pixel[3]) == 255; });
    const std::vector<std::uint8_t> samples = to_srgb8(image, !opaque);

    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::vector<std::byte> bytes(size);
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, samples.data(), 0, nullptr) == 0) {
        throw Error(Fault::work, std::string("PNG: ") + png.message);
    }
    bytes.resize(size);
    return bytes;
}

Image decode_png(std::span<const std::byte> bytes, const std::string& path)
{
    PngReader reader(bytes, path, PngDepth::as_stored);
    const PngHeader& header = reader.header();
    if (header.width > kMaxImageSize || header.height > kMaxImageSize) {
        reader.refuse("larger than " + std::to_string(kMaxImageSize) + " pixels");
    }
    std::vector<std::uint8_t> samples(header.row_bytes * header.height);
    reader.read_samples(samples.data());
    return to_linear(header, samples);
}

}  // namespace sheer
