// Transmittance from six and eight power moments and from trigonometric ones: the texts against
// what is known, what theory promises, and the same bounds in long doubles, found by other
// formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "methods/transmittance_lists.h"
#include "reference/moment_sets.h"
#include "reference/trigonometric_moments.h"

namespace sheer::test {
namespace {

ChosenMethod mboit(const std::string& parameters)
{
    return choose_method("mboit" + parameters);
}

std::string of(bool trigonometric, int moments)
{
    return std::string(trigonometric ? ":basis=trigonometric" : "") +
           ":moments=" + std::to_string(moments);
}

double transmittance(const ChosenMethod& method, const Fragments& fragments, double z)
{
    const auto function = transmittance_function(method);
    const State state = function->prepare(sums_of(*function, fragments));
    return static_cast<double>(function->transmittance(state, static_cast<float>(z)));
}

// By the reference; of single precision.
reference::Transmittance exact_transmittance(const ChosenMethod& method, const Fragments& fragments)
{
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    const int moments = method.number("moments");
    const double beta = method.real("overestimation");
    if (method.value("basis") == "trigonometric") {
        const auto sums = reference::trigonometric_moments(fragments, moments / 2, kUnlimited,
                                                           reference::kWrappingZone);
        const double epsilon =
            reference::trigonometric_bias(moments / 2, reference::MomentFormat::fp32);
        return [=](double z) {
            return reference::trigonometric_transmittance(sums, z, epsilon, beta,
                                                          reference::kWrappingZone);
        };
    }
    const auto bias = reference::power_bias(moments, reference::MomentFormat::fp32);
    const auto sums = reference::power_moments(fragments, moments, kUnlimited);
    return [=](double z) { return reference::power_transmittance(sums, z, bias, beta); };
}

// To half a unit of the last digit, and as many of a float's.
TEST(Mboit, KnownTransmittances)
{
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const struct {
        const Fragments& fragments;
        bool trigonometric;
        int moments;
        double z, least_opaque, quarter;
    } rows[] = {{reference::kTwo, false, 4, .4, .7, .556690},
                {reference::kThree, false, 4, .1, .562977, .462907},
                {reference::kThree, false, 6, -.4, .600192, kNone},
                {reference::kThree, false, 6, .1, .300977, kNone},
                {reference::kFour, false, 6, -.25, .500004, .420449},
                {reference::kFour, false, 6, .1, .356604, .279739},
                {reference::kEight, false, 4, .125, .554022, .453865},
                {reference::kEight, false, 6, .125, .527433, .441544},
                {reference::kEight, false, 8, .125, .472935, .417250},
                {reference::kFour, true, 4, -.25, .440453, .345517},
                {reference::kFour, true, 6, .25, .250000, .210224},
                {reference::kEight, true, 4, .125, .543505, .465848},
                {reference::kEight, true, 6, .125, .425058, .378278},
                {reference::kEight, true, 8, .125, .473129, .430897}};
    for (const auto& row : rows) {
        const std::string parameters = of(row.trigonometric, row.moments);
        SCOPED_TRACE(parameters + " at " + std::to_string(row.z));
        EXPECT_NEAR(transmittance(mboit(parameters + ":overestimation=0"), row.fragments, row.z),
                    row.least_opaque, 2e-6);
        if (std::isnan(row.quarter)) continue;
        EXPECT_NEAR(transmittance(mboit(parameters), row.fragments, row.z), row.quarter, 2e-6);
    }
}

// As many layers as there are pairs of moments, and 20; at a layer and anywhere. Where a function
// is steep a float's half unit of z is much: one in fifty may be off by more than 1e-4.
TEST(Mboit, AreThoseOfLongDoubles)
{
    for (const bool trigonometric : {false, true}) {
        for (const int moments : {4, 6, 8}) {
            const std::string parameters = of(trigonometric, moments);
            std::vector<double> errors;
            RandomLayers make{std::mt19937(7)};
            for (const std::string overestimation : {"0", "0.25", "1"}) {
                const ChosenMethod method = mboit(parameters + ":overestimation=" + overestimation);
                for (int round = 0; round < 60; ++round) {
                    Fragments f;
                    for (int i = 0; i < 20; ++i) {
                        f.push_back(make.at(make.place(), 0.5f * make.uniform(make.random)));
                    }
                    if (round % 2 == 0) f.resize(static_cast<std::size_t>(moments / 2));
                    const auto exact = exact_transmittance(method, f);
                    for (const float z : {static_cast<float>(f[0].depth), make.place()}) {
                        const auto at = static_cast<double>(z);
                        errors.push_back(std::abs(transmittance(method, f, at) - exact(at)));
                    }
                }
            }
            EXPECT_LE(quantile(errors, 0.98), 1e-4) << parameters;
            EXPECT_LE(quantile(errors, 1), 1e-3) << parameters;
        }
    }
}

// But for the bias, a part of the mass that may lie anywhere: times the optical depth of two random
// opacities, which is above 6.64 once in a hundred times ((1 + d) e^-d = 0.01).
TEST(Mboit, OneAndTwoFragmentsAreExact)
{
    for (const bool trigonometric : {false, true}) {
        for (const int moments : {4, 6, 8}) {
            const std::string parameters = of(trigonometric, moments) + ":overestimation=0";
            const ChosenMethod method = mboit(parameters);
            const auto errors = errors_of_few_layers(
                *transmittance_function(method), 600, 0.1f,
                [&](const Fragments& f, double z) { return exact_transmittance(method, f)(z); });
            const double of_bias = 6.64 * mboit_settings(method).bias;
            EXPECT_LE(quantile(errors.at, 0.99), std::max(1e-4, of_bias)) << parameters;
            EXPECT_LE(quantile(errors.at, 1), 1e-3) << parameters;
            EXPECT_LE(quantile(errors.between, 0.99), 1e-4) << parameters;
        }
    }
}

TEST(Mboit, AnyListIsANumberFallsAndHasTheTruthBetweenItsBounds)
{
    for (const int moments : {4, 6, 8}) {
        SCOPED_TRACE(moments);
        const std::string parameters = of(false, moments);
        const ChosenMethod bright = mboit(parameters + ":overestimation=0"),
                           dark = mboit(parameters + ":overestimation=1");
        expect_bounds_of_hard_lists(*transmittance_function(bright), *transmittance_function(dark),
                                    mboit_settings(bright).bias, 60);
    }
}

TEST(Mboit, EveryBasisAndFormatGivesNumbers)
{
    for (const bool trigonometric : {false, true}) {
        for (const int moments : {4, 6, 8}) {
            for (const std::string format : {"fp32", "unorm16"}) {
                const std::string parameters = of(trigonometric, moments) + ":format=" + format;
                SCOPED_TRACE(parameters);
                expect_numbers_of_hard_lists(*transmittance_function(mboit(parameters)));
            }
        }
    }
}

}  // namespace
}  // namespace sheer::test
