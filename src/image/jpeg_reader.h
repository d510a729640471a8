// JPEG files read through libjpeg in two steps: how large the picture is, then its samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>  // jpeglib.h needs it

#include <csetjmp>
#include <span>
#include <string>

#include <jpeglib.h>

namespace sheer {

struct JpegHeader {
    std::uint32_t width = 0, height = 0;
};

class JpegReader {
public:
    // Reads the header. `bytes` must outlive the reader; `path` is for messages. Throws
    // Error(Fault::input), as read_samples does, "<path>: not a readable JPEG file: <why>".
    JpegReader(std::span<const std::uint8_t> bytes, const std::string& path);
    ~JpegReader();
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    const JpegHeader& header() const { return header_; }

    // All of them, once: 8-bit RGBA rows from the top, opaque. Damage that libjpeg can guess its
    // way around is let pass; a file that ends early is not.
    void read_samples(std::uint8_t* samples);

    [[noreturn]] void refuse(const std::string& reason) const;

private:
    struct Errors {
        jpeg_error_mgr manager = {};  // the first member: what libjpeg hands back points at it
        std::jmp_buf jump = {};
        char text[JMSG_LENGTH_MAX] = "";
    };

    [[noreturn]] static void fail(Errors& errors, const char* text);
    [[noreturn]] static void keep_error(j_common_ptr jpeg);
    static void take_message(j_common_ptr jpeg, int level);
    static void limit_scans(j_common_ptr jpeg);
    bool read_header(std::span<const std::uint8_t> bytes);
    bool read_rows(std::uint8_t* samples);
    void color_from_ink(std::uint8_t* samples) const;

    Errors errors_;
    jpeg_progress_mgr progress_ = {};
    jpeg_decompress_struct jpeg_ = {};
    std::string path_;
    JpegHeader header_;
};

}  // namespace sheer
