// Pictures from files: the suffix decides, and whatever is wrong is told with the path.
#include "image/read_image.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include <sheer/error.h>

#include "../support/test_folder.h"
#include "image/color.h"
#include "image/jpeg_file.h"
#include "image/write_image.h"

namespace sheer {
namespace {

Image picture()
{
    Image image(3, 2);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float v = static_cast<float>(i) / 6;
        image.pixels[i] = {v, v * v, 1 - v, 1};
    }
    return image;
}

std::string complaint_about(const std::string& path)
{
    try {
        read_image(path);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input) << error.what();
        return error.what();
    }
    return "none";
}

TEST(ReadImage, ReadsWhatWriteImageWrote)
{
    const TestFolder folder;
    for (const std::string name : {"a.exr", "b.c.EXR", "a.png", "b.PnG"}) {
        write_image(folder.file(name), picture());
        const Image read = read_image(folder.file(name));
        ASSERT_EQ(read.width, 3) << name;
        ASSERT_EQ(read.height, 2) << name;
        if (name.find('e') != std::string::npos || name.find('E') != std::string::npos) {
            EXPECT_EQ(read.pixels, picture().pixels) << name;
        }
    }
    // sRGB in 8 bits: what was read is what would be written.
    write_image(folder.file("again.png"), read_image(folder.file("a.png")));
    EXPECT_EQ(text_of(folder.file("again.png")), text_of(folder.file("a.png")));
}

// Two blocks, of which the second is cut off.
jpeg_file::Bytes jpeg()
{
    return jpeg_file::make_jpeg({11, 5, JCS_RGB, JCS_RGB, {{200, 100, 50, 0}, {255, 0, 128, 0}}});
}

void write_bytes(const std::string& path, const jpeg_file::Bytes& bytes)
{
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

TEST(ReadImage, ReadsJpegsAsOpaqueSrgb)
{
    const TestFolder folder;
    const auto linear = [](int v) { return static_cast<float>(linear_from_srgb(v / 255.0)); };
    for (const std::string name : {"a.jpg", "a.JPEG"}) {
        write_bytes(folder.file(name), jpeg());
        const Image read = read_image(folder.file(name));
        ASSERT_EQ(read.width, 11);
        ASSERT_EQ(read.height, 5);
        for (std::size_t i = 0; i < read.pixels.size(); ++i) {
            const bool first = i % 11 < 8;
            EXPECT_EQ(read.pixels[i],
                      (std::array<float, 4>{linear(first ? 200 : 255), linear(first ? 100 : 0),
                                            linear(first ? 50 : 128), 1}))
                << i;
        }
    }
}

TEST(ReadImage, NamesWhatIsWrong)
{
    const TestFolder folder;
    for (const std::string name : {"a.gif", "a", "a.png.txt", ".png"}) {
        const std::string path = folder.file(name);
        EXPECT_EQ(complaint_about(path), path + ": unknown picture format; use .exr, .png or .jpg");
    }
    for (const std::string name : {"missing.exr", "missing.png", "missing/a.png"}) {
        const std::string path = folder.file(name);
        EXPECT_EQ(complaint_about(path), path + ": no such file");
    }
    const std::string directory = folder.file("folder.png");
    std::filesystem::create_directory(directory);
    EXPECT_EQ(complaint_about(directory), directory + ": is a directory, not a file");
}

TEST(ReadImage, RefusesOtherContent)
{
    const TestFolder folder;
    write_image(folder.file("real.exr"), picture());
    write_image(folder.file("real.png"), picture());
    const std::string exr = text_of(folder.file("real.exr")),
                      png = text_of(folder.file("real.png"));
    for (const std::string& content :
         {std::string(), std::string("text"), png, exr.substr(0, 99)}) {
        const std::string path = folder.file("a.exr");
        std::ofstream(path, std::ios::binary) << content;
        EXPECT_EQ(complaint_about(path).rfind(path + ": not a readable OpenEXR file: ", 0), 0u);
    }
    for (const std::string& content :
         {std::string(), std::string("text"), exr, png.substr(0, 60)}) {
        const std::string path = folder.file("a.png");
        std::ofstream(path, std::ios::binary) << content;
        EXPECT_EQ(complaint_about(path).rfind(path + ": not a readable PNG file: ", 0), 0u);
    }
    jpeg_file::Bytes half = jpeg();
    half.resize(half.size() / 2);
    for (const jpeg_file::Bytes& content :
         {jpeg_file::Bytes(), jpeg_file::Bytes(png.begin(), png.end()), half}) {
        const std::string path = folder.file("a.jpg");
        write_bytes(path, content);
        EXPECT_EQ(complaint_about(path).rfind(path + ": not a readable JPEG file: ", 0), 0u);
    }
}

}  // namespace
}  // namespace sheer
