// The oracle of stratified stochastic transparency, against values known from elsewhere and against
// what the paper says of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "reference/stratified_listing.h"

namespace sheer::reference {
namespace {

using Bits = std::vector<std::uint32_t>;

Bits paper_span(std::uint32_t count, std::uint32_t pixel, std::uint32_t surface, int samples)
{
    Bits bits;
    for (std::uint32_t n = 0; n < count; ++n) {
        bits.push_back(paper_bits(n, pixel, surface, samples));
    }
    return bits;
}

AlphaReference paper_reference(int samples)
{
    return [samples](std::uint32_t number, std::uint32_t pixel, std::uint32_t surface) {
        return value_of_bits(paper_bits(number, pixel, surface, samples));
    };
}

PixelFragment flat(double depth, double opacity, std::uint64_t covered, std::uint32_t id)
{
    PixelFragment fragment;
    fragment.covered = covered;
    fragment.depth.fill(depth);
    fragment.opacity = opacity;
    fragment.id = id;
    return fragment;
}

int owned(const std::vector<int>& owners, int fragment)
{
    return static_cast<int>(std::count(owners.begin(), owners.end(), fragment));
}

TEST(ReferenceStratified, PaperSequence)
{
    EXPECT_EQ(paper_span(8, 0, 0, 4), (Bits{0, 0x80000000u, 0x40000000u, 0xc0000000u, 0xa0000000u,
                                            0x20000000u, 0xe0000000u, 0x60000000u}));
    EXPECT_EQ(paper_span(4, 0, 1, 4), (Bits{0x3707b665u, 0xb707b665u, 0x7707b665u, 0xf707b665u}));
    EXPECT_EQ(paper_span(8, 5, 3, 8), (Bits{0x84c671d7u, 0x04c671d7u, 0xc4c671d7u, 0x44c671d7u,
                                            0xa4c671d7u, 0x24c671d7u, 0xe4c671d7u, 0x64c671d7u}));
}

TEST(ReferenceStratified, VegdahlSequence)
{
    const auto span = [](std::uint32_t seed) {
        Bits bits;
        for (std::uint32_t n = 0; n < 4; ++n) bits.push_back(vegdahl_bits(n, seed));
        return bits;
    };
    EXPECT_EQ(span(1), (Bits{0xbc7f85abu, 0x3c7f85abu, 0xfc7f85abu, 0x7c7f85abu}));
    EXPECT_EQ(span(0x9e3779b9u), (Bits{0x3cedbaa1u, 0xbcedbaa1u, 0xfcedbaa1u, 0x7cedbaa1u}));
}

// The second dimension begins with these (Bratley and Fox. Algorithm 659. ACM TOMS 14(1), 1988,
// with the primitive polynomial x + 1 and numbers in their own order).
TEST(ReferenceStratified, SobolSequence)
{
    const double expected[] = {0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875};
    for (std::uint32_t n = 0; n < 8; ++n) {
        EXPECT_EQ(value_of_bits(sobol_bits(n, 0, 0, 8)), expected[n]);
    }
    // A surface exchanges the values by the same bits everywhere.
    const std::uint32_t change = sobol_bits(0, 0, 1, 8) ^ sobol_bits(0, 0, 0, 8);
    for (std::uint32_t n = 0; n < 8; ++n) {
        EXPECT_EQ(sobol_bits(n, 0, 1, 8) ^ sobol_bits(n, 0, 0, 8), change);
    }
}

TEST(ReferenceStratified, Curves)
{
    EXPECT_EQ(hilbert_index(5, 9, 4096), 120u);
    EXPECT_EQ(hilbert_index(100, 200, 4096), 28272u);
    EXPECT_EQ(hilbert_index(1919, 1079, 4096), 2437354u);
    EXPECT_EQ(hilbert_index(3, 0, 4), 15u);
    EXPECT_EQ(morton_index(3, 5), 39u);
}

TEST(ReferenceStratified, CountsOfOneLayer)
{
    const int expected[] = {3, 2, 3, 2, 2, 3, 2, 3, 3, 2, 3, 2, 2, 2, 3, 2};
    for (std::uint32_t pixel = 0; pixel < 16; ++pixel) {
        const std::vector<PixelFragment> fragments = {flat(1, 0.3, 0xff, 0)};
        EXPECT_EQ(owned(stratified_owners(fragments, {8, pixel, 0, paper_reference(8)}), 0),
                  expected[pixel]);
    }
}

// Figure 5: of two layers of opacity 0.5 the far one keeps exactly a quarter, in both orders.
TEST(ReferenceStratified, FigureFive)
{
    const auto far_ones = [](bool far_first, StratifiedSwitches switches) {
        std::vector<PixelFragment> fragments = {flat(1, 0.5, 0xffff, 0), flat(2, 0.5, 0xffff, 1)};
        if (far_first) std::swap(fragments[0], fragments[1]);
        std::vector<int> counts;
        for (std::uint32_t pixel = 0; pixel < 256; ++pixel) {
            const auto owners =
                stratified_owners(fragments, {16, pixel, 77, paper_reference(16), switches});
            counts.push_back(owned(owners, far_first ? 0 : 1));
        }
        return counts;
    };
    const auto all_four = [](const std::vector<int>& counts) {
        return std::all_of(counts.begin(), counts.end(), [](int n) { return n == 4; });
    };
    EXPECT_TRUE(all_four(far_ones(false, {})));
    EXPECT_TRUE(all_four(far_ones(true, {})));
    EXPECT_TRUE(all_four(far_ones(false, {true, true, false})));
    EXPECT_FALSE(all_four(far_ones(true, {true, true, false})));
    EXPECT_FALSE(all_four(far_ones(false, {true, false, false})));
}

// However many pieces a surface is drawn in, without tracking it is not.
TEST(ReferenceStratified, PiecesAreOneSurface)
{
    std::mt19937 random(3);
    int off = 0;
    for (int round = 0; round < 3000; ++round) {
        const int samples = 1 << random() % 7;
        const double opacity = static_cast<double>(random() % 1000 + 1) / 1001;
        std::vector<PixelFragment> fragments(1 + random() % 16);
        for (std::uint32_t i = 0; i < fragments.size(); ++i) fragments[i] = flat(1, opacity, 0, i);
        for (int s = 0; s < samples; ++s) {
            fragments[random() % fragments.size()].covered |= 1ull << s;
        }
        const auto covered = [&](StratifiedSwitches switches) {
            const auto index = static_cast<std::uint32_t>(random() % 4096);
            const auto surface = static_cast<std::uint32_t>(random());
            const auto owners = stratified_owners(
                fragments, {samples, index, surface, paper_reference(samples), switches});
            return samples - owned(owners, -1);
        };
        const double whole = opacity * samples;
        const int count = covered({});
        EXPECT_TRUE(count == std::floor(whole) || count == std::ceil(whole));
        const int untracked = covered({false, true, true});
        off += untracked != std::floor(whole) && untracked != std::ceil(whole);
    }
    EXPECT_GT(off, 0);
}

TEST(ReferenceStratified, OpacityZeroAndOne)
{
    for (std::uint32_t pixel = 0; pixel < 64; ++pixel) {
        const StratifiedPixel setting = {16, pixel, pixel == 0 ? 0 : 5 * pixel,
                                         paper_reference(16)};
        const std::vector<PixelFragment> none = {flat(1, 0, 0xffff, 0)};
        EXPECT_EQ(owned(stratified_owners(none, setting), -1), 16);
        const std::vector<PixelFragment> all = {flat(1, 1, 0xffff, 0)};
        EXPECT_EQ(owned(stratified_owners(all, setting), 0), 16);
    }
}

TEST(ReferenceStratified, TiesGoToTheSmallerId)
{
    for (const bool swapped : {false, true}) {
        std::vector<PixelFragment> fragments = {flat(1, 1, 0xff, 0), flat(1, 1, 0xff, 1)};
        if (swapped) std::swap(fragments[0], fragments[1]);
        const auto owners = stratified_owners(fragments, {8, 9, 0, paper_reference(8)});
        EXPECT_EQ(owned(owners, swapped ? 1 : 0), 8);
    }
}

}  // namespace
}  // namespace sheer::reference
