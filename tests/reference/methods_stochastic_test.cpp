// The moments of stochastic transparency: against the examples of E. Enderton et al., "Stochastic
// transparency", 2010, as exact enumeration has them (some of the paper's printed numbers differ),
// and against masks listed here. Printed numbers hold to half a unit of their last digit.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "reference/methods.h"

namespace sheer::reference {
namespace {

constexpr double kExact = 1e-12;

using Printed = std::array<std::string, 3>;

void expect_printed(double actual, const std::string& printed)
{
    const std::size_t decimals = printed.size() - printed.find('.') - 1;
    EXPECT_NEAR(actual, std::stod(printed), 0.5 * std::pow(10, -static_cast<double>(decimals)));
}

void expect_deviations(const std::array<Moments, 4>& moments, const Printed& printed)
{
    for (std::size_t i = 0; i < 3; ++i) {
        expect_printed(std::sqrt(moments[i].variance), printed[i]);
    }
}

void expect_near(const std::array<Moments, 4>& actual, const std::array<Moments, 4>& expected)
{
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(actual[i].mean, expected[i].mean, kExact) << i;
        EXPECT_NEAR(actual[i].variance, expected[i].variance, kExact) << i;
        EXPECT_NEAR(actual[i].fourth, expected[i].fourth, kExact) << i;
    }
}

void expect_means(const std::array<Moments, 4>& moments, const Rgba& expected)
{
    EXPECT_NEAR(moments[0].mean, expected.r, kExact);
    EXPECT_NEAR(moments[1].mean, expected.g, kExact);
    EXPECT_NEAR(moments[2].mean, expected.b, kExact);
    EXPECT_NEAR(moments[3].mean, expected.a, kExact);
}

constexpr Rgba kBlue = {0, 0, 1, 1};
const std::vector<Fragment> kRedOverGreen = {{1, 0.45, {1, 0, 0}, 1}, {2, 0.45, {0, 1, 0}, 2}};

TEST(ReferenceStochastic, RedOverGreenOverBlue)
{
    const std::pair<int, Printed> rows[] = {{4, {"0.100000", "0.154765", "0.157962"}},
                                            {8, {"0.061237", "0.101958", "0.103781"}},
                                            {16, {"0.025000", "0.066175", "0.066646"}},
                                            {32, {"0.015309", "0.045724", "0.045980"}},
                                            {64, {"0.006250", "0.031492", "0.031554"}}};
    for (const auto& [samples, printed] : rows) {
        SCOPED_TRACE(samples);
        const auto moments = stochastic(kRedOverGreen, Masks::stratified, samples, kBlue);
        expect_deviations(moments, printed);
        expect_means(moments, {0.45, 0.2475, 0.3025, 1});
    }
    expect_deviations(stochastic(kRedOverGreen, Masks::naive, 4, kBlue),
                      {"0.248747", "0.215780", "0.229670"});
}

TEST(ReferenceStochastic, FourWhiteOverGray)
{
    const std::vector<Fragment> white(4, {1, 0.25, {1, 1, 1}, 1});
    const Rgba gray = {0.25, 0.25, 0.25, 1};
    const Rgba expected = {0.7626953125, 0.7626953125, 0.7626953125, 1};
    const auto naive = stochastic(white, Masks::naive, 4, gray);
    const auto stratified = stochastic(white, Masks::stratified, 4, gray);
    expect_deviations(naive, {"0.174403", "0.174403", "0.174403"});
    expect_deviations(stratified, {"0.120616", "0.120616", "0.120616"});
    expect_deviations(stochastic(white, Masks::naive, 1, gray),
                      {"0.348805", "0.348805", "0.348805"});
    expect_means(naive, expected);
    expect_means(stratified, expected);
    EXPECT_NEAR(stochastic(white, Masks::stratified, 4, {})[3].mean, 0.68359375, kExact);
}

TEST(ReferenceStochastic, TwoQuartersOfFourSamples)
{
    const std::vector<Fragment> two = {{1, 0.25, {1, 0, 0}, 1}, {2, 0.25, {0, 1, 0}, 2}};
    const auto moments = stochastic(two, Masks::stratified, 4, kBlue);
    expect_deviations(moments, {"0.000000000000", "0.108253", "0.108253"});
    expect_means(moments, {0.25, 0.1875, 0.5625, 1});
}

// Layers whose opacities differ in the fraction of four samples, over a backdrop with all channels.
const std::vector<Fragment> kTwoLayers = {{1, 0.45, {0.9, 0.3, 0.1}, 1},
                                          {2, 0.7, {0.2, 0.8, 0.5}, 2}};
constexpr Rgba kBackdrop = {0.1, 0.2, 0.3, 0.5};

double probability_of_mask(unsigned mask, double opacity, Masks masks)
{
    const int kept = std::popcount(mask);
    if (masks == Masks::naive) {
        return std::pow(opacity, kept) * std::pow(1 - opacity, 4 - kept);
    }
    const double subsets[5] = {1, 4, 6, 4, 1};
    return std::max(0.0, 1 - std::abs(4 * opacity - kept)) / subsets[kept];
}

std::array<double, 4> pixel_of_masks(unsigned first, unsigned second)
{
    std::array<double, 4> sum = {};
    for (unsigned sample = 0; sample < 4; ++sample) {
        std::array<double, 4> color = {kBackdrop.r, kBackdrop.g, kBackdrop.b, kBackdrop.a};
        for (const auto& [mask, layer] : {std::pair(second, 1u), std::pair(first, 0u)}) {
            if ((mask >> sample & 1) != 0) {
                std::copy_n(kTwoLayers[layer].color, 3, color.begin());
                color[3] = 1;
            }
        }
        for (std::size_t i = 0; i < 4; ++i) {
            sum[i] += color[i] / 4;
        }
    }
    return sum;
}

// Calls visit(probability, pixel) for each pair of masks.
template <typename Visit>
void list_masks(Masks masks, Visit visit)
{
    for (unsigned first = 0; first < 16; ++first) {
        for (unsigned second = 0; second < 16; ++second) {
            visit(probability_of_mask(first, kTwoLayers[0].opacity, masks) *
                      probability_of_mask(second, kTwoLayers[1].opacity, masks),
                  pixel_of_masks(first, second));
        }
    }
}

TEST(ReferenceStochastic, AgreesWithAllMasksListed)
{
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        SCOPED_TRACE(static_cast<int>(masks));
        std::array<Moments, 4> expected;
        double total = 0;
        list_masks(masks, [&](double probability, const std::array<double, 4>& pixel) {
            total += probability;
            for (std::size_t i = 0; i < 4; ++i) {
                expected[i].mean += probability * pixel[i];
            }
        });
        EXPECT_NEAR(total, 1, kExact);
        list_masks(masks, [&](double probability, const std::array<double, 4>& pixel) {
            for (std::size_t i = 0; i < 4; ++i) {
                const double off = pixel[i] - expected[i].mean;
                expected[i].variance += probability * off * off;
                expected[i].fourth += probability * off * off * off * off;
            }
        });
        expect_near(stochastic(kTwoLayers, masks, 4, kBackdrop), expected);
    }
}

TEST(ReferenceStochastic, HasNoBias)
{
    const std::vector<Fragment> layers = {{0.2, 0.5, {1, 0, 0}, 1},
                                          {0.4, 0.4, {0, 1, 0}, 2},
                                          {0.5, 0.3, {0, 0, 1}, 3},
                                          {0.7, 0.6, {1, 1, 0}, 4},
                                          {0.9, 0.2, {1, 1, 1}, 5}};
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        for (const int samples : {1, 2, 4, 8, 16, 32, 64}) {
            const auto moments = stochastic(layers, masks, samples, kBackdrop);
            expect_means(moments, {0.642800 + 0.1 * 0.067200, 0.342800 + 0.2 * 0.067200,
                                   0.106800 + 0.3 * 0.067200, 1 - 0.5 * 0.067200});
        }
    }
}

TEST(ReferenceStochastic, AlphaOverNothingIsOneLessTheUncovered)
{
    const double opacities[] = {0.45, 0.7};
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        const Moments open = uncovered(opacities, masks, 16).back();
        const Moments alpha = stochastic(kTwoLayers, masks, 16, {})[3];
        EXPECT_NEAR(alpha.mean, 1 - open.mean, kExact);
        EXPECT_NEAR(alpha.variance, open.variance, kExact);
        EXPECT_NEAR(alpha.fourth, open.fourth, kExact);
    }
}

TEST(ReferenceStochastic, IgnoresTheOrderOfArrival)
{
    const std::vector<Fragment> layers = {
        {2, 0.45, {1, 0, 0}, 7}, {2, 0.3, {0, 1, 0}, 3}, {1, 0.6, {1, 1, 0}, 9}};
    std::vector<Fragment> sorted = {layers[2], layers[1], layers[0]};
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        sorted[i].depth = static_cast<double>(i);  // no tie is left
    }
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        const auto expected = stochastic(sorted, masks, 8, kBlue);
        std::vector<Fragment> shuffled = layers;
        for (int turn = 0; turn < 3; ++turn) {
            expect_near(stochastic(shuffled, masks, 8, kBlue), expected);
            std::rotate(shuffled.begin(), shuffled.begin() + 1, shuffled.end());
        }
    }
}

TEST(ReferenceStochastic, NothingIsRandomWithoutPartialOpacity)
{
    const std::vector<Fragment> layers = {
        {1, 0, {9, 9, 9}, 1}, {2, 1, {0.5, 0.25, 0.125}, 2}, {3, 0.5, {1, 1, 1}, 3}};
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        expect_near(stochastic({}, masks, 8, kBackdrop), {{{0.1}, {0.2}, {0.3}, {0.5}}});
        expect_near(stochastic(layers, masks, 8, kBackdrop), {{{0.5}, {0.25}, {0.125}, {1}}});
    }
}

}  // namespace
}  // namespace sheer::reference
