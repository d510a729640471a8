// Options of noise and shadows: what is taken, and how what is not is refused.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/run_tool.h"

namespace sheer::test {
namespace {

using Words = std::vector<std::string>;

class RenderOptionsTest : public testing::Test {
protected:
    Outcome render(const Words& added) const
    {
        Words words = {"render", "builtin:quads", "-o",        "a.exr",
                       "--size", "16x16",         "--samples", "1"};
        words.insert(words.end(), added.begin(), added.end());
        return tool_.run(words);
    }

    void expect_refusal(const Words& words, const std::string& beginning) const
    {
        const Outcome outcome = render(words);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
        EXPECT_NE(outcome.err.find(beginning), std::string::npos) << outcome.err;
    }

private:
    Tool tool_;
};

TEST_F(RenderOptionsTest, ShadowsAreTaken)
{
    for (const char* shadows :
         {"none", "exact", "stochastic", "stochastic:masks=naive:correction=on",
          "stochastic:footprint=random:colored=on:masks=stratified:correction=off"}) {
        const Outcome outcome = render({"--shadows", shadows, "--shadow-size", "64",
                                        "--shadow-samples", "4", "--shadow-filter", "3"});
        EXPECT_EQ(outcome.exit_code, 0) << shadows << ": " << outcome.err;
    }
}

TEST_F(RenderOptionsTest, TexturesAreReadAsAsked)
{
    for (const char* mips : {"premultiplied", "straight", "coverage"}) {
        const Outcome outcome = render({"--alpha-mips", mips, "--texture-levels", "2"});
        EXPECT_EQ(outcome.exit_code, 0) << mips << ": " << outcome.err;
    }
    expect_refusal({"--alpha-mips", "odd"},
                   "--alpha-mips: 'odd' is none of premultiplied, straight, coverage");
    expect_refusal({"--texture-levels", "17"}, "--texture-levels: '17' is not a whole number");
}

TEST_F(RenderOptionsTest, OddShadowsAreRefused)
{
    expect_refusal({"--shadows", "soft"},
                   "--shadows: 'soft' is none of none, stochastic, moment, exact");
    expect_refusal({"--shadows", "exact:masks=naive"}, "--shadows: 'exact:masks=naive' is not");
    expect_refusal({"--shadows", "stochastic:masks"}, "--shadows: 'stochastic:masks' is not");
    expect_refusal({"--shadows", "stochastic:masks=odd"},
                   "--shadows: masks: 'odd' is none of naive, stratified");
    expect_refusal({"--shadows", "stochastic:depth=1"}, "--shadows: there is no parameter 'depth'");
    expect_refusal({"--shadow-size", "15"}, "--shadow-size: '15' is not a whole number from 16");
    expect_refusal({"--shadow-filter", "9"}, "--shadow-filter: '9' is not a whole number");
    expect_refusal({"--shadows", "stochastic", "--shadow-samples", "3"},
                   "--shadow-samples: 3 is not one of 1, 2, 4, 8, 16, 32, 64");
    expect_refusal({"--shadow-size", "64"}, "--shadow-size requires --shadows");
}

TEST_F(RenderOptionsTest, FramesAreTaken)
{
    for (const Words& words : {Words{"--accumulate", "3"}, Words{"--noise-target", "4"},
                               Words{"--noise-target", "4", "--relative-noise"},
                               Words{"--frame-budget", "8", "--most-frames", "9"},
                               Words{"--post-filter", "cross-bilateral:sigma-s=1:sigma-r=0.1"}}) {
        Words added = {"--method", "stochastic:correction=on"};
        added.insert(added.end(), words.begin(), words.end());
        const Outcome outcome = render(added);
        EXPECT_EQ(outcome.exit_code, 0) << words[0] << ": " << outcome.err;
    }
}

TEST_F(RenderOptionsTest, OddFramesAreRefused)
{
    expect_refusal({"--most-frames", "9"}, "--most-frames: means nothing without --noise-target");
    expect_refusal({"--relative-noise"}, "--relative-noise: means nothing without --noise-target");
    expect_refusal({"--noise-target", "2", "--frame-budget", "8"},
                   "--frame-budget: not together with a noise target");
    expect_refusal({"--noise-target", "2", "--accumulate", "8"},
                   "--accumulate: not together with a noise target or frame budget");
    expect_refusal({"--frame-budget", "5"}, "--frame-budget: it is not between 6 and 100000");
    expect_refusal({"--post-filter", "box"}, "--post-filter: 'box' is none of");
}

}  // namespace
}  // namespace sheer::test
