// Averages of frames whose thresholds go round: closed forms, and a simulation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/exponential_average.h"
#include "reference/printed.h"

namespace sheer::reference {
namespace {

TEST(ReferenceExponentialAverage, OfFramesThatPassInARow)
{
    // In the end the average is a geometric series: greatest after the last that passes.
    for (const double weight : {.05, .1, .5}) {
        for (int n : {2, 8, 16}) {
            for (int passing = 0; passing <= n; ++passing) {
                std::vector<bool> passes(static_cast<std::size_t>(n));
                std::fill_n(passes.begin() + n / 2 - passing / 2, passing, true);
                const double keeps = 1 - weight;
                const double high = (1 - std::pow(keeps, passing)) / (1 - std::pow(keeps, n));
                const double low = high * std::pow(keeps, n - passing);
                EXPECT_NEAR(peak_to_peak(passes, weight), high - low, 1e-12);
            }
        }
    }
    EXPECT_NEAR(peak_to_peak({true}, .1), 0, 1e-12);
}

TEST(ReferenceExponentialAverage, IsWhatTheAverageEndsIn)
{
    const std::vector<bool> passes = {true, false, false, true, true, false, true, false};
    double average = .5, least = 1, most = 0;
    for (int frame = 0; frame < 800; ++frame) {
        average += .1 * ((passes[static_cast<std::size_t>(frame % 8)] ? 1 : 0) - average);
        if (frame < 792) continue;
        least = std::min(least, average);
        most = std::max(most, average);
    }
    EXPECT_NEAR(peak_to_peak(passes, .1), most - least, 1e-12);  // .9^800 is below
}

// 8 strata, weight .1. Whatever passes when opacity is a does not when it is 1 - a and thresholds
// are turned round, so that both flicker alike.
TEST(ReferenceExponentialAverage, OrdersOfStrataFlicker)
{
    const auto of = [](double opacity, StrataOrder order) {
        return flicker(opacity, 8, .1, order);
    };
    for (const StrataOrder order :
         {StrataOrder::linear, StrataOrder::alternating, StrataOrder::van_der_corput}) {
        for (const double opacity : {.125, .25, .375}) {
            EXPECT_NEAR(of(opacity, order), of(1 - opacity, order), 1e-12) << opacity;
        }
    }
    // Strata in a row pass in a row.
    for (const int passing : {1, 2, 4, 6}) {
        const double high = (1 - std::pow(.9, passing)) / (1 - std::pow(.9, 8));
        EXPECT_NEAR(of(passing / 8., StrataOrder::linear), high * (1 - std::pow(.9, 8 - passing)),
                    1e-12);
    }
    expect_printed(of(.25, StrataOrder::linear), ".1563");
    expect_printed(of(.5, StrataOrder::linear), ".2077");
    // Measured elsewhere on random thresholds: those for one quarter and for three, which are the
    // same in truth, were up to 15 % apart.
    const double known[][3] = {{.25, .128, .108}, {.5, .100, .099}, {.75, .123, .102}};
    for (const auto& [opacity, alternating, reversed] : known) {
        EXPECT_NEAR(of(opacity, StrataOrder::alternating), alternating, .15 * alternating);
        EXPECT_NEAR(of(opacity, StrataOrder::van_der_corput), reversed, .15 * reversed);
        EXPECT_LT(of(opacity, StrataOrder::van_der_corput), of(opacity, StrataOrder::alternating));
        EXPECT_LT(of(opacity, StrataOrder::alternating), of(opacity, StrataOrder::linear));
    }
}

}  // namespace
}  // namespace sheer::reference
