// The estimators of stochastic transparency, as pictures of full-screen layers, against their exact
// moments (src/reference/stochastic_estimators.h), to a stated confidence (statistics.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <sheer/error.h>
#include <sheer/sheer.h>

#include "methods/statistics.h"
#include "methods/stochastic_fixture.h"
#include "reference/stochastic_estimators.h"

namespace sheer {

namespace {

using reference::Estimator;
using reference::Masks;
using reference::Moments;
using Expected = std::array<Moments, 4>;

struct Variant {
    Estimator estimator;
    const char* parameters;
};

constexpr Variant kVariants[] = {
    {Estimator::basic, ""},
    {Estimator::alpha_corrected, ":correction=on"},
    {Estimator::depth_based, ":depth-based=on"},
    {Estimator::depth_corrected, ":depth-based=on:correction=on"},
};

StochasticLayers four_layers()
{
    return {{0.3, {1, 0.25, 0}, 1},
            {0.5, {0, 0.75, 0.5}, 2},
            {0.25, {0.5, 0, 0.25}, 3},
            {0.5, {0.25, 1, 0}, 4}};
}

Expected moments(const Variant& variant, const StochasticLayers& layers, Masks masks, int samples)
{
    const reference::Rgba behind = {static_cast<double>(kBehind[0]),
                                    static_cast<double>(kBehind[1]),
                                    static_cast<double>(kBehind[2]), 1};
    return reference::estimate(variant.estimator, {fragments_of(layers), behind, samples}, masks);
}

Image picture(const StochasticLayers& layers, int samples, const std::string& method,
              int accumulate = 1, int size = 160, ShadowKind shadows = ShadowKind::none)
{
    Options options;
    options.method = method;
    options.seed = 11;
    options.accumulate = accumulate;
    View view = centered_view(size, samples);
    view.shadows.kind = shadows;
    view.shadows.size = 16;
    view.shadows.samples = 1;
    return render(scene_of(layers), view, options).image;
}

void expect_moments(const Image& image, const Expected& expected)
{
    for (std::size_t c = 0; c < 3; ++c) {
        const Observed observed = observe(channel_of(image, c));
        EXPECT_TRUE(mean_agrees(observed, expected[c])) << "channel " << c;
        EXPECT_TRUE(variance_agrees(observed, expected[c])) << "channel " << c;
    }
    // Over what is opaque nothing is transparent, whatever a method estimates of colours.
    for (const double alpha : channel_of(image, 3)) EXPECT_NEAR(alpha, 1, kPixelRounding);
}

template <class Check>
void for_each_variant(Check&& check)
{
    for (const Variant& variant : kVariants) {
        for (const Masks masks : {Masks::naive, Masks::stratified}) {
            const std::string method = method_with(masks) + variant.parameters;
            SCOPED_TRACE(method);
            check(variant, masks, method);
        }
    }
}

}  // namespace

class StochasticEstimators : public testing::TestWithParam<int> {};

TEST_P(StochasticEstimators, RedOverGreenOverBlue)
{
    for_each_variant([](const Variant& variant, Masks masks, const std::string& method) {
        expect_moments(picture(red_over_green(), GetParam(), method),
                       moments(variant, red_over_green(), masks, GetParam()));
    });
}

TEST_P(StochasticEstimators, FourLayers)
{
    for_each_variant([](const Variant& variant, Masks masks, const std::string& method) {
        expect_moments(picture(four_layers(), GetParam(), method),
                       moments(variant, four_layers(), masks, GetParam()));
    });
}

// Half of the pixels are empty, and alpha correction has nothing there to scale.
TEST_P(StochasticEstimators, OneFaintLayer)
{
    const StochasticLayers faint = {{0.5 / GetParam(), {1, 0.5, 0}, 1}};
    for_each_variant([&](const Variant& variant, Masks masks, const std::string& method) {
        expect_moments(picture(faint, GetParam(), method),
                       moments(variant, faint, masks, GetParam()));
    });
}

// Opaque layers are part of the method too.
TEST_P(StochasticEstimators, NothingShowsThroughAnOpaqueLayer)
{
    const StochasticLayers layers = {
        {0.5, {1, 0, 0}, 1}, {1, {0, 0.5, 0}, 2}, {0.25, {0, 1, 1}, 3}};
    for_each_variant([&](const Variant& variant, Masks masks, const std::string& method) {
        expect_moments(picture(layers, GetParam(), method),
                       moments(variant, layers, masks, GetParam()));
    });
}

// One mask of all their samples: as so many samples in one pass.
TEST_P(StochasticEstimators, PassesStratifiedTogetherAreOnePassOfAllTheirSamples)
{
    const int samples = GetParam();
    for_each_variant([&](const Variant& variant, Masks masks, const std::string& method) {
        for (const int passes : {2, 4}) {
            const std::string all = method + ":sample-passes=" + std::to_string(passes);
            expect_moments(picture(red_over_green(), samples, all),
                           moments(variant, red_over_green(), masks, samples * passes));
        }
    });
}

INSTANTIATE_TEST_SUITE_P(SampleCounts, StochasticEstimators, testing::Values(4, 8, 16));

// Where nothing is divided, the mean of as many pictures.
TEST(StochasticPasses, IndependentOnesAreAsManyPictures)
{
    for (const Variant& variant : {kVariants[0], kVariants[2]}) {
        for (const int passes : {2, 5}) {
            Expected expected = moments(variant, red_over_green(), Masks::stratified, 8);
            for (Moments& of_channel : expected) of_channel = moments_of_mean(of_channel, passes);
            const std::string method = std::string("stochastic:pass-masks=independent") +
                                       variant.parameters +
                                       ":sample-passes=" + std::to_string(passes);
            SCOPED_TRACE(method);
            expect_moments(picture(red_over_green(), 8, method), expected);
        }
    }
}

// U and U1 are accumulated apart: the bias of the quotient falls with the number of frames, to
// first order as its inverse; a mean of quotients would keep it. With random shadows frames are
// drawn one by one, which the layers, being unlit, must not show.
class StochasticAccumulation : public testing::TestWithParam<ShadowKind> {};

TEST_P(StochasticAccumulation, TheQuotientIsTakenOnce)
{
    constexpr int kFrames = 64;
    const Variant corrected = kVariants[3];
    const Expected one = moments(corrected, red_over_green(), Masks::stratified, 4);
    const Image image =
        picture(red_over_green(), 4, std::string("stochastic") + corrected.parameters, kFrames, 160,
                GetParam());
    const double truth[] = {0.45, 0.45 * 0.55};
    for (std::size_t c = 0; c < 2; ++c) {
        const double bias = std::abs(one[c].mean - truth[c]);
        const Observed observed = observe(channel_of(image, c));
        const double deviation = std::sqrt(one[c].variance / kFrames / observed.count);
        // Twice the first order.
        const double bound = kZ * deviation + 2 * bias / kFrames;
        EXPECT_LE(std::abs(observed.mean - truth[c]), bound);
        EXPECT_GT(bias, 2 * bound) << "a mean of quotients would go unnoticed";
    }
}

INSTANTIATE_TEST_SUITE_P(Shadows, StochasticAccumulation,
                         testing::Values(ShadowKind::none, ShadowKind::stochastic));

// Of two masks of a half of 8 samples, those covered are within one of 6.
TEST(StochasticMasksOfAHalf, UnionIsWithinOneOfSix)
{
    const StochasticLayers halves = {{0.5, {1, 0, 0}, 1}, {0.5, {1, 0, 0}, 2}};
    const std::vector<double> red = channel_of(picture(halves, 8, "stochastic", 1, 500), 0);
    const auto within = static_cast<double>(std::count_if(
        red.begin(), red.end(), [](double part) { return std::abs(8 * part - 6) < 1.5; }));
    // 1 - 2 / C(8, 4).
    EXPECT_TRUE(count_agrees(within, static_cast<double>(red.size()), 1 - 2.0 / 70));
}

// R of the samples that are left, if what is in front comes first: u of S samples are left to the
// second layer, which takes floor(u / 4) of them, or one more.
TEST(StochasticDepthTest, BeforeTheDrawTheCountIsThatOfTheSamplesLeft)
{
    const StochasticLayers layers = {{0.5, {1, 0, 0}, 1}, {0.45, {0, 1, 0}, 2}};
    DrivenTile tile("stochastic:depth-test=before", 8);
    const Image image = tile.draw_picture(layers, 256, {}, [](int x, int y) {
        return TilePlace{x, y, 5};
    });
    const std::vector<double> green = channel_of(image, 1);
    const double left = 4 * static_cast<double>(0.45f);  // of 4: 1 or 2
    double ones = 0;
    for (const double part : green) {
        EXPECT_TRUE(part == 1.0 / 8 || part == 2.0 / 8);
        ones += part == 1.0 / 8;
    }
    EXPECT_TRUE(count_agrees(ones, static_cast<double>(green.size()), 2 - left));
}

// Over 8x8 pixels each 64th of a circle of length 1 is drawn once. Two of these parts may lie
// across an end of those numbers that round up: the samples in the square are as many as the
// opacity says, up to two.
TEST(StochasticDither, SquaresOfPixelsShareTheRoundingOut)
{
    constexpr double kAlpha = 0.3;
    const Image image =
        picture({{kAlpha, {1, 0, 0}, 1}}, 8, "stochastic:round=tile-dither:seed-by=object", 1, 160);
    const Image random = picture({{kAlpha, {1, 0, 0}, 1}}, 8, "stochastic", 1, 160);
    const auto worst = [&](const Image& drawn) {
        double most = 0;
        for (int y = 0; y < 160; y += 8) {
            for (int x = 0; x < 160; x += 8) {
                double count = 0;
                for (int i = 0; i < 64; ++i) {
                    count += 8 * static_cast<double>(drawn.at(x + i % 8, y + i / 8)[0]);
                }
                most = std::max(most, std::abs(count - 64 * 8 * kAlpha));
            }
        }
        return most;
    };
    EXPECT_LT(worst(image), 2);
    EXPECT_GT(worst(random), 2);
    // Which pixels round up depends on the seed alone: on average it is fair.
    EXPECT_TRUE(mean_agrees(
        observe(channel_of(
            picture({{kAlpha, {1, 0, 0}, 1}}, 8, "stochastic:round=tile-dither", 400, 64), 0)),
        moments_of_mean(moments(kVariants[0], {{kAlpha, {1, 0, 0}, 1}}, Masks::stratified, 8)[0],
                        400)));
}

// A table is a little less random: a row's masks hold each sample about alpha of the time, off by
// sqrt(alpha (1 - alpha) / 2047), and two fragments of one row share that: alpha (1 - alpha) / 2047
// of the samples too many. Opacities in steps of 1/1000.
TEST(StochasticTable, MasksOfATableAreAlmostFair)
{
    for (const int samples : {8, 64}) {
        const Expected expected =
            moments(kVariants[0], red_over_green(), Masks::stratified, samples);
        const Image image = picture(red_over_green(), samples, "stochastic:masks=table", 1, 256);
        for (std::size_t c = 0; c < 3; ++c) {
            const Observed observed = observe(channel_of(image, c));
            const double bound = kZ * std::sqrt(expected[c].variance / observed.count) +
                                 2 * 0.45 * 0.55 / 2047 + 1e-4;
            EXPECT_LE(std::abs(observed.mean - expected[c].mean), bound) << c;
        }
    }
    // Nothing and everything are exact; in between the nearest 1/1000 counts.
    const Image opaque = picture({{1, {1, 0, 0}, 1}}, 8, "stochastic:masks=table");
    for (const double part : channel_of(opaque, 0)) EXPECT_EQ(part, 1);
    const Image faint = picture({{0.0004, {1, 0, 0}, 1}}, 8, "stochastic:masks=table");
    for (const double part : channel_of(faint, 0)) EXPECT_EQ(part, 0);
}

TEST(StochasticMethod, SaysWhatDoesNotGoTogether)
{
    const auto said = [](const std::string& parameters, int samples) -> std::string {
        try {
            picture(red_over_green(), samples, "stochastic:" + parameters, 1, 8);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(said("sample-passes=16", 8).find("up to 64"), std::string::npos);
    EXPECT_EQ(said("sample-passes=16:pass-masks=independent", 8), "");
    EXPECT_NE(said("depth-test=before:masks=table", 8).find("masks=table"), std::string::npos);
    EXPECT_NE(said("depth-test=before:sample-passes=2", 8).find("independent"), std::string::npos);
    EXPECT_NE(said("depth-test=before:depth-based=on", 8).find("depth-based"), std::string::npos);
}

}  // namespace sheer
