// The oracles of the methods that are not exact, against numbers worked out elsewhere: by listing
// masks, by hand, or in other programs. What was printed holds to half a unit of its last digit.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "reference/methods.h"

namespace sheer::reference {
namespace {

constexpr double kExact = 1e-12;

// Numbers that are exact carry zeros to twelve decimals or are compared otherwise.
void expect_printed(double actual, const std::string& printed)
{
    const auto point = printed.find('.');
    const auto decimals = point == std::string::npos ? 0 : printed.size() - point - 1;
    EXPECT_NEAR(actual, std::stod(printed), 0.5 * std::pow(10, -static_cast<double>(decimals)));
}

void expect_printed(const Rgba& actual, const std::array<std::string, 3>& printed)
{
    expect_printed(actual.r, printed[0]);
    expect_printed(actual.g, printed[1]);
    expect_printed(actual.b, printed[2]);
}

void expect_near(const Rgba& actual, const Rgba& expected, double tolerance = kExact)
{
    EXPECT_NEAR(actual.r, expected.r, tolerance);
    EXPECT_NEAR(actual.g, expected.g, tolerance);
    EXPECT_NEAR(actual.b, expected.b, tolerance);
    EXPECT_NEAR(actual.a, expected.a, tolerance);
}

double deviation(const Moments& moments)
{
    return std::sqrt(moments.variance);
}

const Rgba kBackdrop = {0.1, 0.2, 0.3, 0.5};

const std::vector<Fragment> kFiveLayers = {{0.2, 0.5, {1, 0, 0}, 1},
                                           {0.4, 0.4, {0, 1, 0}, 2},
                                           {0.5, 0.3, {0, 0, 1}, 3},
                                           {0.7, 0.6, {1, 1, 0}, 4},
                                           {0.9, 0.2, {1, 1, 1}, 5}};

const std::vector<Fragment> kRedGreenBlue = {
    {5, 0.5, {1, 0, 0}, 1}, {10, 0.5, {0, 1, 0}, 2}, {20, 0.5, {0, 0, 1}, 3}};

TEST(ReferenceExact, GoldenPixels)
{
    expect_printed(composite(kFiveLayers, {}), {"0.642800", "0.342800", "0.106800"});
    expect_printed(1 - composite(kFiveLayers, {}).a, "0.067200");
    expect_near(composite(kRedGreenBlue, {}), {0.5, 0.25, 0.125, 0.875});
}

TEST(ReferenceBlend, IsExactFromFarToNearOnly)
{
    std::vector<Fragment> fragments = kFiveLayers;
    // The first arrival ends up behind: the last layer's colour has its opacity for a weight.
    const Rgba forwards = blend(fragments, {});
    EXPECT_NEAR(forwards.b, 0.2 + 0.8 * 0.4 * 0.3, kExact);
    EXPECT_NEAR(forwards.a, 1 - 0.067200, kExact);
    std::reverse(fragments.begin(), fragments.end());
    expect_near(blend(fragments, kBackdrop), composite(fragments, kBackdrop));
    expect_near(blend({}, kBackdrop), kBackdrop, 0);
}

TEST(ReferenceWeightedAverage, OneFragmentIsOver)
{
    const std::vector<Fragment> one = {{0.5, 0.3, {0.9, 0.5, 0.1}, 1}};
    expect_near(weighted_average(one, kBackdrop), composite(one, kBackdrop));
}

TEST(ReferenceWeightedAverage, EqualFragmentsAreOver)
{
    const std::vector<Fragment> equal(7, {0.5, 0.3, {0.9, 0.5, 0.1}, 1});
    expect_near(weighted_average(equal, kBackdrop), composite(equal, kBackdrop));
}

TEST(ReferenceWeightedAverage, ByHand)
{
    // C = (0.5, 0, 0.25) / 0.75, T = (1 - 0.375)^2.
    const std::vector<Fragment> two = {{1, 0.5, {1, 0, 0}, 1}, {2, 0.25, {0, 0, 1}, 2}};
    const double t = 0.390625;
    expect_near(weighted_average(two, kBackdrop),
                {2.0 / 3 * (1 - t) + 0.1 * t, 0.2 * t, 1.0 / 3 * (1 - t) + 0.3 * t, 1 - 0.5 * t});
}

TEST(ReferenceWeightedAverage, NothingVisibleIsTheBackdrop)
{
    const std::vector<Fragment> clear(3, {0.5, 0, {9, 9, 9}, 1});
    expect_near(weighted_average({}, kBackdrop), kBackdrop, 0);
    expect_near(weighted_average(clear, kBackdrop), kBackdrop, 0);
}

TEST(ReferenceWeightedAverage, IgnoresTheOrderOfArrival)
{
    const Rgba expected = weighted_average(kFiveLayers, kBackdrop);
    std::vector<Fragment> fragments = kFiveLayers;
    const auto by_id = [](const Fragment& a, const Fragment& b) { return a.id < b.id; };
    while (std::next_permutation(fragments.begin(), fragments.end(), by_id)) {
        expect_near(weighted_average(fragments, kBackdrop), expected);
    }
}

TEST(ReferenceWboit, Weights)
{
    const double z[5] = {1, 5, 10, 50, 100};
    const std::pair<WboitWeight, std::array<std::string, 5>> rows[] = {
        {WboitWeight::eq7, {"249.938", "9.9999", "2.49999", "0.0999997", "0.024999"}},
        {WboitWeight::eq8,
         {"3000.000000000000", "79.9936", "9.9999", "0.0799998", "0.010000000000"}},
        {WboitWeight::eq9, {"2999.81", "2887.22", "1846.15", "7.66039", "0.479923"}},
        {WboitWeight::eq10,
         {"2.98383", "0.0233012", "0.010000000000", "0.010000000000", "0.010000000000"}},
        {WboitWeight::uniform,
         {"1.000000000000", "1.000000000000", "1.000000000000", "1.000000000000",
          "1.000000000000"}}};
    for (const auto& [weight, printed] : rows) {
        for (std::size_t i = 0; i < 5; ++i) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(weight) << " at " << z[i]);
            expect_printed(wboit_weight(weight, z[i], 0.1, 500), printed[i]);
        }
    }
}

TEST(ReferenceWboit, PlanesOfEquation10)
{
    const auto at = [](double z, double zfar) {
        return wboit_weight(WboitWeight::eq10, z, 0.1, zfar);
    };
    EXPECT_NEAR(at(0.1, 500), 3000, 3000 * kExact);
    EXPECT_NEAR(at(500, 500), 0.01, kExact);
    // No far plane: (1 - d)^3 = (znear / z)^3, and the limit of far planes further and further off.
    EXPECT_NEAR(at(0.5, 0), 3000 / 125.0, 3000 * kExact);
    EXPECT_NEAR(at(0.5, 1e12), at(0.5, 0), 3000 * kExact);
}

TEST(ReferenceWboit, ThreeLayers)
{
    const auto color = [](WboitWeight weight) {
        return wboit(kRedGreenBlue, weight, 0.1, 500, {});
    };
    expect_printed(color(WboitWeight::eq7), {"0.666665", "0.166668", "0.041667"});
    expect_printed(color(WboitWeight::eq8), {"0.767117", "0.095896", "0.011987"});
    expect_printed(color(WboitWeight::eq9), {"0.504648", "0.322683", "0.047669"});
    expect_printed(color(WboitWeight::eq10), {"0.470854", "0.202073", "0.202073"});
    expect_printed(color(WboitWeight::uniform), {"0.291667", "0.291667", "0.291667"});
    expect_printed(wboit(kFiveLayers, WboitWeight::uniform, 0.1, 500, {}),
                   {"0.606320", "0.559680", "0.233200"});
}

TEST(ReferenceWboit, OpacityCountsTwiceInTheWeight)
{
    // Both at z = 5: weights 0.25 and 0.0625 of the colours, not 0.5 and 0.25; reveal = 0.375.
    const std::vector<Fragment> two = {{5, 0.5, {1, 0, 0}, 1}, {5, 0.25, {0, 1, 0}, 2}};
    expect_near(wboit(two, WboitWeight::eq7, 0.1, 500, {0, 0, 1, 1}),
                {0.8 * 0.625, 0.2 * 0.625, 0.375, 1});
    expect_near(wboit(two, WboitWeight::uniform, 0.1, 500, {0, 0, 1, 1}),
                {0.625 * 2 / 3, 0.625 / 3, 0.375, 1});
}

TEST(ReferenceWboit, OneFragmentIsOverHoweverFaint)
{
    for (const double opacity : {1e-6, 0.3, 1.0}) {
        const std::vector<Fragment> one = {{100, opacity, {0.9, 0.5, 0.1}, 1}};
        const Rgba over = composite(one, kBackdrop);
        for (const auto weight : {WboitWeight::eq7, WboitWeight::eq8, WboitWeight::eq9,
                                  WboitWeight::eq10, WboitWeight::uniform}) {
            expect_near(wboit(one, weight, 0.1, 0, kBackdrop), over);
        }
    }
    expect_near(wboit({}, WboitWeight::eq7, 0.1, 0, kBackdrop), kBackdrop, 0);
}

TEST(ReferenceMasks, UnionOfTwoHalves)
{
    // Of 8 samples the first mask left 4: the union is 4 and what the second covers anew.
    const auto probability = newly_covered(4, 0.5, Masks::stratified, 8);
    const std::string printed[] = {"0.014286", "0.228571", "0.514286", "0.228571", "0.014286"};
    ASSERT_EQ(probability.size(), 5u);
    for (std::size_t k = 0; k < 5; ++k) {
        expect_printed(probability[k], printed[k]);
    }
    expect_printed(probability[1] + probability[2] + probability[3], "0.971429");
}

TEST(ReferenceMasks, StratifiedKeepsOneOfTwoNeighboringCounts)
{
    const auto some = newly_covered(4, 0.45, Masks::stratified, 4);
    EXPECT_NEAR(some[1], 0.2, kExact);
    EXPECT_NEAR(some[2], 0.8, kExact);
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        EXPECT_EQ(newly_covered(3, 0, masks, 4), (std::vector<double>{1, 0, 0, 0}));
        EXPECT_EQ(newly_covered(3, 1, masks, 4), (std::vector<double>{0, 0, 0, 1}));
    }
}

struct MasksRow {
    int samples;
    std::array<std::string, 4> stratified, naive;  // deviations behind layers 1 to 4
};

const MasksRow kMasksTable[] = {{4,
                                 {"0.100000", "0.138444", "0.155242", "0.136770"},
                                 {"0.229129", "0.238485", "0.224499", "0.157683"}},
                                {8,
                                 {"0.061237", "0.091124", "0.103429", "0.091714"},
                                 {"0.162019", "0.168634", "0.158745", "0.111499"}},
                                {16,
                                 {"0.025000", "0.060381", "0.069214", "0.063096"},
                                 {"0.114564", "0.119242", "0.112250", "0.078842"}},
                                {32,
                                 {"0.015309", "0.041836", "0.048091", "0.043869"},
                                 {"0.081009", "0.084317", "0.079373", "0.055749"}},
                                {64,
                                 {"0.006250", "0.029033", "0.033463", "0.030779"},
                                 {"0.057282", "0.059621", "0.056125", "0.039421"}},
                                {128,
                                 {"0.003827", "0.020421", "0.023553", "0.021667"},
                                 {"0.040505", "0.042159", "0.039686", "0.027875"}}};

TEST(ReferenceMasks, UncoveredBehindFourLayers)
{
    const double opacities[] = {0.3, 0.5, 0.2, 0.6};
    const double means[] = {0.7, 0.35, 0.28, 0.112};
    for (const MasksRow& row : kMasksTable) {
        SCOPED_TRACE(row.samples);
        const auto stratified = uncovered(opacities, Masks::stratified, row.samples);
        const auto naive = uncovered(opacities, Masks::naive, row.samples);
        ASSERT_EQ(stratified.size(), 4u);
        ASSERT_EQ(naive.size(), 4u);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(stratified[i].mean, means[i], kExact);
            EXPECT_NEAR(naive[i].mean, means[i], kExact);
            expect_printed(deviation(stratified[i]), row.stratified[i]);
            expect_printed(deviation(naive[i]), row.naive[i]);
        }
    }
}

TEST(ReferenceMasks, OneStratifiedLayerRoundsItsOpacity)
{
    // R is one of two neighbours: variance f (1 - f) / S^2, f the fraction of opacity S.
    for (const int samples : {1, 4, 64, 256}) {
        const double opacities[] = {0.3};
        const double f = 0.3 * samples - std::floor(0.3 * samples);
        EXPECT_NEAR(uncovered(opacities, Masks::stratified, samples)[0].variance,
                    f * (1 - f) / samples / samples, kExact);
    }
}

TEST(ReferenceMasks, ThinMedium)
{
    struct Row {
        int samples;
        std::string stratified, naive;
    };
    for (const Row& row : {Row{4, "0.160822", "0.232537"}, Row{8, "0.111727", "0.167907"},
                           Row{16, "0.078446", "0.119709"}, Row{64, "0.039033", "0.060178"}}) {
        SCOPED_TRACE(row.samples);
        const auto layers = static_cast<std::size_t>(row.samples);
        const std::vector<double> opacities(layers, 1.0 / row.samples);
        expect_printed(deviation(uncovered(opacities, Masks::stratified, row.samples).back()),
                       row.stratified);
        expect_printed(deviation(uncovered(opacities, Masks::naive, row.samples).back()),
                       row.naive);
    }
}

TEST(ReferenceMasks, NaiveIsBinomial)
{
    // Visibility v: variance v (1 - v) / S, fourth v (1 - v) (1 + (3 S - 6) v (1 - v)) / S^3.
    const std::pair<int, std::string> printed[] = {{8, "0.1686"}, {32, "0.0843"}, {256, "0.0298"}};
    for (const auto& [samples, sigma] : printed) {
        const double opacities[] = {0.65};
        const Moments moments = uncovered(opacities, Masks::naive, samples)[0];
        const double s = samples;
        const double bernoulli = 0.35 * 0.65;
        expect_printed(deviation(moments), sigma);
        EXPECT_NEAR(moments.mean, 0.35, kExact);
        EXPECT_NEAR(moments.variance, bernoulli / s, kExact);
        EXPECT_NEAR(moments.fourth, bernoulli * (1 + (3 * s - 6) * bernoulli) / (s * s * s),
                    kExact);
    }
}

}  // namespace
}  // namespace sheer::reference
