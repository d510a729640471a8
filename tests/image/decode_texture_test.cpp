// Textures from PNG and JPEG files: the texels that stand in them, and broken files refused.
#include "image/decode_texture.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include <sheer/error.h>

#include "image/jpeg_file.h"
#include "image/png_file.h"
#include "support/memory.h"

namespace sheer {
namespace {

using png_file::chunk, png_file::kGrey, png_file::kPalette, png_file::kRgb, png_file::kRgba,
    png_file::text_of;
using Bytes = std::vector<std::uint8_t>;
using Texel = std::array<std::uint8_t, 4>;

Bytes png(const png_file::File& file)
{
    const png_file::Bytes bytes = png_file::make_png(file);
    Bytes result;
    for (const std::byte b : bytes) result.push_back(std::to_integer<std::uint8_t>(b));
    return result;
}

std::vector<Texel> texels(const Bytes& bytes)
{
    return decode_texture("a", bytes).texels;
}

std::string message(const Bytes& bytes, const TextureLimits& limits = {})
{
    try {
        decode_texture("dir/a.png", bytes, limits);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "read";
}

void expect_refused(const Bytes& bytes, const std::string& reason, const TextureLimits& limits = {})
{
    const std::string text = message(bytes, limits);
    EXPECT_EQ(text.rfind("dir/a.png: ", 0), 0u) << text;
    EXPECT_NE(text.find(reason), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

TEST(DecodeTexture, KnowsPngAndJpegByTheirFirstBytes)
{
    EXPECT_TRUE(is_texture_known(png({1, 1, 8, kGrey, text_of({0, 7})})));
    EXPECT_TRUE(is_texture_known(Bytes{0xff, 0xd8, 0xff}));
    EXPECT_FALSE(is_texture_known(Bytes{0xff, 0xd8}));
    EXPECT_FALSE(is_texture_known(Bytes{}));
    EXPECT_FALSE(is_texture_known(Bytes{'G', 'I', 'F', '8', '9', 'a', 0, 0}));
    expect_refused(Bytes{'G', 'I', 'F', '8'}, "neither a PNG nor a JPEG file");
    expect_refused(Bytes{}, "neither a PNG nor a JPEG file");
}

TEST(DecodeTexture, PngOfEveryColorType)
{
    const TextureImage image =
        decode_texture("a", png({2, 1, 8, kRgba, text_of({0, 1, 2, 3, 4, 5, 6, 7, 0})}));
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.height, 1);
    EXPECT_EQ(image.texels, (std::vector<Texel>{{1, 2, 3, 4}, {5, 6, 7, 0}}));
    EXPECT_EQ(texels(png({1, 2, 8, kRgb, text_of({0, 9, 8, 7, 0, 6, 5, 4})})),
              (std::vector<Texel>{{9, 8, 7, 255}, {6, 5, 4, 255}}));
    // Two bits: 0 1 2 3, each 85 times as bright.
    EXPECT_EQ(texels(png({4, 1, 2, kGrey, text_of({0, 0x1b})})),
              (std::vector<Texel>{
                  {0, 0, 0, 255}, {85, 85, 85, 255}, {170, 170, 170, 255}, {255, 255, 255, 255}}));
    const std::string colors = chunk("PLTE", text_of({10, 20, 30, 40, 50, 60}));
    EXPECT_EQ(texels(png(
                  {2, 1, 4, kPalette, text_of({0, 0x01}), colors + chunk("tRNS", text_of({128}))})),
              (std::vector<Texel>{{10, 20, 30, 128}, {40, 50, 60, 255}}));
    // The grey named by tRNS is transparent.
    EXPECT_EQ(texels(png({2, 1, 8, kGrey, text_of({0, 5, 6}), chunk("tRNS", text_of({0, 6}))})),
              (std::vector<Texel>{{5, 5, 5, 255}, {6, 6, 6, 0}}));
}

TEST(DecodeTexture, PngOfSixteenBitsIsRounded)
{
    std::string rows;
    for (int y = 0; y < 256; ++y) {
        rows += text_of({0});
        for (int x = 0; x < 256; ++x) rows += text_of({y, x});
    }
    const std::vector<Texel> read = texels(png({256, 256, 16, kGrey, rows}));
    ASSERT_EQ(read.size(), 65536u);
    for (std::size_t i = 0; i < read.size(); ++i) {
        // round(255 i / 65535) = round(i / 257), which has no halves.
        ASSERT_EQ(read[i][0], (2 * i + 257) / 514) << i;
        ASSERT_EQ(read[i][3], 255);
    }
}

TEST(DecodeTexture, PngGammaIsNotLookedAt)
{
    const std::string linear = chunk("gAMA", png_file::big_endian(100000));
    EXPECT_EQ(texels(png({1, 1, 8, kGrey, text_of({0, 51}), linear}))[0], (Texel{51, 51, 51, 255}));
}

TEST(DecodeTexture, PngInterlaced)
{
    // Adam7 of 2 x 2 pixels: the first, the second, then the second row.
    EXPECT_EQ(texels(png({2, 2, 8, kGrey, text_of({0, 1, 0, 2, 0, 3, 4}), "", 1})),
              (std::vector<Texel>{{1, 1, 1, 255}, {2, 2, 2, 255}, {3, 3, 3, 255}, {4, 4, 4, 255}}));
}

// Four blocks of 9 x 10 pixels: those at the right and at the bottom are cut.
constexpr unsigned kWidth = 9, kHeight = 10;
const std::vector<jpeg_file::Samples> kBlocks = {
    {255, 0, 10, 255}, {3, 250, 80, 128}, {0, 128, 255, 51}, {77, 66, 55, 0}};

std::size_t block_of(std::size_t texel)
{
    return texel / kWidth / 8 * 2 + texel % kWidth / 8;
}

// `expected` for each block, each channel within `tolerance`.
void expect_blocks(const jpeg_file::File& file, const std::vector<Texel>& expected, int tolerance)
{
    const TextureImage image = decode_texture("a", jpeg_file::make_jpeg(file));
    ASSERT_EQ(image.width, static_cast<int>(kWidth));
    ASSERT_EQ(image.height, static_cast<int>(kHeight));
    ASSERT_EQ(image.texels.size(), std::size_t{kWidth} * kHeight);
    for (std::size_t i = 0; i < image.texels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_LE(std::abs(image.texels[i][c] - expected[block_of(i)][c]), tolerance)
                << "texel " << i << ", channel " << c;
        }
        ASSERT_EQ(image.texels[i][3], 255);
    }
}

std::vector<Texel> as_rgb()
{
    return {kBlocks.begin(), kBlocks.end()};
}

TEST(DecodeTexture, JpegGreyIsExact)
{
    std::vector<Texel> grey;
    for (const auto& b : kBlocks) grey.push_back({b[0], b[0], b[0], 255});
    expect_blocks({kWidth, kHeight, JCS_GRAYSCALE, JCS_GRAYSCALE, kBlocks}, grey, 0);
}

TEST(DecodeTexture, JpegRgbIsExact)
{
    expect_blocks({kWidth, kHeight, JCS_RGB, JCS_RGB, kBlocks}, as_rgb(), 0);
}

// Y, Cb and Cr are each rounded by up to 0.5 and enter with weights of at most 1 and 1.772, the
// result is rounded again: less than 0.5 + 0.886 + 0.5 < 2.
TEST(DecodeTexture, JpegYCbCrIsWithinOne)
{
    expect_blocks({kWidth, kHeight, JCS_RGB, JCS_YCbCr, kBlocks}, as_rgb(), 1);
    expect_blocks({kWidth, kHeight, JCS_RGB, JCS_YCbCr, kBlocks, true}, as_rgb(), 1);
}

std::vector<Texel> from_ink(bool adobe)
{
    std::vector<Texel> colors;
    for (const auto& b : kBlocks) {
        Texel t = {0, 0, 0, 255};
        const auto let_pass = [&](std::uint8_t v) { return (adobe ? v : 255 - v) / 255.0; };
        for (std::size_t c = 0; c < 3; ++c) {
            t[c] = static_cast<std::uint8_t>(255 * let_pass(b[c]) * let_pass(b[3]) + 0.5);
        }
        colors.push_back(t);
    }
    return colors;
}

TEST(DecodeTexture, JpegInkIsWhatItLetsPass)
{
    expect_blocks({kWidth, kHeight, JCS_CMYK, JCS_CMYK, kBlocks}, from_ink(true), 0);
    expect_blocks({kWidth, kHeight, JCS_CMYK, JCS_CMYK, kBlocks, false, false}, from_ink(false), 0);
    // As for YCbCr, then multiplied by at most 1.
    expect_blocks({kWidth, kHeight, JCS_CMYK, JCS_YCCK, kBlocks}, from_ink(true), 1);
}

Bytes any_jpeg(bool progressive)
{
    return jpeg_file::make_jpeg({kWidth, kHeight, JCS_RGB, JCS_YCbCr, kBlocks, progressive});
}

TEST(DecodeTexture, RefusesEveryTruncatedFile)
{
    const Bytes files[] = {png({1, 1, 8, kRgba, text_of({0, 1, 2, 3, 4})}), any_jpeg(false),
                           any_jpeg(true)};
    for (const Bytes& whole : files) {
        ASSERT_EQ(message(whole), "read");
        for (std::size_t size = 0; size < whole.size(); ++size) {
            // A copy of its own, so that the sanitizer sees reads past its end.
            expect_refused(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)),
                           "");
        }
    }
}

TEST(DecodeTexture, DamagedJpegsAreReadOrRefused)
{
    for (const bool progressive : {false, true}) {
        const Bytes whole = any_jpeg(progressive);
        for (std::size_t i = 3; i < whole.size(); ++i) {
            for (const int bits : {0x01, 0x10, 0xff}) {
                Bytes damaged = whole;
                damaged[i] = static_cast<std::uint8_t>(damaged[i] ^ bits);
                const std::string text = message(damaged);
                EXPECT_TRUE(text == "read" || text.rfind("dir/a.png: ", 0) == 0);
            }
        }
    }
}

// Text that would unpack to 7 MB, 40 times: in little memory.
TEST(DecodeTexture, PngTextIsNotUnpacked)
{
    const std::string letters(7'000'000, 'x');
    uLongf size = compressBound(static_cast<uLong>(letters.size()));
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size,
             reinterpret_cast<const Bytef*>(letters.data()), static_cast<uLong>(letters.size()));
    packed.resize(size);
    std::string chunks;
    for (int i = 0; i < 40; ++i) chunks += chunk("zTXt", std::string("a\0\0", 3) + packed);
    const Bytes file = png({1, 1, 8, kGrey, text_of({0, 7}), chunks});
    const std::uint64_t before = peak_memory_bytes();
    EXPECT_EQ(texels(file), (std::vector<Texel>{{7, 7, 7, 255}}));
    EXPECT_LT(peak_memory_bytes() - before, 30'000'000u);
}

TEST(DecodeTexture, LimitsAreLookedAtBeforeMemoryIsTaken)
{
    // A file that claims the largest size and holds nothing of it.
    expect_refused(png({16384, 16384, 8, kRgba, text_of({0})}), "cut short");
    Bytes jpeg = any_jpeg(false);
    const Bytes sizes = {0xff, 0xc0, 0, 17, 8, 0, kHeight, 0, kWidth};
    const auto frame = std::search(jpeg.begin(), jpeg.end(), sizes.begin(), sizes.end());
    ASSERT_NE(frame, jpeg.end());
    frame[5] = frame[7] = 0x40;  // 16384 and a little
    expect_refused(jpeg, "cut short");

    const Bytes small = png({2, 3, 1, kGrey, text_of({0, 0, 0, 0, 0, 0})});
    expect_refused(small, "larger than 2 texels", {.most_size = 2, .most_texels = 100});
    expect_refused(small, "more than 5 texels", {.most_size = 3, .most_texels = 5});
    EXPECT_EQ(message(small, {.most_size = 3, .most_texels = 6}), "read");
    expect_refused(any_jpeg(true), "larger than 9 texels", {.most_size = 9});
    expect_refused(any_jpeg(true), "more than 89 texels", {.most_texels = 89});
}

// The last scan of a progressive file, again and again.
Bytes with_last_scan(const Bytes& whole, int times)
{
    const Bytes start = {0xff, 0xda};
    const auto last = std::find_end(whole.begin(), whole.end(), start.begin(), start.end());
    const Bytes scan(last, whole.end() - 2);  // before the end's marker
    Bytes bytes(whole.begin(), last);
    for (int i = 0; i < times; ++i) bytes.insert(bytes.end(), scan.begin(), scan.end());
    bytes.insert(bytes.end(), whole.end() - 2, whole.end());
    return bytes;
}

TEST(DecodeTexture, JpegsOfEndlessScansAreRefused)
{
    const Bytes whole = any_jpeg(true);
    EXPECT_EQ(message(with_last_scan(whole, 400)), "read");
    expect_refused(with_last_scan(whole, 501), "more than 500 scans");
}

TEST(DecodeTexture, LargeJpegsOfManyScansAreRefused)
{
    // 2^24 pixels: 256 scans of them are allowed, and the fewest bytes ask for 257.
    constexpr unsigned kSize = 4096;
    const std::vector<jpeg_file::Samples> grey(kSize * kSize / 64, jpeg_file::Samples{128});
    const Bytes whole =
        jpeg_file::make_jpeg({kSize, kSize, JCS_GRAYSCALE, JCS_GRAYSCALE, grey, true});
    EXPECT_EQ(message(with_last_scan(whole, 10)), "read");
    const Bytes endless = with_last_scan(whole, 300);
    EXPECT_LT(endless.size(), 1'000'000u);
    expect_refused(endless, "more scans than a picture of this size needs");
}

TEST(DecodeTexture, JpegsWithArithmeticCodingAreRefused)
{
    Bytes jpeg = any_jpeg(false);
    const Bytes baseline = {0xff, 0xc0, 0, 17};
    const auto frame = std::search(jpeg.begin(), jpeg.end(), baseline.begin(), baseline.end());
    ASSERT_NE(frame, jpeg.end());
    frame[1] = 0xc9;
    expect_refused(jpeg, "arithmetic coding is not supported");
}

}  // namespace
}  // namespace sheer
