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

TEST_F(RenderOptionsTest, AmbientOcclusionIsTaken)
{
    for (const char* rays : {"0", "1", "64", "2:radius=0.5:samples=random",
                             "1:samples=hashed:cells=isotropic", "1:cells=anisotropic"}) {
        const Outcome outcome = render({"--ambient-occlusion", rays});
        EXPECT_EQ(outcome.exit_code, 0) << rays << ": " << outcome.err;
    }
    const auto refused = [&](const char* rays, const std::string& beginning) {
        expect_refusal({"--ambient-occlusion", rays}, "--ambient-occlusion: " + beginning);
    };
    refused("65", "'65' is not a whole number from 0 to 64");
    refused("-1", "'-1' is not a whole number");
    refused("many", "'many' is not a whole number");
    refused("1:wide", "'1:wide' is not N[:NAME=VALUE]...");
    refused("1:width=2", "there is no parameter 'width'; there are radius, samples, cells");
    refused("1:radius=0", "radius: '0' is not above 0");
    refused("1:radius=2000000", "radius: it is not between 0 and 1000000");
    refused("1:samples=odd", "samples: 'odd' is none of hashed, random");
    refused("1:cells=odd", "cells: 'odd' is none of isotropic, anisotropic");
}

TEST_F(RenderOptionsTest, FoveationIsTaken)
{
    for (const char* at : {"8,8,4", "-100,1e3,0", "0.5,0.5,1000000"}) {
        const Outcome outcome = render({"--foveate", at});
        EXPECT_EQ(outcome.exit_code, 0) << at << ": " << outcome.err;
    }
    expect_refusal({"--foveate", "8,8"}, "--foveate: '8,8' is not X,Y,R");
    expect_refusal({"--foveate", "8,8,-1"}, "--foveate: R: it is not between 0 and 1000000");
    expect_refusal({"--foveate", "8,2e6,1"}, "--foveate: Y: it is not between -1000000 and");
    expect_refusal({"--foveate", "8,x,1"}, "--foveate: 'x' is not a finite number");
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
