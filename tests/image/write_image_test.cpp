// Pictures to files: the suffix decides, and failures say why and leave nothing.
#include "image/write_image.h"

#include <filesystem>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include <sheer/error.h>

#include "../support/test_folder.h"
#include "image/exr.h"
#include "image/png.h"

namespace sheer {
namespace {

Image picture()
{
    Image image(5, 4);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float v = static_cast<float>(i) / 20;
        image.pixels[i] = {v, v * v, 1 - v, 1};
    }
    return image;
}

void expect_error(Fault fault, const std::string& text, const std::function<void()>& action)
{
    try {
        action();
        ADD_FAILURE() << "no error; expected: " << text;
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), text);
        EXPECT_EQ(error.fault(), fault) << text;
    }
}

TEST(WriteImage, SuffixDecides)
{
    const TestFolder folder;
    const Image image = picture();
    for (const std::string name : {"a.exr", "b.EXR"}) {
        write_image(folder.file(name), image);
        EXPECT_EQ(decode_exr(bytes_of(text_of(folder.file(name))), name).pixels, image.pixels);
    }
    for (const std::string name : {"a.png", "b.c.PnG"}) {
        write_image(folder.file(name), image);
        EXPECT_EQ(decode_png(bytes_of(text_of(folder.file(name))), name).width, 5);
    }
    EXPECT_EQ(folder.entries(), 4);
}

TEST(WriteImage, SamePictureGivesTheSameFile)
{
    const TestFolder folder;
    for (const std::string suffix : {".exr", ".png"}) {
        write_image(folder.file("a" + suffix), picture());
        write_image(folder.file("b" + suffix), picture());
        EXPECT_EQ(text_of(folder.file("a" + suffix)), text_of(folder.file("b" + suffix)));
    }
}

TEST(WriteImage, RefusesOtherFormats)
{
    const TestFolder folder;
    const auto expect_refusal = [&](const std::string& name, const std::string& why) {
        const std::string path = folder.file(name), text = path + ": " + why + "; use .exr or .png";
        expect_error(Fault::input, text, [&] { write_image(path, picture()); });
        expect_error(Fault::input, text, [&] { check_image_path(path); });
    };
    for (const std::string name : {"a.gif", "a", "a.png.txt", ".png", "exr"}) {
        expect_refusal(name, "unknown picture format");
    }
    for (const std::string name : {"a.jpg", "a.JPEG"}) {
        expect_refusal(name, "JPEG files are only read");
    }
    EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteImage, CheckFindsMissingFoldersBeforehand)
{
    const TestFolder folder;
    const std::string missing = folder.file("missing");
    const std::string text = missing + "/a.png: the directory '" + missing + "' does not exist";
    expect_error(Fault::input, text, [&] { check_image_path(missing + "/a.png"); });
    expect_error(Fault::work, text, [&] { write_image(missing + "/a.png", picture()); });
    check_image_path(folder.file("a.png"));
    EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteImage, ReportsFullDisks)
{
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    const TestFolder folder;
    for (const std::string suffix : {".exr", ".png"}) {
        const std::string path = folder.file("full" + suffix);
        std::filesystem::create_symlink("/dev/full", path);
        check_image_path(path);
        expect_error(Fault::work, path + ": No space left on device",
                     [&] { write_image(path, picture()); });
    }
    EXPECT_EQ(folder.entries(), 2);
}

}  // namespace
}  // namespace sheer
