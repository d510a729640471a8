// Names that were meant.
#include "support/text.h"

#include <gtest/gtest.h>

namespace sheer {

namespace {

std::string meant(std::string_view typed)
{
    const std::vector<std::string> names = {"exact",      "mlab",   "mboit", "wboit",
                                            "stochastic", "hybrid", "z3"};
    return suggestion(typed, names);
}

std::string meaning(const std::string& name)
{
    return " (did you mean '" + name + "'?)";
}

}  // namespace

TEST(Text, SuggestsTheNearestName)
{
    EXPECT_EQ(meant("exakt"), meaning("exact"));  // one wrong
    EXPECT_EQ(meant("mlb"), meaning("mlab"));     // one too few
    EXPECT_EQ(meant("mlaab"), meaning("mlab"));   // one too many
    EXPECT_EQ(meant("mlba"), meaning("mlab"));    // swapped: one step, not two
    EXPECT_EQ(meant("wboti"), meaning("wboit"));  // also next to mboit, two steps away
    EXPECT_EQ(meant("stohcastik"), meaning("stochastic"));
    EXPECT_EQ(meant("stoch"), meaning("stochastic"));  // its beginning
    EXPECT_EQ(meant("z2"), meaning("z3"));
}

TEST(Text, SuggestsNothingFarOff)
{
    for (const char* typed : {"", "a", "x", "foo", "depth", "st", "raytracing", "exactly-wrong"}) {
        EXPECT_EQ(meant(typed), "") << typed;
    }
    EXPECT_EQ(suggestion("exact", {}), "");
    EXPECT_EQ(meant("mlab"), "");  // as it is: whatever is wrong, it is not the name
}

TEST(Text, JoinsNames)
{
    const std::vector<std::string> two = {"blend", "exact"};
    EXPECT_EQ(joined(two), "blend, exact");
    EXPECT_EQ(joined({}), "");
}

}  // namespace sheer
