// OpenEXR: every bit comes back, foreign files are understood, broken ones refused.
#include "image/exr.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <gtest/gtest.h>
#include <half.h>

#include <sheer/error.h>

#include "../support/test_folder.h"

namespace sheer {
namespace {

using Bytes = std::vector<std::byte>;
using Rgba = std::array<float, 4>;

Image odd_picture()
{
    Image image(37, 41);
    float v = -3;
    for (Rgba& pixel : image.pixels) {
        for (float& channel : pixel) channel = v += 0.37f;
    }
    image.pixels[0] = {std::numeric_limits<float>::quiet_NaN(), -0.0f,
                       std::numeric_limits<float>::infinity(), 1e-42f};
    return image;
}

void expect_same_bits(const Image& a, const Image& b)
{
    ASSERT_EQ(a.width, b.width);
    ASSERT_EQ(a.height, b.height);
    using Bits = std::array<std::uint32_t, 4>;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        ASSERT_EQ(std::bit_cast<Bits>(a.pixels[i]), std::bit_cast<Bits>(b.pixels[i])) << i;
    }
}

Bytes bytes_at(const std::string& path)
{
    const std::string text = text_of(path);
    const std::span<const std::byte> bytes = bytes_of(text);
    return {bytes.begin(), bytes.end()};
}

TEST(Exr, RoundTripKeepsEveryBit)
{
    const Image image = odd_picture();
    const Bytes bytes = encode_exr(image);
    expect_same_bits(decode_exr(bytes, "a.exr"), image);
    EXPECT_EQ(encode_exr(image), bytes);
}

TEST(Exr, HeaderHoldsWhatIsPromised)
{
    const TestFolder folder;
    const Bytes bytes = encode_exr(odd_picture());
    std::ofstream(folder.file("a.exr"), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    const Imf::InputFile file(folder.file("a.exr").c_str());
    EXPECT_TRUE(file.isComplete());
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
    EXPECT_FALSE(Imf::hasCapDate(file.header()));
    std::string names;
    for (auto c = file.header().channels().begin(); c != file.header().channels().end(); ++c) {
        names += c.name();
        EXPECT_EQ(c.channel().type, Imf::FLOAT);
    }
    EXPECT_EQ(names, "ABGR");
}

TEST(Exr, PicturesWithoutPixelsAreRefused)
{
    EXPECT_THROW(encode_exr(Image()), Error);
}

// Half-float grey: pixel (x, y) of the data window holds x + 10 y.
Bytes make_grey(const Imath::Box2i& display, const Imath::Box2i& data, const std::string& more = "")
{
    const TestFolder folder;
    Imf::Header header(display, data);
    header.channels().insert("Y", Imf::Channel(Imf::HALF));
    if (!more.empty()) header.channels().insert(more, Imf::Channel(Imf::HALF));
    std::vector<half> values;
    for (int y = data.min.y; y <= data.max.y; ++y) {
        for (int x = data.min.x; x <= data.max.x; ++x) {
            values.push_back(half(static_cast<float>(x + 10 * y)));
        }
    }
    const auto width = static_cast<std::size_t>(data.max.x - data.min.x + 1);
    Imf::FrameBuffer frame;
    frame.insert(
        "Y", Imf::Slice::Make(Imf::HALF, values.data(), data, sizeof(half), width * sizeof(half)));
    {
        Imf::OutputFile file(folder.file("a.exr").c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(data.max.y - data.min.y + 1);
    }
    return bytes_at(folder.file("a.exr"));
}

TEST(Exr, ReadsGreyInHalfFloats)
{
    const Imath::Box2i window({0, 0}, {3, 2});
    const Image image = decode_exr(make_grey(window, window), "a.exr");
    ASSERT_EQ(image.width, 4);
    ASSERT_EQ(image.height, 3);
    EXPECT_EQ(image.at(0, 0), (Rgba{0, 0, 0, 1}));
    EXPECT_EQ(image.at(3, 2), (Rgba{23, 23, 23, 1}));
}

TEST(Exr, ShowsTheDisplayWindow)
{
    const Imath::Box2i display({10, 10}, {14, 13});
    const Image image = decode_exr(make_grey(display, {{8, 12}, {12, 20}}), "a.exr");
    ASSERT_EQ(image.width, 5);
    ASSERT_EQ(image.height, 4);
    EXPECT_EQ(image.at(0, 1), (Rgba{0, 0, 0, 0}));
    EXPECT_EQ(image.at(0, 2), (Rgba{130, 130, 130, 1}));
    EXPECT_EQ(image.at(2, 3), (Rgba{142, 142, 142, 1}));
    EXPECT_EQ(image.at(3, 2), (Rgba{0, 0, 0, 0}));
    const Image apart = decode_exr(make_grey(display, {{0, 0}, {1, 1}}), "a.exr");
    for (const Rgba& pixel : apart.pixels) EXPECT_EQ(pixel, (Rgba{0, 0, 0, 0}));
}

void expect_refused(const Bytes& bytes, const std::string& reason)
{
    try {
        decode_exr(bytes, "dir/a.exr");
        ADD_FAILURE() << "read: " << reason;
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_EQ(text.rfind("dir/a.exr: not a readable OpenEXR file: ", 0), 0u) << text;
        EXPECT_NE(text.find(reason), std::string::npos) << text;
        EXPECT_EQ(error.fault(), Fault::input);
    }
}

TEST(Exr, RefusesWhatItCannotShow)
{
    const Imath::Box2i window({0, 0}, {3, 2});
    expect_refused(make_grey(window, window, "RY"), "neither channels R, G, B nor Y");
    expect_refused(make_grey({{0, 0}, {20000, 0}}, window), "larger than 16384 pixels");
    expect_refused(Bytes(100), "");
}

TEST(Exr, RefusesEveryTruncatedFile)
{
    Image image(2, 2);
    image.pixels[3] = {1, 0.5f, 0.25f, 1};
    const Bytes whole = encode_exr(image);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        expect_refused(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)), "");
    }
}

}  // namespace
}  // namespace sheer
