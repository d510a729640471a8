// sheer render --frames: which files there are then, and what is the same in them.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/run_tool.h"
#include "scene/gltf_fixture.h"
#include "support/json.h"

namespace sheer::test {
namespace {

using Words = std::vector<std::string>;

class RenderFilmTest : public testing::Test {
protected:
    Outcome render(const std::string& output, const Words& added) const
    {
        Words words = {"render", "builtin:layers", "-o",        output,
                       "--size", "24x16",          "--samples", "1"};
        words.insert(words.end(), added.begin(), added.end());
        return tool_.run(words);
    }
    void expect_refusal(const std::string& output, const Words& words,
                        const std::string& says) const
    {
        const Outcome outcome = render(output, words);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
        EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
        EXPECT_EQ(tool_.folder().entries(), 0);
    }
    std::string file(const std::string& name) const { return text_of(tool_.file(name)); }

    Tool tool_;
};

TEST_F(RenderFilmTest, WritesAFileForEachFrame)
{
    const Outcome outcome =
        render("a.b#.###.exr",
               {"--frames", "8..10", "--orbit", "30", "--eye", "1,0,4", "--target", "0,0,0",
                "--method", "blend", "--stats", "stats.json", "--channels", "c##.exr"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("a.b#.###.exr: 3 frames, 24x16, blend, ")) << outcome.out;
    EXPECT_EQ(tool_.folder().entries(), 7);
    const std::string first = file("a.b#.008.exr");
    EXPECT_NE(first, "");
    EXPECT_NE(file("a.b#.009.exr"), first);
    EXPECT_NE(file("a.b#.010.exr"), "");
    EXPECT_NE(file("c10.exr"), "");
    const auto json = parse_json(file("stats.json"));
    ASSERT_EQ(json.at("frames").size(), 3u);
    EXPECT_EQ(json["frames"][2].at("frame"), 10);
    EXPECT_EQ(json["frames"][2].at("image"), "a.b#.010.exr");
    EXPECT_EQ(json["frames"][2].at("method"), "blend");
}

TEST_F(RenderFilmTest, OnlyWhatIsRandomChangesWhereNothingMoves)
{
    for (const char* method : {"hashed-alpha-test", "exact", "hashed-alpha-to-coverage"}) {
        EXPECT_EQ(render("a.#.exr", {"--frames", "0..1", "--method", method}).exit_code, 0);
        EXPECT_EQ(render("one.exr", {"--method", method}).exit_code, 0);
        EXPECT_EQ(file("a.0.exr"), file("one.exr")) << method;
        EXPECT_EQ(file("a.1.exr"), file("one.exr")) << method;
    }
    for (const char* method : {"stochastic", "stochastic-alpha-test"}) {
        EXPECT_EQ(render("a.#.exr", {"--frames", "0..2", "--method", method}).exit_code, 0);
        EXPECT_EQ(render("one.exr", {"--method", method}).exit_code, 0);
        EXPECT_EQ(file("a.0.exr"), file("one.exr")) << method;
        EXPECT_NE(file("a.1.exr"), file("a.0.exr")) << method;
        // Frames have their numbers, however many are drawn.
        EXPECT_EQ(render("b.#.exr", {"--frames", "2..2", "--method", method}).exit_code, 0);
        EXPECT_EQ(file("b.2.exr"), file("a.2.exr")) << method;
    }
}

TEST_F(RenderFilmTest, AveragedFramesAreNotThoseOfTheNextPicture)
{
    const Words averaged = {"--frames", "0..1", "--method", "stochastic", "--accumulate", "2"};
    EXPECT_EQ(render("a.#.exr", averaged).exit_code, 0);
    EXPECT_NE(file("a.0.exr"), file("a.1.exr"));
}

TEST_F(RenderFilmTest, ATurnEndsWhereItBegan)
{
    EXPECT_EQ(render("a.#.exr", {"--frames", "0..2", "--orbit", "360", "--eye", "1,0,4", "--target",
                                 "0,0,0", "--method", "blend"})
                  .exit_code,
              0);
    EXPECT_EQ(file("a.0.exr"), file("a.2.exr"));
    EXPECT_NE(file("a.0.exr"), file("a.1.exr"));
}

TEST_F(RenderFilmTest, PlaysAnimations)
{
    Builder builder = one_triangle();
    const std::size_t times = builder.accessor("SCALAR", std::vector<float>{0, 2});
    const std::size_t places = builder.accessor("VEC3", std::vector<float>{0, 0, 0, 1, 0, 0});
    builder.json["animations"] = {
        {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
         {"samplers", {{{"input", times}, {"output", places}}}}}};
    std::ofstream(tool_.file("a.gltf")) << builder.text();
    const auto draw_framed = [&](const Words& added) {
        Words words = {"render", "a.gltf", "--size", "24x16", "--method", "blend"};
        words.insert(words.end(), added.begin(), added.end());
        const Outcome outcome = tool_.run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    };
    const auto draw = [&](Words added) {
        for (const char* word : {"--eye", "1,1,9", "--target", "1,1,0"}) added.push_back(word);
        draw_framed(added);
    };
    draw({"-o", "a.#.exr", "--frames", "0..2", "--fps", "2"});
    draw({"-o", "still.exr"});
    draw({"-o", "late.exr", "--time", "1"});
    EXPECT_EQ(file("a.0.exr"), file("still.exr"));
    EXPECT_NE(file("a.1.exr"), file("a.0.exr"));
    EXPECT_EQ(file("a.2.exr"), file("late.exr"));
    EXPECT_NE(file("late.exr"), file("a.1.exr"));
    // Without a camera all frames have that of frame 0, whichever are drawn.
    draw_framed({"-o", "b.#.exr", "--frames", "0..2", "--fps", "2"});
    draw_framed({"-o", "c.#.exr", "--frames", "2..2", "--fps", "2"});
    EXPECT_NE(file("b.1.exr"), file("b.0.exr"));
    EXPECT_NE(file("b.2.exr"), file("b.1.exr"));
    EXPECT_EQ(file("c.2.exr"), file("b.2.exr"));
}

TEST_F(RenderFilmTest, SaysWhatIsWrong)
{
    expect_refusal("a.exr", {"--frames", "0..1"},
                   "--output: 'a.exr' has no # for the frame's number");
    expect_refusal("a#/b.exr", {"--frames", "0..1"}, "has no #");
    expect_refusal("a#.exr", {"--frames", "0..1", "--channels", "c.exr"},
                   "--channels: 'c.exr' has");
    expect_refusal("a#.jpg", {"--frames", "0..1"}, "a0.jpg");
    expect_refusal("a#.exr", {"--frames", "5"}, "--frames: '5' is not A..B");
    expect_refusal("a#.exr", {"--frames", "5..3"}, "--frames: '5..3' ends before it begins");
    expect_refusal("a#.exr", {"--frames", "0..-1"}, "--frames: '-1' is not a whole number");
    expect_refusal("a.exr", {"--orbit", "30"}, "--orbit requires --frames");
    expect_refusal("a.exr", {"--time", "1"}, "builtin:layers: only glTF files have animations");
    expect_refusal("a#.exr", {"--frames", "0..1", "--fps", "0"}, "--fps: '0' is not between");
    expect_refusal("a#.exr", {"--frames", "0..1", "--taa", "2"}, "--taa: '2' is neither above 0");
    expect_refusal("a#.exr", {"--frames", "0..1", "--taa-period", "6"},
                   "--taa-period: 6 is not one");
    expect_refusal("a#.exr", {"--frames", "0..1", "--dolly", "0"}, "--dolly: '0' is not between");
    expect_refusal("a#.exr", {"--frames", "0..1", "--camera-path", "none.json"}, "none.json: ");
}

TEST_F(RenderFilmTest, KeysThatMeetTheirTargetAreRefusedBeforeAnyPicture)
{
    const std::string keys =
        R"({"keys": [{"frame": 0, "eye": [0, 0, -1], "target": [0, 0, 0]},
                     {"frame": 4, "eye": [0, 0, 1], "target": [0, 0, 0]}]})";
    std::ofstream(tool_.file("k.json")) << keys;
    const Outcome outcome = render("a#.exr", {"--frames", "0..4", "--camera-path", "k.json"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("in frame 2 the eye is the same point"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(tool_.folder().entries(), 1);
    const Outcome both = render("a#.exr", {"--frames", "0..1", "--camera-path", "k.json", "--eye",
                                           "0,0,1", "--target", "0,0,0"});
    EXPECT_EQ(both.exit_code, 2);
    EXPECT_NE(both.err.find("--eye excludes --camera-path"), std::string::npos) << both.err;
}

}  // namespace
}  // namespace sheer::test
