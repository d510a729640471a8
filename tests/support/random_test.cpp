// Counter-based random numbers: published vectors, and what uniform means.
#include "support/random.h"

#include <cstdint>

#include <gtest/gtest.h>

namespace sheer {
namespace {

// The inverse that its author published beside the hash.
std::uint32_t inverse_hash_u32(std::uint32_t x)
{
    x ^= x >> 16;
    x *= 0x43021123u;
    x ^= x >> 15 ^ x >> 30;
    x *= 0x1d69e2a5u;
    x ^= x >> 16;
    return x;
}

TEST(Random, Hash32IsUndoneByItsPublishedInverse)
{
    for (std::uint32_t i = 0; i < 100000; ++i) {
        const std::uint32_t x = i * 2654435761u;
        EXPECT_EQ(inverse_hash_u32(hash_u32(x)), x);
    }
}

// The outputs of splitmix64 for the seeds 0 and 1234567.
TEST(Random, Mix64GivesTheSequenceOfSplitmix64)
{
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;
    EXPECT_EQ(mix64(kGolden), 0xe220a8397b1dcdafu);
    EXPECT_EQ(mix64(2 * kGolden), 0x6e789e6aa1b965f4u);
    EXPECT_EQ(mix64(3 * kGolden), 0x06c45d188009454fu);
    EXPECT_EQ(mix64(1234567 + kGolden), 6457827717110365317u);
    EXPECT_EQ(mix64(1234567 + 2 * kGolden), 3203168211198807973u);
    EXPECT_EQ(mix64(1234567 + 3 * kGolden), 9817491932198370423u);
}

TEST(Random, UnitFloatStaysBelowOne)
{
    EXPECT_EQ(unit_float(0), 0.0f);
    EXPECT_EQ(unit_float(0xffu), 0.0f);
    EXPECT_EQ(unit_float(0x80000000u), 0.5f);
    EXPECT_EQ(unit_float(0xffffffffu), 1.0f - 0x1p-24f);
}

TEST(Random, CounterRandomIsThatSequenceFromTheMixedSeed)
{
    EXPECT_EQ(CounterRandom{0}.bits(0), 0xe220a8397b1dcdafu);
    EXPECT_EQ(CounterRandom{0}.bits(2), 0x06c45d188009454fu);
    EXPECT_EQ(CounterRandom{0}.uniform(0), static_cast<double>(0xe220a8397b1dcdafu >> 11) / 0x1p53);
    // Neighbouring seeds are not one sequence, shifted.
    EXPECT_NE(CounterRandom{1}.bits(0), CounterRandom{0}.bits(1));
}

// Chi-squared over 64 bins, 63 degrees of freedom: above 131 with probability 1e-6. The numbers are
// fixed, so the test passes always or never.
TEST(Random, UniformFillsItsInterval)
{
    constexpr int kBins = 64;
    constexpr int kDraws = 64000;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        int count[kBins] = {};
        for (std::uint64_t i = 0; i < kDraws; ++i) {
            const double u = CounterRandom{seed}.uniform(i);
            ASSERT_GE(u, 0);
            ASSERT_LT(u, 1);
            ++count[static_cast<int>(u * kBins)];
        }
        double chi_squared = 0;
        for (const int n : count) {
            const double excess = n - kDraws / kBins;
            chi_squared += excess * excess / (kDraws / kBins);
        }
        EXPECT_LT(chi_squared, 131) << "seed " << seed;
    }
}

}  // namespace
}  // namespace sheer
