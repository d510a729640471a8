// PNG: exact values out, every kind of file in, broken ones refused.
#include "image/png.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <sheer/error.h>

#include "image/color.h"
#include "image/png_file.h"

namespace sheer {
namespace {

using namespace png_file;
using Rgba = std::array<float, 4>;

float linear(double encoded)
{
    return static_cast<float>(linear_from_srgb(encoded));
}

Image one_pixel(const Rgba& pixel)
{
    Image image(1, 1);
    image.pixels[0] = pixel;
    return image;
}

bool has_chunk(const Bytes& bytes, const std::string& type)
{
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.find(type) != std::string::npos;
}

int color_type(const Bytes& bytes)
{
    return static_cast<int>(bytes.at(25));
}

TEST(Png, RoundTripKeepsAllColorsOfOpaquePictures)
{
    Image image(256, 3);
    for (int i = 0; i < 256; ++i) {
        const float v = linear(i / 255.0);
        image.at(i, 0) = {v, 0, 1, 1};
        image.at(i, 1) = {1, v, 0, 1};
        image.at(i, 2) = {0, 1, v, 1};
    }
    const Bytes bytes = encode_png(image);
    EXPECT_EQ(color_type(bytes), kRgb);
    EXPECT_TRUE(has_chunk(bytes, "sRGB"));
    EXPECT_FALSE(has_chunk(bytes, "tIME"));
    const Image read = decode_png(bytes, "a.png");
    EXPECT_EQ(read.width, 256);
    EXPECT_EQ(read.height, 3);
    EXPECT_EQ(read.pixels, image.pixels);
    EXPECT_EQ(encode_png(image), bytes);
}

TEST(Png, TransparentPicturesHoldStraightColor)
{
    Image image(2, 1);
    const float alpha = 51 / 255.0f;
    image.at(0, 0) = {linear(1) * alpha, linear(0.6) * alpha, 0, alpha};
    image.at(1, 0) = {0, 0, 0, 1};
    const Bytes bytes = encode_png(image);
    EXPECT_EQ(color_type(bytes), kRgba);
    const Image read = decode_png(bytes, "a.png");
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_FLOAT_EQ(read.at(0, 0)[c], image.at(0, 0)[c]);
        EXPECT_EQ(read.at(1, 0)[c], image.at(1, 0)[c]);
    }
    EXPECT_EQ(encode_png(read), bytes);
}

TEST(Png, OddValuesAreClamped)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const auto read = [](const Rgba& pixel) {
        return decode_png(encode_png(one_pixel(pixel)), "a.png").pixels[0];
    };
    EXPECT_EQ(read({nan, -1, 2, 1}), (Rgba{0, 0, 1, 1}));
    EXPECT_EQ(read({infinity, -infinity, 0.0f, 1}), (Rgba{1, 0, 0, 1}));
    EXPECT_EQ(read({1, 1, 1, nan}), (Rgba{0, 0, 0, 0}));
    EXPECT_EQ(read({1, 1, 1, -1}), (Rgba{0, 0, 0, 0}));
    EXPECT_EQ(read({1, 0, 1, infinity}), (Rgba{1, 0, 1, 1}));
    EXPECT_EQ(color_type(encode_png(one_pixel({1, 1, 1, 1 - 1e-6f}))), kRgb);
}

TEST(Png, PicturesWithoutPixelsAreRefused)
{
    EXPECT_THROW(encode_png(Image()), Error);
}

TEST(Png, ReadsGreyOfFewBits)
{
    // One bit: 1 0 1; two bits: 0 1 2 3.
    const Image one = decode_png(make_png({3, 1, 1, kGrey, text_of({0, 0xa0})}), "a.png");
    EXPECT_EQ(one.at(0, 0), (Rgba{1, 1, 1, 1}));
    EXPECT_EQ(one.at(1, 0), (Rgba{0, 0, 0, 1}));
    const Image two = decode_png(make_png({4, 1, 2, kGrey, text_of({0, 0x1b})}), "a.png");
    for (int x = 0; x < 4; ++x) {
        const float v = linear(x / 3.0);
        EXPECT_EQ(two.at(x, 0), (Rgba{v, v, v, 1}));
    }
}

TEST(Png, ReadsPalettesWithTransparency)
{
    const std::string chunks =
        chunk("PLTE", text_of({255, 0, 0, 0, 255, 0})) + chunk("tRNS", text_of({255, 51}));
    const Image image = decode_png(make_png({2, 1, 4, kPalette, text_of({0, 0x01}), chunks}), "a");
    EXPECT_EQ(image.at(0, 0), (Rgba{1, 0, 0, 1}));
    EXPECT_EQ(image.at(1, 0), (Rgba{0, 51 / 255.0f, 0, 51 / 255.0f}));
}

TEST(Png, ReadsAllSixteenBits)
{
    const std::string row = text_of({0, 0x80, 0x01, 0x00, 0x01, 0xff, 0xff, 0x40, 0x00});
    const Image image = decode_png(make_png({1, 1, 16, kRgba, row}), "a.png");
    const float alpha = 0x4000 / 65535.0f;
    EXPECT_EQ(image.pixels[0],
              (Rgba{linear(0x8001 / 65535.0) * alpha, linear(1 / 65535.0) * alpha, alpha, alpha}));
}

TEST(Png, HonoursGamma)
{
    const auto read = [](const std::string& chunks) {
        return decode_png(make_png({1, 1, 8, kGrey, text_of({0, 51}), chunks}), "a").pixels[0][0];
    };
    const std::string linear_light = chunk("gAMA", big_endian(100000));
    EXPECT_FLOAT_EQ(read(linear_light), 0.2f);
    EXPECT_FLOAT_EQ(read(chunk("gAMA", big_endian(50000))), 0.04f);
    EXPECT_EQ(read(chunk("gAMA", big_endian(45455))), linear(0.2));
    EXPECT_EQ(read(chunk("sRGB", text_of({0})) + linear_light), linear(0.2));
}

void expect_refused(const Bytes& bytes, const std::string& reason)
{
    try {
        decode_png(bytes, "dir/a.png");
        ADD_FAILURE() << "read: " << reason;
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_EQ(text.rfind("dir/a.png: not a readable PNG file: ", 0), 0u) << text;
        EXPECT_NE(text.find(reason), std::string::npos) << text;
        EXPECT_EQ(error.fault(), Fault::input);
    }
}

TEST(Png, RefusesEveryTruncatedFile)
{
    const Bytes whole = encode_png(one_pixel({1, 0.5f, 0.25f, 0.5f}));
    for (std::size_t size = 0; size < whole.size(); ++size) {
        // A copy of its own, so that the sanitizer sees reads past its end.
        expect_refused(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)), "");
    }
}

TEST(Png, RefusesDamagedFiles)
{
    const Bytes whole = encode_png(one_pixel({1, 0.5f, 0.25f, 0.5f}));
    for (std::size_t i = 0; i < whole.size() - 12; ++i) {
        Bytes damaged = whole;
        damaged[i] ^= std::byte{0x10};
        // Some damage is harmless; what matters is that reading ends, one way or the other.
        try {
            decode_png(damaged, "a.png");
        } catch (const Error&) {
        }
    }
    Bytes damaged = whole;
    damaged[0] = std::byte{0};
    expect_refused(damaged, "Not a PNG file");
}

TEST(Png, RefusesSizesThatItCannotHold)
{
    expect_refused(make_png({16385, 1, 8, kGrey, text_of({0})}), "larger than 16384 pixels");
    expect_refused(make_png({16384, 16384, 16, kRgba, text_of({0})}), "the file is cut short");
}

}  // namespace
}  // namespace sheer
