// Transmittance from four moments: the text against what is known, what theory promises, and the
// same bounds in long doubles.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "methods/transmittance_lists.h"
#include "reference/moment_sets.h"
#include "reference/power_moments.h"

namespace sheer::test {
namespace {

using T = FloatText;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

MomentSettings settings_of(const std::string& parameters)
{
    return moment_settings(choose_method("moment" + parameters));
}

// With the bias that others give four moments of mboit, whose values are known.
MomentSettings known_settings()
{
    MomentSettings settings = settings_of("");
    settings.bias = 5e-7;
    return settings;
}

T::MomentCurve curve_of(const Fragments& fragments, const MomentSettings& settings)
{
    const MomentFunction function(settings);
    return function.curve(sums_of(function, fragments));
}

double transmittance(const T::MomentCurve& curve, double z, float overestimation)
{
    return static_cast<double>(
        T::moment_transmittance(curve, static_cast<float>(z), overestimation));
}

reference::MomentBias bias_of(const MomentSettings& s)
{
    return {s.bias, {0, s.even2, 0, s.even4}};
}

TEST(Exponential, IsAsNearAsItSays)
{
    for (int i = 0; i <= 20000; ++i) {
        const float x = -87.5f * static_cast<float>(i) / 20000;
        const double exact = std::exp(std::max(static_cast<double>(x), -87.0));
        // Of the argument's reduction as much as of the series.
        EXPECT_NEAR(static_cast<double>(T::exp_of(x)), exact, 4 * 0x1p-24 * exact) << x;
        const float a = 1 - std::ldexp(1 + static_cast<float>(i) / 20000, -1 - i % 24);
        const double depth = -std::log1p(-static_cast<double>(a));
        EXPECT_NEAR(static_cast<double>(T::optical_depth(a)), depth, 4 * 0x1p-24 * depth) << a;
        const float small = std::ldexp(a, -i % 100);
        const double small_depth = -std::log1p(-static_cast<double>(small));
        EXPECT_NEAR(static_cast<double>(T::optical_depth(small)), small_depth,
                    4 * 0x1p-24 * small_depth + 0x1p-149)
            << small;
        const float y = std::ldexp(1 + static_cast<float>(i) / 20000, i % 200 - 100);
        const double logarithm = std::log(static_cast<double>(y));
        EXPECT_NEAR(static_cast<double>(T::log_of(y)), logarithm,
                    0x1p-23 + 2 * 0x1p-24 * std::abs(logarithm))
            << y;
    }
    EXPECT_EQ(T::exp_of(0.0f), 1.0f);
    EXPECT_EQ(T::exp_of(-1e6f), T::exp_of(-87.0f));
    EXPECT_EQ(T::optical_depth(0.0f), 0.0f);
}

TEST(Moment, SumsAreThoseOfTheFormula)
{
    const Sums sums =
        sums_of(MomentFunction(settings_of("")), reference::at_depths({{.25, .5}, {.75, .5}}));
    const double expected[] = {1, .5, .3125, .21875, .16015625};
    EXPECT_NEAR(sums[0], 1.386294361, 1e-7);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(sums[k] / sums[0], expected[k], 1e-10);
}

// To half a unit of the last digit, and as many of a float's.
TEST(Moment, KnownTransmittances)
{
    const struct {
        const Fragments& fragments;
        double z, least_opaque, quarter;
    } rows[] = {{reference::kTwo, -.5, 1, .914691},
                {reference::kTwo, .4, .7, .556690},
                {reference::kTwo, .9, .28, .28},
                {reference::kThree, -.6, 1, .880112},
                {reference::kThree, -.4, .979821, .783704},
                {reference::kThree, 0, .600001, .504538},
                {reference::kThree, .1, .562977, .462907},
                {reference::kThree, .5, .3, .222025},
                {reference::kThree, .9, .098284, .096144},
                {reference::kFour, -.75, 1, .833262},
                {reference::kFour, -.4, .880042, .609157},
                {reference::kFour, -.25, .638891, .466224},
                {reference::kFour, .1, .388292, .294143},
                {reference::kFour, .25, .344969, .251738},
                {reference::kFour, .75, .129644, .108028},
                {reference::kFour, .9, .090224, .082312},
                {reference::kEight, .125, .554022, .453865}};
    for (const auto& row : rows) {
        const auto curve = curve_of(row.fragments, known_settings());
        EXPECT_NEAR(transmittance(curve, row.z, 0), row.least_opaque, 2e-6) << row.z;
        EXPECT_NEAR(transmittance(curve, row.z, 0.25f), row.quarter, 2e-6) << row.z;
    }
}

// The papers' promise for one fragment and two, as far as the bias and floats leave it: at their
// own depths a fragment's transmittance is flat, and where it falls in between its slope is d'
// over the width that the bias leaves, sqrt(b_1 b_2) / gap >= sqrt(.23 3e-7) / 2, that is 7600
// times what may be a float's half unit, a few times: 1e-3 at the steepest.
TEST(Moment, OneAndTwoFragmentsAreExact)
{
    const MomentSettings settings = settings_of(":overestimation=0");
    const auto [at, between] = errors_of_few_layers(
        MomentFunction(settings), 20000, 0.1f, [&](const Fragments& f, double z) {
            return reference::power_transmittance(reference::power_moments(f, 4, kUnlimited), z,
                                                  bias_of(settings), 0);
        });
    EXPECT_LE(quantile(at, 0.99), 1e-4);
    EXPECT_LE(quantile(at, 1), 1e-3);
    EXPECT_LE(quantile(between, 0.999), 1e-4);
    EXPECT_LE(quantile(between, 1), 1e-3);
    RecordProperty("at_most", std::to_string(quantile(at, 1)));
    RecordProperty("between_most", std::to_string(quantile(between, 1)));
}

// The second moments are of what the first let be seen, and the product of both counts. Six layers;
// where a function is steep a float's half unit of z is much, one in fifty may be off by more.
TEST(Moment, TwoPassesAreThoseOfLongDoubles)
{
    const MomentSettings settings = settings_of(":moment-passes=2");
    const MomentFunction function(settings);
    const auto exact = [&](const Fragments& f) {
        return [&settings, sums = reference::power_moments(f, 4, kUnlimited)](double z) {
            return reference::power_transmittance(sums, z, bias_of(settings), 0.25);
        };
    };
    RandomLayers make{std::mt19937(4)};
    std::vector<double> errors;
    for (int round = 0; round < 200; ++round) {
        Fragments f;
        for (int i = 0; i < 6; ++i) f.push_back(make.at(make.place(), make.uniform(make.random)));
        const State first = function.prepare(sums_of(function, f));
        Fragments seen = f, seen_exactly = f;
        for (std::size_t i = 0; i < f.size(); ++i) {
            const auto place = static_cast<float>(f[i].depth);
            seen[i].opacity = static_cast<double>(static_cast<float>(f[i].opacity) *
                                                  function.transmittance(first, place));
            seen_exactly[i].opacity *= exact(f)(f[i].depth);
        }
        const State state = function.prepare_again(first, sums_of(function, seen));
        const auto place = static_cast<float>(f[static_cast<std::size_t>(round % 6)].depth);
        const auto z = static_cast<double>(place);
        errors.push_back(std::abs(static_cast<double>(function.transmittance(state, place)) -
                                  exact(f)(z) * exact(seen_exactly)(z)));
    }
    EXPECT_LE(quantile(errors, 0.98), 1e-4);
    EXPECT_LE(quantile(errors, 1), 1e-3);
}

TEST(Moment, AnyListIsANumberFallsAndHasTheTruthBetweenItsBounds)
{
    const MomentFunction bright(settings_of(":overestimation=0"));
    const MomentFunction dark(settings_of(":overestimation=1"));
    expect_bounds_of_hard_lists(bright, dark, settings_of("").bias, 400);
}

TEST(Moment, EveryFormatGivesNumbers)
{
    for (const std::string format : {"fp16", "unorm16", "nlqm"}) {
        for (const std::string overestimation : {"0", "0.25", "adaptive"}) {
            SCOPED_TRACE(format + " " + overestimation);
            expect_numbers_of_hard_lists(MomentFunction(
                settings_of(":format=" + format + ":overestimation=" + overestimation)));
        }
    }
}

}  // namespace
}  // namespace sheer::test
