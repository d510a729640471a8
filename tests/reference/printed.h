// Numbers that are known as text hold to half a unit of their last digit.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "reference/reference.h"

namespace sheer::reference {

inline double half_a_unit(const std::string& printed)
{
    const std::size_t point = printed.find('.');
    const std::size_t decimals = point == std::string::npos ? 0 : printed.size() - point - 1;
    return 0.5 * std::pow(10, -static_cast<double>(decimals));
}

inline void expect_printed(double actual, const std::string& printed)
{
    // A hair more than half a unit: what lies in the middle of two may be printed as either.
    EXPECT_NEAR(actual, std::stod(printed), half_a_unit(printed) * (1 + 1e-6)) << printed;
}

using Printed = std::array<std::string, 3>;  // red, green, blue

inline void expect_printed(const Rgba& actual, const Printed& printed)
{
    expect_printed(actual.r, printed[0]);
    expect_printed(actual.g, printed[1]);
    expect_printed(actual.b, printed[2]);
}

inline void expect_same(const Rgba& a, const Rgba& b, double tolerance = 1e-12)
{
    EXPECT_NEAR(a.r, b.r, tolerance);
    EXPECT_NEAR(a.g, b.g, tolerance);
    EXPECT_NEAR(a.b, b.b, tolerance);
    EXPECT_NEAR(a.a, b.a, tolerance);
}

}  // namespace sheer::reference
