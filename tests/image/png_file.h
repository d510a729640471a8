// PNG files made byte by byte, so that reading is not tested against our own writing only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include <zlib.h>

namespace sheer::png_file {

using Bytes = std::vector<std::byte>;

inline constexpr int kGrey = 0, kRgb = 2, kPalette = 3, kRgba = 6;  // PNG's colour types

inline std::string big_endian(std::size_t value)
{
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 255);
    return text;
}

inline std::string chunk(const std::string& type, const std::string& data)
{
    const std::string body = type + data;
    const uLong crc =
        crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return big_endian(data.size()) + body + big_endian(crc);
}

struct File {
    int width, height, depth, color_type;
    std::string rows;         // each with its filter byte, 0, before it
    std::string chunks = "";  // between IHDR and IDAT
    int interlace = 0;        // 1: Adam7, rows being those of its passes
};

inline std::string text_of(std::initializer_list<int> bytes)
{
    std::string text;
    for (const int b : bytes) text += static_cast<char>(b);
    return text;
}

inline Bytes make_png(const File& file)
{
    const std::string header = big_endian(static_cast<std::size_t>(file.width)) +
                               big_endian(static_cast<std::size_t>(file.height)) +
                               text_of({file.depth, file.color_type, 0, 0, file.interlace});
    uLongf size = compressBound(static_cast<uLong>(file.rows.size()));
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size,
             reinterpret_cast<const Bytef*>(file.rows.data()),
             static_cast<uLong>(file.rows.size()));
    packed.resize(size);
    const std::string all = "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + file.chunks +
                            chunk("IDAT", packed) + chunk("IEND", "");
    const auto bytes = std::as_bytes(std::span(all));
    return {bytes.begin(), bytes.end()};
}

}  // namespace sheer::png_file
