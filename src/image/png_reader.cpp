// libpng reports errors by longjmp; the functions between setjmp and longjmp (read_header,
// read_rows) therefore own nothing that would need a destructor.
#include "image/png_reader.h"

#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <vector>

#include <sheer/error.h>

namespace sheer {

namespace {

void ignore_warning(png_structp, png_const_charp) {}

double file_gamma(png_structp png, png_infop info)
{
    double gamma = 0;
    const bool overruled = png_get_valid(png, info, PNG_INFO_sRGB | PNG_INFO_iCCP) != 0;
    if (overruled || png_get_gAMA(png, info, &gamma) == 0) return 0;
    // 1 / 2.2 is how files without an sRGB chunk say sRGB.
    const bool usable = gamma > 0.1 && gamma < 10;
    return !usable || std::abs(gamma - 1 / 2.2) < 0.005 ? 0 : gamma;
}

}  // namespace

PngReader::PngReader(std::span<const std::byte> bytes, const std::string& path, PngDepth depth)
    : source_{bytes}, path_(path)
{
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, keep_error, ignore_warning);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    try {
        if (info_ == nullptr) throw Error(Fault::work, path_ + ": there is not enough memory");
        png_set_read_fn(png_, &source_, read_bytes);
        if (!read_header(depth)) refuse(source_.error);
        // Deflate shrinks 1032 times at most, and one-bit samples grow 32 times when expanded: a
        // file of a few bytes that claims more gets no gigabytes.
        constexpr std::size_t kMostExpansion = 1032 * 32;
        if (header_.row_bytes * header_.height / kMostExpansion > bytes.size()) {
            refuse("the file is cut short");
        }
    } catch (...) {
        png_destroy_read_struct(&png_, &info_, nullptr);
        throw;
    }
}

PngReader::~PngReader()
{
    png_destroy_read_struct(&png_, &info_, nullptr);
}

void PngReader::read_samples(std::uint8_t* samples)
{
    std::vector<png_bytep> rows(header_.height);
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = samples + y * header_.row_bytes;
    if (!read_rows(rows.data())) refuse(source_.error);
}

void PngReader::refuse(const std::string& reason) const
{
    throw Error(Fault::input, path_ + ": not a readable PNG file: " + reason);
}

void PngReader::read_bytes(png_structp png, png_bytep to, std::size_t count)
{
    Source& source = *static_cast<Source*>(png_get_io_ptr(png));
    if (count > source.rest.size()) png_error(png, "the file is cut short");
    std::memcpy(to, source.rest.data(), count);
    source.rest = source.rest.subspan(count);
}

void PngReader::keep_error(png_structp png, png_const_charp text)
{
    Source& source = *static_cast<Source*>(png_get_error_ptr(png));
    std::snprintf(source.error, sizeof source.error, "%s", text);
    png_longjmp(png, 1);
}

// False: source_.error says why.
bool PngReader::read_header(PngDepth depth)
{
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    // What has no part in a picture is not unpacked, let alone kept: a few bytes of it may become
    // megabytes, a thousand times.
    static constexpr png_byte kSkipped[] = "tEXt\0zTXt\0iTXt\0sPLT\0pCAL\0eXIf";
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, kSkipped, sizeof kSkipped / 5);
    png_read_info(png_, info_);
    header_.width = png_get_image_width(png_, info_);
    header_.height = png_get_image_height(png_, info_);
    header_.gamma = file_gamma(png_, info_);
    png_set_expand(png_);
    if (depth == PngDepth::eight_bits) png_set_scale_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, 0xffff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    header_.depth = png_get_bit_depth(png_, info_);
    header_.row_bytes = png_get_rowbytes(png_, info_);
    return true;
}

bool PngReader::read_rows(png_bytepp rows)
{
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
}

}  // namespace sheer
