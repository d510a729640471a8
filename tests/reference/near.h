// Pixels of scenes whose factors are multiples of 1/64, exact in floats, as is what becomes of
// them: answers are off by the rounding of doubles alone.
#pragma once

#include <gtest/gtest.h>

#include "reference/reference.h"

namespace sheer::reference {

inline constexpr double kExact = 1e-12;

inline void expect_near(const Rgba& actual, const Rgba& expected)
{
    EXPECT_NEAR(actual.r, expected.r, kExact);
    EXPECT_NEAR(actual.g, expected.g, kExact);
    EXPECT_NEAR(actual.b, expected.b, kExact);
    EXPECT_NEAR(actual.a, expected.a, kExact);
}

}  // namespace sheer::reference
