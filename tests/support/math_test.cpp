// Own elementary functions: against the C library's, at special values, and bit for bit.
#include "support/math.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "support/random.h"

namespace sheer {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = std::numbers::pi;
constexpr int kTries = 20000;

// Bounds: 3 units in the last place are 6.7e-16 at most; the C library may be 1 off.
constexpr double kRelative = 1e-15;

double between(double low, double high, int counter)
{
    return low + (high - low) * CounterRandom{42}.uniform(static_cast<std::uint64_t>(counter));
}

void expect_close(double value, double expected, double argument)
{
    EXPECT_LE(std::abs(value - expected), kRelative * std::abs(expected)) << argument;
}

TEST(Math, ExpAgreesWithTheLibrary)
{
    for (int i = 0; i < kTries; ++i) {
        const double x = i % 2 ? between(-700, 700, i) : between(-1, 1, i);
        expect_close(own_exp(x), std::exp(x), x);
    }
}

TEST(Math, LogAgreesWithTheLibrary)
{
    for (int i = 0; i < kTries; ++i) {
        const double x = i % 2 ? std::exp2(between(-1022, 1023, i)) : between(0.5, 2, i);
        expect_close(own_log(x), std::log(x), x);
        expect_close(own_log2(x), std::log2(x), x);
    }
}

TEST(Math, SinesAgreeWithTheLibrary)
{
    for (int i = 0; i < kTries; ++i) {
        // Every third one next to a multiple of pi / 2, where the reduction has to be accurate.
        const double whole = std::floor(between(-636000, 636000, i));
        const double x = i % 3 == 0   ? whole * (kPi / 2)
                         : i % 3 == 1 ? between(-1e6, 1e6, i)
                                      : between(-4, 4, i);
        expect_close(own_sin(x), std::sin(x), x);
        expect_close(own_cos(x), std::cos(x), x);
        expect_close(own_tan(x), std::tan(x), x);
    }
}

TEST(Math, Atan2AgreesWithTheLibrary)
{
    for (int i = 0; i < kTries; ++i) {
        const double scale = std::exp2(between(-300, 300, 3 * i));
        const double y = between(-1, 1, 3 * i + 1);
        const double x = between(-1, 1, 3 * i + 2) * (i % 2 ? 1 : scale);
        expect_close(own_atan2(y, x), std::atan2(y, x), y / x);
    }
}

TEST(Math, PowAgreesWithTheLibrary)
{
    for (int i = 0; i < kTries; ++i) {
        const double base = std::exp2(between(-20, 20, 2 * i));
        const double exponent = between(-5, 5, 2 * i + 1);
        const double product = std::abs(exponent * std::log(base));
        const double expected = std::pow(base, exponent);
        EXPECT_LE(std::abs(own_pow(base, exponent) - expected),
                  (kRelative + 4e-16 * product) * expected)
            << base << "^" << exponent;
    }
}

TEST(Math, ExpAtSpecialValues)
{
    EXPECT_EQ(own_exp(0), 1);
    EXPECT_EQ(own_exp(kInfinity), kInfinity);
    EXPECT_EQ(own_exp(-kInfinity), 0);
    EXPECT_EQ(own_exp(710), kInfinity);
    EXPECT_EQ(own_exp(-750), 0);
    EXPECT_LT(own_exp(709.78), kInfinity);
    EXPECT_EQ(own_exp(-745), std::numeric_limits<double>::denorm_min());
    EXPECT_TRUE(std::isnan(own_exp(kNaN)));
}

TEST(Math, LogAtSpecialValues)
{
    EXPECT_EQ(own_log(1), 0);
    EXPECT_EQ(own_log(0), -kInfinity);
    EXPECT_EQ(own_log(kInfinity), kInfinity);
    EXPECT_TRUE(std::isnan(own_log(-1)));
    EXPECT_TRUE(std::isnan(own_log(kNaN)));
    expect_close(own_log(5e-324), -744.44007192138122, 5e-324);
    for (int e = -1074; e <= 1023; ++e) EXPECT_EQ(own_log2(std::ldexp(1.0, e)), e);
}

TEST(Math, SinesAtSpecialValues)
{
    EXPECT_EQ(own_sin(0), 0);
    EXPECT_TRUE(std::signbit(own_sin(-0.0)));
    EXPECT_EQ(own_cos(0), 1);
    EXPECT_EQ(own_tan(0), 0);
    EXPECT_EQ(own_sin(kPi / 2), 1);
    EXPECT_EQ(own_cos(kPi), -1);
    for (const double x : {kInfinity, -kInfinity, kNaN, 1.1e6}) {
        EXPECT_TRUE(std::isnan(own_sin(x))) << x;
        EXPECT_TRUE(std::isnan(own_cos(x))) << x;
    }
    EXPECT_FALSE(std::isnan(own_sin(0x1p20)));
}

TEST(Math, Atan2AtSpecialValues)
{
    for (const double y : {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity}) {
        for (const double x : {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity}) {
            const double value = own_atan2(y, x);
            EXPECT_EQ(value, std::atan2(y, x)) << y << ", " << x;
            EXPECT_EQ(std::signbit(value), std::signbit(y)) << y << ", " << x;
        }
    }
    EXPECT_TRUE(std::isnan(own_atan2(kNaN, 1)));
    EXPECT_TRUE(std::isnan(own_atan2(1, kNaN)));
}

TEST(Math, PowAtSpecialValues)
{
    EXPECT_EQ(own_pow(0, 2.4), 0);
    EXPECT_EQ(own_pow(0, 0), 1);
    EXPECT_EQ(own_pow(0, -1), kInfinity);
    EXPECT_EQ(own_pow(1, 1e300), 1);
    EXPECT_TRUE(std::isnan(own_pow(-1, 2)));
    EXPECT_TRUE(std::isnan(own_pow(kNaN, 2)));
}

// A picture must not depend on who compiled the program: one hash over all functions.
TEST(Math, BitsAreTheSameEverywhere)
{
    std::uint64_t hash = 0;
    const auto add = [&](double value) {
        hash = mix64(hash ^ std::bit_cast<std::uint64_t>(value));
    };
    for (int i = 0; i < kTries; ++i) {
        const double x = between(-500, 500, i);
        add(own_exp(x));
        add(own_log(x + 501));
        add(own_log2(x + 501));
        add(own_sin(x));
        add(own_cos(x));
        add(own_tan(x));
        add(own_atan2(x, x - 7));
        add(own_pow(x + 501, 0.3));
    }
    EXPECT_EQ(hash, 2694135069604475814u);
}

}  // namespace
}  // namespace sheer
