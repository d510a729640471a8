// --shadows and what belongs to it: what is taken, and how what is not is refused.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/run_tool.h"

namespace sheer::test {
namespace {

using Words = std::vector<std::string>;

class ShadowOptionsTest : public testing::Test {
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

TEST_F(ShadowOptionsTest, AllOfThemAreTaken)
{
    for (const char* shadows :
         {"none", "exact", "stochastic", "stochastic:masks=naive:correction=on",
          "stochastic:footprint=random:colored=on:masks=stratified:correction=off"}) {
        const Outcome outcome = render({"--shadows", shadows, "--shadow-size", "64",
                                        "--shadow-samples", "4", "--shadow-filter", "3"});
        EXPECT_EQ(outcome.exit_code, 0) << shadows << ": " << outcome.err;
    }
}

TEST_F(ShadowOptionsTest, TheRestIsRefused)
{
    expect_refusal({"--shadows", "soft"}, "--shadows: 'soft' is none of none, stochastic, exact");
    expect_refusal({"--shadows", "exact:masks=naive"}, "--shadows: 'exact:masks=naive' is not");
    expect_refusal({"--shadows", "stochastic:masks"}, "--shadows: 'stochastic:masks' is not");
    expect_refusal({"--shadows", "stochastic:masks=odd"},
                   "--shadows: masks: 'odd' is none of naive, stratified");
    expect_refusal({"--shadows", "stochastic:depth=1"}, "--shadows: there is no parameter 'depth'");
    expect_refusal({"--shadow-size", "15"}, "--shadow-size: '15' is not a whole number from 16");
    expect_refusal({"--shadow-filter", "9"}, "--shadow-filter: '9' is not a whole number");
    expect_refusal({"--shadow-samples", "3"},
                   "--shadow-samples: 3 is not one of 1, 2, 4, 8, 16, 32, 64");
}

}  // namespace
}  // namespace sheer::test
