// PNG files read through libpng in two steps: what the file holds, then its samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <png.h>

namespace sheer {

// RGBA samples with straight alpha, whatever the file holds.
struct PngHeader {
    png_uint_32 width = 0, height = 0;
    int depth = 0;  // bits of a sample: 8 or 16, the latter big-endian
    std::size_t row_bytes = 0;
    double gamma = 0;  // encoded = linear^gamma; 0: sRGB
};

enum class PngDepth {
    as_stored,   // 16 bits stay 16 bits, fewer than 8 are expanded to 8
    eight_bits,  // 16 bits are rounded to the nearest of 8
};

class PngReader {
public:
    // Reads the header. `bytes` must outlive the reader; `path` is for messages. Throws
    // Error(Fault::input), as read_samples does, "<path>: not a readable PNG file: <why>".
    PngReader(std::span<const std::byte> bytes, const std::string& path, PngDepth depth);
    ~PngReader();
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    const PngHeader& header() const { return header_; }

    // All of them, once: header().height rows of header().row_bytes, from the top.
    void read_samples(std::uint8_t* samples);

    [[noreturn]] void refuse(const std::string& reason) const;

private:
    struct Source {
        std::span<const std::byte> rest;
        char error[128] = "";
    };

    static void read_bytes(png_structp png, png_bytep to, std::size_t count);
    [[noreturn]] static void keep_error(png_structp png, png_const_charp text);
    bool read_header(PngDepth depth);
    bool read_rows(png_bytepp rows);

    Source source_;
    std::string path_;
    PngHeader header_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

}  // namespace sheer
