// PNG through libpng: its simplified interface for writing, the full one for reading, which keeps
// 16 bits as they are. libpng reports errors by longjmp; the functions between setjmp and longjmp
// (read_header, read_pixels) therefore own nothing that would need a destructor.
#include "image/png.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <png.h>
#include <sheer/error.h>

#include "image/color.h"
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

// What reading needs at hand when libpng calls back.
struct Source {
    std::span<const std::byte> rest;
    char error[128] = "";
};

void read_bytes(png_structp png, png_bytep to, std::size_t count)
{
    Source& source = *static_cast<Source*>(png_get_io_ptr(png));
    if (count > source.rest.size()) png_error(png, "the file is cut short");
    std::memcpy(to, source.rest.data(), count);
    source.rest = source.rest.subspan(count);
}

[[noreturn]] void keep_error(png_structp png, png_const_charp text)
{
    Source& source = *static_cast<Source*>(png_get_error_ptr(png));
    std::snprintf(source.error, sizeof source.error, "%s", text);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

struct Header {
    png_uint_32 width = 0, height = 0;
    int depth = 0;  // bits of a sample once expanded: 8 or 16
    std::size_t row_bytes = 0;
    double gamma = 0;  // encoded = linear^gamma; 0: sRGB
};

double file_gamma(png_structp png, png_infop info)
{
    double gamma = 0;
    const bool overruled = png_get_valid(png, info, PNG_INFO_sRGB | PNG_INFO_iCCP) != 0;
    if (overruled || png_get_gAMA(png, info, &gamma) == 0) return 0;
    // 1 / 2.2 is how files without an sRGB chunk say sRGB.
    const bool usable = gamma > 0.1 && gamma < 10;
    return !usable || std::abs(gamma - 1 / 2.2) < 0.005 ? 0 : gamma;
}

// False: source.error says why.
bool read_header(png_structp png, png_infop info, Header& header)
{
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_read_info(png, info);
    header.width = png_get_image_width(png, info);
    header.height = png_get_image_height(png, info);
    header.gamma = file_gamma(png, info);
    png_set_expand(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xffff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    header.depth = png_get_bit_depth(png, info);
    header.row_bytes = png_get_rowbytes(png, info);
    return true;
}

bool read_pixels(png_structp png, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_read_image(png, rows);
    png_read_end(png, nullptr);
    return true;
}

// libpng's two structures.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : source_{bytes}
    {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, keep_error, ignore_warning);
        info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
        if (info_ == nullptr) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw Error(Fault::work, "PNG: out of memory");
        }
        png_set_read_fn(png_, &source_, read_bytes);
    }
    ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    bool read(Header& header) { return read_header(png_, info_, header); }
    bool read(png_bytepp rows) { return read_pixels(png_, rows); }
    const char* error() const { return source_.error; }

private:
    Source source_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

// Linear values of all samples a file can hold.
std::vector<float> linear_table(const Header& header)
{
    std::vector<float> table(header.depth == 16 ? 65536 : 256);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double encoded = static_cast<double>(i) / static_cast<double>(table.size() - 1);
        table[i] = static_cast<float>(header.gamma > 0 ? own_pow(encoded, 1 / header.gamma)
                                                       : linear_from_srgb(encoded));
    }
    return table;
}

Image to_linear(const Header& header, const std::vector<std::uint8_t>& bytes)
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
    const auto refuse = [&](const std::string& reason) {
        throw Error(Fault::input, path + ": not a readable PNG file: " + reason);
    };
    Reader reader(bytes);
    Header header;
    if (!reader.read(header)) refuse(reader.error());
    if (header.width > kMaxImageSize || header.height > kMaxImageSize) {
        refuse("larger than " + std::to_string(kMaxImageSize) + " pixels");
    }
    // Deflate shrinks 1032 times at most, and one-bit samples grow 32 times when expanded: a file
    // of a few bytes that claims more gets no gigabytes.
    constexpr std::size_t kMostExpansion = 1032 * 32;
    if (header.row_bytes * header.height / kMostExpansion > bytes.size()) {
        refuse("the file is cut short");
    }
    std::vector<std::uint8_t> samples(header.row_bytes * header.height);
    std::vector<png_bytep> rows(header.height);
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = &samples[y * header.row_bytes];
    if (!reader.read(rows.data())) refuse(reader.error());
    return to_linear(header, samples);
}

}  // namespace sheer
