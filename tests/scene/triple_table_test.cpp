// Numbers in the order of arrival, whatever the triples are.
#include "scene/triple_table.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace sheer::test {
namespace {

// x ^= x >> shift, back again.
std::uint64_t unshift(std::uint64_t y, int shift)
{
    std::uint64_t x = y;
    for (int known = shift; known < 64; known += shift) x = y ^ (x >> shift);
    return x;
}

// The number whose product with an odd one is 1: each step of Newton's doubles the right bits.
std::uint64_t reciprocal(std::uint64_t odd)
{
    std::uint64_t x = odd;
    for (int step = 0; step < 6; ++step) x *= 2 - odd * x;
    return x;
}

std::uint64_t unmix64(std::uint64_t x)
{
    x = unshift(x, 31) * reciprocal(0x94d049bb133111ebu);
    x = unshift(x, 27) * reciprocal(0xbf58476d1ce4e5b9u);
    return unshift(x, 30);
}

void expect_numbers_by_arrival(const std::vector<Triple>& triples)
{
    TripleTable table;
    for (int time = 0; time < 2; ++time) {
        std::uint32_t number = 0;
        std::size_t wrong = 0;
        for (const Triple& triple : triples) wrong += table.number_of(triple) != number++;
        EXPECT_EQ(wrong, 0u);
    }
    EXPECT_EQ(table.triples(), triples);
}

TEST(TripleTable, NumbersByArrival)
{
    std::vector<Triple> triples;
    for (std::uint32_t i = 0; i < 10000; ++i) triples.push_back({i % 7, i / 49, i / 7 % 7});
    expect_numbers_by_arrival(triples);
}

// A file's author may pick triples that all begin to look in the same slot: 50,000 of them would
// take 10^9 steps by probing alone.
TEST(TripleTable, TriplesThatMeetCostNoMore)
{
    std::vector<Triple> triples;
    for (std::uint64_t k = 0; k < 50000; ++k) {
        const std::uint64_t hash = k << 24;
        ASSERT_EQ(mix64(unmix64(hash)), hash);
        const std::uint64_t first = unmix64(unmix64(hash));
        triples.push_back(
            {static_cast<std::uint32_t>(first >> 32), static_cast<std::uint32_t>(first), 0});
    }
    expect_numbers_by_arrival(triples);
}

}  // namespace
}  // namespace sheer::test
