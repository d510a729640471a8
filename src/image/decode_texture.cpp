// Picks the decoder by a file's first bytes.
#include "image/decode_texture.h"

#include <algorithm>
#include <array>

#include <sheer/error.h>

#include "image/jpeg_reader.h"
#include "image/png_reader.h"

namespace sheer {

namespace {

constexpr std::array<std::uint8_t, 8> kPngStart = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::array<std::uint8_t, 3> kJpegStart = {0xff, 0xd8, 0xff};

template <std::size_t Size>
bool starts_with(std::span<const std::uint8_t> bytes, const std::array<std::uint8_t, Size>& start)
{
    return bytes.size() >= Size && std::equal(start.begin(), start.end(), bytes.begin());
}

template <class Reader>
TextureImage read_within(Reader& reader, const std::string& what, const TextureLimits& limits)
{
    const std::uint64_t width = reader.header().width, height = reader.header().height;
    const auto most = static_cast<std::uint64_t>(limits.most_size);
    if (width > most || height > most) {
        throw Error(Fault::input, what + ": larger than " + std::to_string(most) + " texels");
    }
    if (width * height > limits.most_texels) {
        throw Error(Fault::input, what + ": more than " + std::to_string(limits.most_texels) +
                                      " texels, which is what --most-texels leaves");
    }
    TextureImage image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.texels.resize(static_cast<std::size_t>(width * height));
    static_assert(sizeof image.texels[0] == 4);
    reader.read_samples(image.texels[0].data());
    return image;
}

}  // namespace

bool is_texture_known(std::span<const std::uint8_t> bytes)
{
    return starts_with(bytes, kPngStart) || starts_with(bytes, kJpegStart);
}

TextureImage decode_texture(const std::string& what, std::span<const std::uint8_t> bytes,
                            const TextureLimits& limits)
{
    if (starts_with(bytes, kPngStart)) {
        PngReader reader(std::as_bytes(bytes), what, PngDepth::eight_bits);
        return read_within(reader, what, limits);
    }
    if (starts_with(bytes, kJpegStart)) {
        JpegReader reader(bytes, what);
        return read_within(reader, what, limits);
    }
    throw Error(Fault::input, what + ": neither a PNG nor a JPEG file");
}

}  // namespace sheer
