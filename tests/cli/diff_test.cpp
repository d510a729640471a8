// sheer diff: what it says of pictures whose difference is known, and what it refuses.
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/run_tool.h"
#include "compare/slow_metrics.h"
#include "image/color.h"
#include "image/read_image.h"
#include "image/write_image.h"
#include "support/json.h"

namespace sheer::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Image grey(int width, int height, float value, float alpha = 1)
{
    Image image(width, height);
    for (std::array<float, 4>& pixel : image.pixels) pixel = {value, value, value, alpha};
    return image;
}

// a.exr: 4x2, 0.5. b.exr: brighter by 1/8. c.exr: a.exr with other alpha. small.exr: 2x2.
class Diff : public testing::Test {
protected:
    void SetUp() override
    {
        write_image(tool_.file("a.exr"), grey(4, 2, 0.5f));
        write_image(tool_.file("b.exr"), grey(4, 2, 0.625f));
        write_image(tool_.file("c.exr"), grey(4, 2, 0.5f, 0.75f));
        write_image(tool_.file("small.exr"), grey(2, 2, 0.5f));
    }

    std::string output_of(const Words& arguments) const
    {
        const Outcome outcome = tool_.run(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << testing::PrintToString(arguments);
        EXPECT_EQ(outcome.err, "");
        return outcome.out;
    }

    // One line and nothing else: no output, no file.
    void expect_refused(const Words& arguments, const std::string& line) const
    {
        const auto before = tool_.folder().entries();
        const Outcome outcome = tool_.run(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(arguments);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err, "sheer: " + line + "\n");
        EXPECT_EQ(tool_.folder().entries(), before);
    }

    Tool tool_;
};

// 20 log10(255 / (255 / 8)) = 18.06 dB.
TEST_F(Diff, TellsPeople)
{
    const double flip =
        test::SlowFlip().error(grey(4, 2, 0.625f), grey(4, 2, 0.5f), 0, 0);  // everywhere
    char digits[16];
    std::snprintf(digits, sizeof digits, "%.4g", flip);
    EXPECT_EQ(output_of({"diff", "b.exr", "a.exr"}),
              "b.exr and a.exr: not equal\n"
              "size       4x2\n"
              "rmse       31.88\n"
              "psnr       18.06 dB\n"
              "ssim       -\n"
              "flip       " +
                  std::string(digits) +
                  "\n"
                  "bias mean  31.88 red, 31.88 green, 31.88 blue\n"
                  "largest    31.88 at 0,0\n");
    EXPECT_EQ(output_of({"diff", "a.exr", "a.exr"}),
              "a.exr and a.exr: identical\n"
              "size       4x2\n"
              "rmse       0\n"
              "psnr       infinite\n"
              "ssim       -\n"
              "flip       0\n"
              "bias mean  0 red, 0 green, 0 blue\n"
              "largest    0\n");
    const std::string alpha = output_of({"diff", "a.exr", "c.exr"});
    EXPECT_EQ(alpha.substr(0, alpha.find('\n')),
              "a.exr and c.exr: equal in colour, but not in every bit");
}

TEST_F(Diff, TellsPrograms)
{
    Image other = grey(4, 2, 0.5f);
    other.at(3, 1)[2] = 0.25f;
    write_image(tool_.file("other.exr"), other);
    const Json json = parse_json(output_of({"diff", "other.exr", "a.exr", "--json"}));
    EXPECT_EQ(json.at("a"), "other.exr");
    EXPECT_EQ(json.at("b"), "a.exr");
    EXPECT_EQ(json.at("width"), 4);
    EXPECT_EQ(json.at("height"), 2);
    // One of 24 values is off by 1/4.
    const double rmse = std::sqrt(0.0625 / 24) * 255;
    EXPECT_DOUBLE_EQ(json.at("rmse").get<double>(), rmse);
    EXPECT_DOUBLE_EQ(json.at("psnr").get<double>(), 20 * std::log10(255 / rmse));
    EXPECT_EQ(json.at("bias_mean"), Json({0, 0, -0.25 / 8 * 255}));
    EXPECT_EQ(json.at("largest"), Json({{"value", 63.75}, {"x", 3}, {"y", 1}}));
    EXPECT_EQ(json.at("identical"), false);
    EXPECT_FALSE(json.contains("error_map"));
}

TEST_F(Diff, TellsProgramsOfEqualPictures)
{
    const Json same = parse_json(output_of({"diff", "a.exr", "a.exr", "--json"}));
    EXPECT_EQ(same.at("rmse"), 0);
    EXPECT_TRUE(same.at("psnr").is_null());
    EXPECT_TRUE(same.at("ssim").is_null());
    EXPECT_EQ(same.at("flip"), 0);
    EXPECT_EQ(same.at("identical"), true);
    const Json alpha = parse_json(output_of({"diff", "a.exr", "c.exr", "--json"}));
    EXPECT_EQ(alpha.at("rmse"), 0);
    EXPECT_EQ(alpha.at("identical"), false);
}

TEST_F(Diff, DrawsErrorMaps)
{
    const Json json = parse_json(output_of({"diff", "b.exr", "a.exr", "--json", "-o", "map.png"}));
    EXPECT_EQ(json.at("error_map"), Json({{"image", "map.png"}, {"scale", 50.0}}));
    const Image map = read_image(tool_.file("map.png"));
    EXPECT_EQ(map.width, 4);
    EXPECT_EQ(map.height, 2);
    const std::string text = output_of({"diff", "b.exr", "a.exr", "-o", "map.exr"});
    EXPECT_NE(text.find("\nerror map  map.exr, black 0 to yellow 50\n"), std::string::npos) << text;
    const Image exr = read_image(tool_.file("map.exr"));
    // What 8 bits of sRGB leave of it: half a step, where steps are largest (0.0089, near white).
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(map.at(0, 0)[c], exr.at(0, 0)[c], 0.0045);
    output_of({"diff", "a.exr", "a.exr", "-o", "none.png"});
    EXPECT_EQ(tool_.folder().entries(), 7);
}

TEST_F(Diff, MixesFormats)
{
    write_image(tool_.file("white.png"), grey(4, 2, 1));
    write_image(tool_.file("white.exr"), grey(4, 2, 1));
    const std::string text = output_of({"diff", "white.png", "white.exr"});
    EXPECT_EQ(text.rfind("white.png and white.exr: identical\n", 0), 0u) << text;
}

TEST_F(Diff, RefusesInputThatIsWrong)
{
    expect_refused({"diff", "missing.exr", "a.exr"}, "missing.exr: no such file");
    expect_refused({"diff", "a.exr", "missing.png"}, "missing.png: no such file");
    expect_refused({"diff", "a.gif", "a.exr"},
                   "a.gif: unknown picture format; use .exr, .png or .jpg");
    expect_refused({"diff", "a.exr", "small.exr"}, "small.exr: 2x2 pixels, but a.exr has 4x2");
    expect_refused({"diff", "a.exr"}, "B is required; see 'sheer diff --help'");
    expect_refused({"diff", "a.exr", "b.exr", "c.exr"},
                   "'c.exr' is one argument too many; see 'sheer diff --help'");
}

TEST_F(Diff, RefusesOutputThatIsWrong)
{
    fs::create_symlink("a.exr", tool_.file("link.exr"));
    const std::string replaces = ": is a picture to compare; the error map would replace it";
    for (const char* output : {"a.exr", "./b.exr", "link.exr"}) {
        expect_refused({"diff", "a.exr", "b.exr", "-o", output}, output + replaces);
    }
    // Before the pictures are read.
    expect_refused({"diff", "missing.exr", "a.exr", "-o", "a.jpg"},
                   "a.jpg: JPEG files are only read; use .exr or .png");
    expect_refused({"diff", "missing.exr", "a.exr", "-o", "no/a.png"},
                   "no/a.png: the directory 'no' does not exist");
    expect_refused({"diff", "a.exr", "b.exr", "-o", ""},
                   ": unknown picture format; use .exr or .png");
}

TEST_F(Diff, NamesThePixelThatIsNotFinite)
{
    for (const float bad :
         {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        Image image = grey(4, 2, 0.5f);
        image.at(2, 1)[1] = bad;
        write_image(tool_.file("bad.exr"), image);
        const std::string line =
            "bad.exr: pixel 2,1 is not finite, so that its difference cannot be measured";
        expect_refused({"diff", "bad.exr", "a.exr"}, line);
        expect_refused({"diff", "a.exr", "bad.exr", "-o", "map.png"}, line);
        // What is the same in both is no difference.
        const Json json = parse_json(output_of({"diff", "bad.exr", "bad.exr", "--json"}));
        EXPECT_EQ(json.at("identical"), true);
        EXPECT_EQ(json.at("rmse"), 0);
    }
}

TEST_F(Diff, ReportsOutputThatTakesNothing)
{
    const Outcome closed = tool_.run({"diff", "a.exr", "b.exr"}, {.closed_output = true});
    EXPECT_EQ(closed.exit_code, 1);
    EXPECT_EQ(closed.err, "sheer: standard output: Bad file descriptor\n");
    const Outcome full =
        tool_.run({"diff", "a.exr", "b.exr", "-o", "map.exr"}, {.file_size_limit = 50});
    EXPECT_EQ(full.exit_code, 1);
    EXPECT_EQ(full.err, "sheer: map.exr: File too large\n");
    EXPECT_FALSE(fs::exists(tool_.file("map.exr")));
}

TEST_F(Diff, DrawsWhatFlipSees)
{
    write_image(tool_.file("black.exr"), grey(12, 11, 0));
    write_image(tool_.file("white.exr"), grey(12, 11, 1));
    const Words words = {"diff", "white.exr", "black.exr", "--flip-map", "map.exr"};
    EXPECT_NE(output_of(words).find("\nflip map   map.exr, black 0 to yellow 1\n"),
              std::string::npos);
    // 0.96739 everywhere: 0.51 of the way from the map's last colour but one, (253, 222, 160), to
    // the last, (252, 253, 191).
    EXPECT_NEAR(srgb_from_linear(read_image(tool_.file("map.exr")).at(5, 5)[2]) * 255,
                160 + 31 * (0.96739 * 15 - 14), 0.05);
    const Json json = parse_json(output_of({"diff", "white.exr", "black.exr", "--json"}));
    EXPECT_NEAR(json.at("flip").get<double>(), 0.9673883, 1e-4);  // as FLIP's authors' program
    // 11 x 11 windows of 1 and 0: C1 / (1 + C1).
    EXPECT_NEAR(json.at("ssim").get<double>(), 1e-4 / 1.0001, 1e-12);
    expect_refused({"diff", "a.exr", "b.exr", "--flip-map", "b.exr"},
                   "b.exr: is a picture to compare; the error map would replace it");
}

TEST_F(Diff, ShowsNoControlCharacters)
{
    fs::copy(tool_.file("a.exr"), tool_.file("a\x1b[31m.exr"));
    EXPECT_EQ(output_of({"diff", "a\x1b[31m.exr", "a.exr"}).rfind("a?[31m.exr and a.exr: ", 0), 0u);
}

TEST_F(Diff, Helps)
{
    const std::string help = output_of({"diff", "--help"});
    for (const char* part :
         {"Examples:\n  sheer diff ", "  rmse ", "  psnr ", "  ssim ", "  flip ", "  bias mean ",
          "  largest ", "  identical ", "  error map ", "exit code is 0"}) {
        EXPECT_NE(help.find(part), std::string::npos) << part;
    }
}

}  // namespace
}  // namespace sheer::test
