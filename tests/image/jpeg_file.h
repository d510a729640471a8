// JPEG files of flat 8 x 8 blocks at quality 100 without subsampling. A flat block's only
// coefficient is 8 times its value, a whole number, and quality 100 divides it by 1: what is stored
// comes back exactly, and what differs is the rounding of colour conversions.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>  // jpeglib.h needs it

#include <cstdlib>
#include <vector>

#include <jpeglib.h>

namespace sheer::jpeg_file {

using Bytes = std::vector<std::uint8_t>;
using Samples = std::array<std::uint8_t, 4>;

struct File {
    unsigned width, height;  // pixels
    J_COLOR_SPACE given, stored;
    std::vector<Samples> blocks;  // row by row, rounded up to whole blocks
    bool progressive = false;
    bool adobe_marker = true;  // of CMYK and YCCK
};

inline int channels(J_COLOR_SPACE space)
{
    return space == JCS_GRAYSCALE ? 1 : space == JCS_RGB ? 3 : 4;
}

inline Bytes make_jpeg(const File& file)
{
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &memory, &size);
    jpeg.image_width = file.width;
    jpeg.image_height = file.height;
    jpeg.input_components = channels(file.given);
    jpeg.in_color_space = file.given;
    jpeg_set_defaults(&jpeg);
    jpeg_set_colorspace(&jpeg, file.stored);
    jpeg_set_quality(&jpeg, 100, TRUE);
    for (int c = 0; c < jpeg.num_components; ++c) {
        jpeg.comp_info[c].h_samp_factor = jpeg.comp_info[c].v_samp_factor = 1;
    }
    if (file.progressive) jpeg_simple_progression(&jpeg);
    if (!file.adobe_marker) jpeg.write_Adobe_marker = FALSE;
    jpeg_start_compress(&jpeg, TRUE);
    const unsigned blocks_wide = (file.width + 7) / 8;
    for (unsigned y = 0; y < file.height; ++y) {
        Bytes row;
        for (unsigned x = 0; x < file.width; ++x) {
            const Samples& samples = file.blocks.at(y / 8 * blocks_wide + x / 8);
            row.insert(row.end(), samples.begin(), samples.begin() + channels(file.given));
        }
        JSAMPROW rows = row.data();
        jpeg_write_scanlines(&jpeg, &rows, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    Bytes bytes(memory, memory + size);
    std::free(memory);
    return bytes;
}

}  // namespace sheer::jpeg_file
