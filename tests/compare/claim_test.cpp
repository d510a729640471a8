// Which numbers agree with what is printed.
#include "compare/claim.h"

#include <gtest/gtest.h>

#include <limits>

namespace sheer {

TEST(Claim, AgreesWithinItsBand)
{
    EXPECT_TRUE((Claim{"", "0.17", 0.1749, half_unit("0.17"), ""}.agrees()));
    EXPECT_FALSE((Claim{"", "0.17", 0.1751, half_unit("0.17"), ""}.agrees()));
    EXPECT_FALSE((Claim{"", "0.17", 0.1649, half_unit("0.17"), ""}.agrees()));
    EXPECT_TRUE((Claim{"", "4", 4, 0, ""}.agrees()));
    EXPECT_FALSE((Claim{"", "4", 5, 0, ""}.agrees()));
    // What could not be measured agrees with nothing.
    EXPECT_FALSE((Claim{"", "4", std::numeric_limits<double>::quiet_NaN(), 9, ""}.agrees()));
    EXPECT_DOUBLE_EQ((Claim{"", "1.5", 1.2, 0, ""}.difference()), -0.3);
}

TEST(Claim, HalfAUnitOfWhatIsPrinted)
{
    EXPECT_DOUBLE_EQ(half_unit("0.17"), 0.005);
    EXPECT_DOUBLE_EQ(half_unit("29.5"), 0.05);
    EXPECT_DOUBLE_EQ(half_unit("5"), 0.5);
}

}  // namespace sheer
