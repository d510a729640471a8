// The numbers of stratified stochastic transparency (shaders/sheer/stratified_stochastic.glsl):
// what is known of them from elsewhere, and what the method needs of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "lanes/lone.h"
#include "methods/stratified_settings.h"
#include "reference/stratified_listing.h"
#include "support/random.h"

namespace sheer {

namespace {

struct Text {
    using L = Lone<float>;
#include "lanes/text_words.h"
#include "sheer/bits.glsl"
#include "sheer/random.glsl"
#include "sheer/stratified_stochastic.glsl"
};

constexpr std::uint32_t kSurfaces[] = {0, 1, 2, 7, 1000, ~0u, 0x9e3779b9u};

std::uint32_t bits_of(Sequence sequence, std::uint32_t index, std::uint32_t surface)
{
    return Text::reference_bits(static_cast<int>(sequence), Text::reversed_bits(index), surface);
}

// Whether every aligned span of 2^k of the first indices has one value in each 2^-k of the whole.
bool spans_are_stratified(Sequence sequence, std::uint32_t surface)
{
    for (int k = 1; k <= 10; ++k) {
        const std::uint32_t size = 1u << k;
        for (std::uint32_t first = 0; first < 8192; first += size) {
            std::vector<int> hits(size);
            for (std::uint32_t i = first; i < first + size; ++i) {
                ++hits[bits_of(sequence, i, surface) >> (32 - k)];
            }
            if (std::count(hits.begin(), hits.end(), 1) != static_cast<std::ptrdiff_t>(size)) {
                return false;
            }
        }
    }
    return true;
}

// The correlation of two surfaces' values over indices from 0 on, in units of what n independent
// pairs have for a standard deviation.
double correlation(Sequence sequence, std::uint32_t a, std::uint32_t b)
{
    constexpr std::uint32_t kCount = 1u << 16;
    double sum = 0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        sum +=
            (bits_of(sequence, i, a) * 0x1p-32 - 0.5) * (bits_of(sequence, i, b) * 0x1p-32 - 0.5);
    }
    return 12 * sum / kCount * std::sqrt(static_cast<double>(kCount));
}

}  // namespace

TEST(StratifiedText, HasTheOraclesNumbers)
{
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const std::uint32_t a = hash_u32(i + 1), b = hash_u32(a);
        const int samples = 1 << i % 7;
        const std::uint32_t number = a % static_cast<std::uint32_t>(samples), pixel = b >> 4;
        const std::uint32_t reversed =
            Text::reversed_bits(number) +
            Text::reversed_bits(pixel * static_cast<std::uint32_t>(samples));
        const std::uint32_t surface = i % 2 == 0 ? i / 2 : a ^ b;
        EXPECT_EQ(Text::reference_bits(0, reversed, surface),
                  reference::paper_bits(number, pixel, surface, samples));
        EXPECT_EQ(Text::reference_bits(2, reversed, surface),
                  reference::sobol_bits(number, pixel, surface, samples));
        EXPECT_EQ(Text::scrambled_by(Text::reversed_bits(a), surface),
                  reference::vegdahl_bits(a, surface));
        const std::uint32_t x = a % 16384, y = b % 16384;
        EXPECT_EQ(Text::hilbert_index(x, y), reference::hilbert_index(x, y, 16384));
        EXPECT_EQ(Text::morton_index(x, y), reference::morton_index(x, y));
        EXPECT_EQ(Text::bit_count(a), static_cast<std::uint32_t>(std::popcount(a)));
        const float opacity = unit_float(b);
        EXPECT_EQ(Text::stratified_takes(opacity, a),
                  static_cast<double>(opacity) > reference::value_of_bits(a));
    }
}

// A curve that leaps would not keep neighbours together, and one that turns with the size of the
// picture or its tiles would give them other values.
TEST(StratifiedText, HilbertsCurveGoesFromNeighbourToNeighbour)
{
    EXPECT_EQ(Text::hilbert_index(0, 0), 0u);
    EXPECT_EQ(Text::hilbert_index(1, 0), 1u);
    std::vector<std::pair<int, int>> places(64 * 64, {-1, -1});
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            const std::uint32_t index = Text::hilbert_index(x, y);
            ASSERT_LT(index, places.size());
            places[index] = {static_cast<int>(x), static_cast<int>(y)};
        }
    }
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        EXPECT_EQ(std::abs(places[i].first - places[i + 1].first) +
                      std::abs(places[i].second - places[i + 1].second),
                  1);
    }
}

TEST(StratifiedText, EveryAlignedSpanIsStratified)
{
    for (const std::uint32_t surface : kSurfaces) {
        for (const Sequence sequence : {Sequence::paper, Sequence::vegdahl, Sequence::sobol}) {
            EXPECT_TRUE(spans_are_stratified(sequence, surface)) << surface;
        }
        EXPECT_FALSE(spans_are_stratified(Sequence::random, surface));
    }
}

// Four standard deviations: of 84 pairs of independent numbers one is beyond in 190 tries. Sobol's
// are not independent.
TEST(StratifiedText, SurfacesDoNotKnowOfOneAnother)
{
    double most_of_sobol = 0;
    for (const std::uint32_t surface : kSurfaces) {
        for (const std::uint32_t step : {1u, 2u, 3u, 4u}) {
            for (const Sequence sequence : {Sequence::paper, Sequence::vegdahl, Sequence::random}) {
                EXPECT_LT(std::abs(correlation(sequence, surface, surface + step)), 4)
                    << surface << " + " << step;
            }
            most_of_sobol = std::max(
                most_of_sobol, std::abs(correlation(Sequence::sobol, surface, surface + step)));
        }
    }
    EXPECT_GT(most_of_sobol, 4);
}

TEST(StratifiedText, OpacityZeroAndOne)
{
    for (const std::uint32_t bits : {0u, 1u, 0xffu, 0x100u, 0x80000000u, 0xffffff00u, ~0u}) {
        EXPECT_FALSE(Text::stratified_takes(0.0f, bits));
        EXPECT_TRUE(Text::stratified_takes(1.0f, bits));
    }
}

}  // namespace sheer
