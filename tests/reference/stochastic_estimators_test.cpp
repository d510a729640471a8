// The estimators of stochastic transparency: against the examples of E. Enderton et al.,
// "Stochastic transparency", 2010, as exact enumeration has them (several of the paper's printed
// numbers differ), and the two ways to compute them against each other. Numbers given as text hold
// to half a unit of their last digit.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "reference/stochastic_estimators.h"

namespace sheer::reference {
namespace {

constexpr double kExact = 1e-12;

constexpr Estimator kAll[] = {
    Estimator::basic,
    Estimator::alpha_corrected,
    Estimator::depth_based,
    Estimator::depth_based_clamped,
    Estimator::depth_based_empty,
    Estimator::depth_based_remainder,
    Estimator::depth_corrected,
    Estimator::depth_over_coverage,
};

using Printed = std::array<std::string, 3>;

void expect_printed(double actual, const std::string& printed)
{
    const std::size_t point = printed.find('.');
    const std::size_t decimals = point == std::string::npos ? 0 : printed.size() - point - 1;
    // A hair more than half a unit: what lies in the middle of two may be printed as either.
    const double half = 0.5 * std::pow(10, -static_cast<double>(decimals));
    EXPECT_NEAR(actual, std::stod(printed), half * (1 + 1e-6) + kExact) << printed;
}

void expect_deviations(const std::array<Moments, 4>& moments, const Printed& printed)
{
    for (std::size_t c = 0; c < 3; ++c) expect_printed(std::sqrt(moments[c].variance), printed[c]);
}

void expect_means(const std::array<Moments, 4>& moments, const Printed& printed)
{
    for (std::size_t c = 0; c < 3; ++c) expect_printed(moments[c].mean, printed[c]);
}

void expect_rms(const std::array<Moments, 4>& moments, const EstimatedPixel& pixel,
                const Printed& printed)
{
    const Rgba over = composite(pixel.fragments, pixel.backdrop);
    const double truth[] = {over.r, over.g, over.b};
    for (std::size_t c = 0; c < 3; ++c) {
        expect_printed(rms_error(moments[c], truth[c]), printed[c]);
    }
}

EstimatedPixel example_1(int samples)
{
    return {{{1, 0.45, {1, 0, 0}, 1}, {2, 0.45, {0, 1, 0}, 2}}, {0, 0, 1, 1}, samples};
}

EstimatedPixel example_2(int samples)
{
    const std::vector<Fragment> white(4, {1, 0.25, {1, 1, 1}, 1});
    return {white, {0.25, 0.25, 0.25, 1}, samples};
}

Printed thrice(const std::string& text)
{
    return {text, text, text};
}

TEST(ReferenceEstimators, ExampleOne)
{
    const EstimatedPixel pixel = example_1(4);
    const auto exact = [&](Estimator e) { return estimate(e, pixel, Masks::stratified); };
    expect_deviations(estimate(Estimator::basic, pixel, Masks::naive),
                      {"0.248747", "0.215780", "0.229670"});
    expect_deviations(exact(Estimator::basic), {"0.100000", "0.154765", "0.157962"});

    const auto a = exact(Estimator::alpha_corrected);
    expect_deviations(a, {"0.133716", "0.133716", "0.000000"});
    expect_rms(a, pixel, {"0.134784", "0.134784", "0.000000"});
    expect_means(a, {"0.466938", "0.230563", "0.302500"});

    expect_deviations(exact(Estimator::depth_based), {"0.000000", "0.045000", "0.000000"});
    expect_deviations(exact(Estimator::depth_based_empty), {"0.000000", "0.045000", "0.157962"});

    const auto d = exact(Estimator::depth_corrected);
    expect_deviations(d, {"0.026571", "0.026571", "0.000000"});
    expect_rms(d, pixel, {"0.026627", "0.026627", "0.000000"});
    expect_means(d, {"0.451714", "0.245786", "0.302500"});

    expect_rms(exact(Estimator::depth_over_coverage), pixel, {"0.1357", "0.1144", "0.0000"});
}

TEST(ReferenceEstimators, ExampleOneWithContiguousMasks)
{
    const EstimatedPixel pixel = example_1(4);
    const auto exact = [&](Estimator e) {
        return estimate_by_listing(e, pixel, contiguous_chance);
    };
    expect_deviations(exact(Estimator::basic), {"0.1000", "0.1750", "0.1778"});
    const auto a = exact(Estimator::alpha_corrected);
    expect_deviations(a, {"0.1464", "0.1464", "0.0000"});
    expect_rms(a, pixel, {"0.1482", "0.1482", "0.0000"});
    expect_printed(std::sqrt(exact(Estimator::depth_based_empty)[2].variance), "0.1778");
    expect_rms(exact(Estimator::depth_over_coverage), pixel, {"0.1449", "0.1167", "0.0000"});
}

TEST(ReferenceEstimators, ExampleTwo)
{
    const EstimatedPixel pixel = example_2(4);
    const auto exact = [&](Estimator e) { return estimate(e, pixel, Masks::stratified); };
    expect_deviations(estimate(Estimator::basic, pixel, Masks::naive), thrice("0.174403"));
    expect_deviations(estimate(Estimator::basic, example_2(1), Masks::naive), thrice("0.348805"));
    expect_deviations(exact(Estimator::basic), thrice("0.120616"));
    expect_deviations(exact(Estimator::alpha_corrected), thrice("0.000000"));
    expect_deviations(exact(Estimator::depth_based), thrice("0.056201"));
    expect_deviations(exact(Estimator::depth_based_empty), thrice("0.087122"));
    expect_deviations(exact(Estimator::depth_based_remainder), thrice("0.042151"));
    expect_deviations(exact(Estimator::depth_corrected), thrice("0.000000"));
    for (const Estimator e : {Estimator::basic, Estimator::alpha_corrected, Estimator::depth_based,
                              Estimator::depth_based_empty, Estimator::depth_corrected}) {
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(exact(e)[c].mean, 0.7626953125, kExact);
    }
}

// Two layers, each owning one sample of four before they meet.
TEST(ReferenceEstimators, BiasOfAlphaCorrection)
{
    const EstimatedPixel pixel = {{{1, 0.25, {1, 0, 0}, 1}, {2, 0.25, {0, 1, 0}, 2}}, {}, 4};
    const auto a = estimate(Estimator::alpha_corrected, pixel, Masks::stratified);
    EXPECT_NEAR(a[0].mean, 0.2734375, kExact);
    EXPECT_NEAR(a[1].mean, 0.1640625, kExact);
    EXPECT_NEAR(a[2].mean, 0, kExact);
    EXPECT_NEAR(a[3].mean, 0.4375, kExact);
    expect_rms(a, pixel, {"0.097578", "0.097578", "0.000000"});
    expect_rms(estimate(Estimator::basic, pixel, Masks::stratified), pixel,
               {"0.000000", "0.108253", "0.000000"});
}

TEST(ReferenceEstimators, AlphaCorrectionLosesEmptyPixels)
{
    for (const int samples : {1, 4, 64}) {
        const double opacity = 0.5 / samples;
        const EstimatedPixel pixel = {{{1, opacity, {1, 0.5, 0}, 1}}, {}, samples};
        const auto a = estimate(Estimator::alpha_corrected, pixel, Masks::stratified);
        EXPECT_NEAR(a[0].mean, opacity / 2, kExact);
        EXPECT_NEAR(a[1].mean, opacity / 4, kExact);
        EXPECT_NEAR(a[3].mean, opacity / 2, kExact);
    }
}

TEST(ReferenceEstimators, ExampleOneWithMoreSamples)
{
    struct Row {
        int samples;
        Printed basic;
        std::string a, u, d;  // of a and d red and green alike; of u green
    };
    const Row rows[] = {
        {4, {"0.100000", "0.154765", "0.157962"}, "0.134784", "0.045000", "0.026627"},
        {8, {"0.061237", "0.101958", "0.103781"}, "0.079541", "0.027557", "0.017537"},
        {16, {"0.025000", "0.066175", "0.066646"}, "0.046373", "0.011250", "0.007441"},
        {32, {"0.015309", "0.045724", "0.045980"}, "0.031287", "0.006889", "0.004463"},
        {64, {"0.006250", "0.031492", "0.031554"}, "0.020825", "0.002812", "0.001804"}};
    for (const auto& [samples, basic, a, u, d] : rows) {
        SCOPED_TRACE(samples);
        const EstimatedPixel pixel = example_1(samples);
        const auto exact = [&](Estimator e) { return estimate(e, pixel, Masks::stratified); };
        expect_rms(exact(Estimator::basic), pixel, basic);
        expect_rms(exact(Estimator::alpha_corrected), pixel, {a, a, "0.000000"});
        expect_rms(exact(Estimator::depth_based), pixel, {"0.000000", u, "0.000000"});
        expect_rms(exact(Estimator::depth_corrected), pixel, {d, d, "0.000000"});
    }
    const EstimatedPixel eight = example_1(8);
    expect_means(estimate(Estimator::alpha_corrected, eight, Masks::stratified),
                 {"0.457455", "0.240045", "0.302500"});
    expect_means(estimate(Estimator::depth_corrected, eight, Masks::stratified),
                 {"0.450692", "0.246808", "0.302500"});
}

void expect_near(const std::array<Moments, 4>& actual, const std::array<Moments, 4>& expected)
{
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(actual[c].mean, expected[c].mean, kExact) << c;
        EXPECT_NEAR(actual[c].variance, expected[c].variance, kExact) << c;
        EXPECT_NEAR(actual[c].fourth, expected[c].fourth, kExact) << c;
    }
}

// Opacities that differ, two that do not, colours that clamp, a backdrop with all channels.
const EstimatedPixel kFour = {{{4, 0.7, {0.2, 0.8, 0.5}, 4},
                               {1, 0.45, {0.9, 0.3, 0.1}, 1},
                               {3, 0.45, {2.0, 0.0, 0.6}, 3},
                               {2, 0.6, {1.0, 1.5, 0.6}, 2}},
                              {0.1, 0.2, 0.3, 0.5},
                              3};

TEST(ReferenceEstimators, AgreeWithAllMasksListed)
{
    EstimatedPixel two = kFour;
    two.fragments.resize(2);
    two.samples = 8;
    for (const EstimatedPixel& pixel : {kFour, two}) {
        for (const Estimator e : kAll) {
            SCOPED_TRACE(static_cast<int>(e));
            expect_near(estimate(e, pixel, Masks::naive),
                        estimate_by_listing(e, pixel, naive_chance));
            expect_near(estimate(e, pixel, Masks::stratified),
                        estimate_by_listing(e, pixel, stratified_chance));
        }
    }
}

TEST(ReferenceEstimators, BasicIsTheMeanOfTheSamples)
{
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        expect_near(estimate(Estimator::basic, kFour, masks),
                    stochastic(kFour.fragments, masks, kFour.samples, kFour.backdrop));
    }
}

// B and U have no bias, whatever stands for the background; the others are of the paper's kinds.
TEST(ReferenceEstimators, WhatHasNoBiasHasNone)
{
    const Rgba over = composite(kFour.fragments, kFour.backdrop);
    for (const Masks masks : {Masks::naive, Masks::stratified}) {
        for (const Estimator e : {Estimator::basic, Estimator::depth_based,
                                  Estimator::depth_based_empty, Estimator::depth_based_remainder}) {
            const auto moments = estimate(e, kFour, masks);
            EXPECT_NEAR(moments[0].mean, over.r, kExact);
            EXPECT_NEAR(moments[1].mean, over.g, kExact);
            EXPECT_NEAR(moments[2].mean, over.b, kExact);
            EXPECT_NEAR(moments[3].mean, over.a, kExact);
        }
        // "The displayed U is not consistent": too dark.
        EXPECT_LT(estimate(Estimator::depth_based_clamped, kFour, masks)[0].mean, over.r - 0.01);
    }
}

TEST(ReferenceEstimators, OneLayerIsExactWhereItIsCorrected)
{
    const EstimatedPixel pixel = {{{1, 0.3, {1, 0.5, 0.25}, 1}}, {0, 0, 1, 1}, 64};
    const Rgba over = composite(pixel.fragments, pixel.backdrop);
    for (const Estimator e :
         {Estimator::alpha_corrected, Estimator::depth_based, Estimator::depth_corrected}) {
        expect_near(estimate(e, pixel, Masks::stratified),
                    {{{over.r}, {over.g}, {over.b}, {over.a}}});
    }
}

// As large as the header promises: 64 layers of one opacity, and 4 of different ones.
TEST(ReferenceEstimators, ThinMediumOf64Samples)
{
    EstimatedPixel thin = {{}, {0, 0, 0, 1}, 64};
    for (std::uint32_t i = 0; i < 64; ++i) {
        const double z = i;
        thin.fragments.push_back({z, 1.0 / 64, {0, 0, 0}, i});
        thin.fragments.back().color[i % 3] = 1;
    }
    // D shares all of the total alpha out among the layers' colours.
    const auto d = estimate(Estimator::depth_corrected, thin, Masks::stratified);
    EXPECT_NEAR(d[0].mean + d[1].mean + d[2].mean, 1 - std::pow(63.0 / 64, 64), kExact);
}

TEST(ReferenceEstimators, FourOpacitiesOf64Samples)
{
    EstimatedPixel four = kFour;
    four.samples = 64;
    four.fragments[2].opacity = 0.2;
    for (Fragment& fragment : four.fragments) fragment.color[1] = 0.5;
    four.backdrop = {0, 0, 0, 0};
    const auto d = estimate(Estimator::depth_corrected, four, Masks::stratified);
    EXPECT_NEAR(d[1].mean, 0.5 * (1 - 0.3 * 0.55 * 0.8 * 0.4), kExact);
    EXPECT_NEAR(d[1].variance, 0, kExact);
    // All of an unbiased estimator's spread comes from how many samples are left to see a layer.
    const auto u = estimate(Estimator::depth_based, four, Masks::stratified);
    EXPECT_NEAR(u[1].mean, d[1].mean, kExact);
    EXPECT_GT(u[1].variance, 1e-6);
}

}  // namespace
}  // namespace sheer::reference
