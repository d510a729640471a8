// libjpeg reports errors through a function that must not return; it leaves by longjmp here. The
// functions between setjmp and longjmp (read_header, read_rows) therefore own nothing that would
// need a destructor.
#include "image/jpeg_reader.h"

#include <jerror.h>
#include <sheer/error.h>

namespace sheer {

namespace {

// A progressive file may go over the whole picture again and again; real ones do so a dozen times.
constexpr std::uint64_t kMostScans = 500;

// In all scans together: sixteen of the largest picture. Each pass takes memory's time even where
// it says next to nothing, and could be asked for by a few hundred bytes.
constexpr std::uint64_t kMostScannedPixels = std::uint64_t{1} << 32;

// A block of samples takes one bit at least, and covers 32 x 32 pixels at most.
constexpr std::size_t kMostPixelsPerByte = 8 * 32 * 32;

}  // namespace

JpegReader::JpegReader(std::span<const std::uint8_t> bytes, const std::string& path) : path_(path)
{
    jpeg_.err = jpeg_std_error(&errors_.manager);
    errors_.manager.error_exit = keep_error;
    errors_.manager.emit_message = take_message;
    progress_.progress_monitor = limit_scans;
    const bool read = read_header(bytes);
    header_ = {jpeg_.image_width, jpeg_.image_height};
    const std::uint64_t pixels = std::uint64_t{header_.width} * header_.height;
    try {
        if (!read) refuse(errors_.text);
        if (pixels / kMostPixelsPerByte > bytes.size()) refuse("the file is cut short");
    } catch (...) {
        jpeg_destroy_decompress(&jpeg_);
        throw;
    }
}

JpegReader::~JpegReader()
{
    jpeg_destroy_decompress(&jpeg_);
}

void JpegReader::read_samples(std::uint8_t* samples)
{
    if (!read_rows(samples)) refuse(errors_.text);
    if (jpeg_.out_color_space == JCS_CMYK) color_from_ink(samples);
}

void JpegReader::refuse(const std::string& reason) const
{
    throw Error(Fault::input, path_ + ": not a readable JPEG file: " + reason);
}

void JpegReader::fail(Errors& errors, const char* text)
{
    std::snprintf(errors.text, sizeof errors.text, "%s", text);
    std::longjmp(errors.jump, 1);
}

void JpegReader::keep_error(j_common_ptr jpeg)
{
    Errors& errors = *reinterpret_cast<Errors*>(jpeg->err);
    jpeg->err->format_message(jpeg, errors.text);
    std::longjmp(errors.jump, 1);
}

// Where the bytes end libjpeg only warns, and fills the rest with grey.
void JpegReader::take_message(j_common_ptr jpeg, int level)
{
    Errors& errors = *reinterpret_cast<Errors*>(jpeg->err);
    const bool warning = level < 0;
    if (warning && jpeg->err->msg_code == JWRN_JPEG_EOF) fail(errors, "the file is cut short");
}

void JpegReader::limit_scans(j_common_ptr jpeg)
{
    const auto picture = reinterpret_cast<j_decompress_ptr>(jpeg);
    const auto scans = static_cast<std::uint64_t>(picture->input_scan_number);
    Errors& errors = *reinterpret_cast<Errors*>(jpeg->err);
    if (scans > kMostScans) fail(errors, "more than 500 scans");
    if (scans * picture->image_width * picture->image_height > kMostScannedPixels) {
        fail(errors, "more scans than a picture of this size needs");
    }
}

// False: errors_.text says why.
bool JpegReader::read_header(std::span<const std::uint8_t> bytes)
{
    if (setjmp(errors_.jump) != 0) return false;
    jpeg_create_decompress(&jpeg_);
    jpeg_.progress = &progress_;
    jpeg_mem_src(&jpeg_, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&jpeg_, TRUE);
    // Such a file has no size below which it is certainly cut short, and next to nothing reads it.
    if (jpeg_.arith_code != FALSE) fail(errors_, "arithmetic coding is not supported");
    const bool ink = jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK;
    jpeg_.out_color_space = ink ? JCS_CMYK : JCS_EXT_RGBA;
    // These give the same samples on every machine and with every version.
    jpeg_.dct_method = JDCT_ISLOW;
    jpeg_.do_block_smoothing = FALSE;
    return true;
}

bool JpegReader::read_rows(std::uint8_t* samples)
{
    if (setjmp(errors_.jump) != 0) return false;
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
        JSAMPROW row = samples + std::size_t{4} * header_.width * jpeg_.output_scanline;
        jpeg_read_scanlines(&jpeg_, &row, 1);
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
}

// Cyan, magenta, yellow and black ink each let pass a part of white light. Adobe's programs write
// that part, and say that they are Adobe's; others write the ink.
void JpegReader::color_from_ink(std::uint8_t* samples) const
{
    const std::size_t pixels = std::size_t{header_.width} * header_.height;
    const int flip = jpeg_.saw_Adobe_marker != FALSE ? 0 : 255;
    for (std::uint8_t* p = samples; p != samples + 4 * pixels; p += 4) {
        const int black = p[3] ^ flip;
        for (int c = 0; c < 3; ++c) {
            p[c] = static_cast<std::uint8_t>(((p[c] ^ flip) * black + 127) / 255);
        }
        p[3] = 255;
    }
}

}  // namespace sheer
