// Transmittance from Fourier series and from wavelets: the texts against the same series in
// doubles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "methods/transmittance_lists.h"
#include "reference/fourier.h"
#include "reference/wavelet.h"

namespace sheer::test {
namespace {

const std::string kSeries[] = {"fourier",
                               "fourier:terms=3",
                               "fourier:terms=3:window=lanczos",
                               "fourier:window=lanczos",
                               "wavelet:rank=2",
                               "wavelet:rank=3",
                               "wavelet:rank=4"};

// By the reference, whose places are from 0 to 1.
reference::Transmittance exact_transmittance(const ChosenMethod& method, Fragments f)
{
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    for (Fragment& one : f) one.depth = 0.5 * one.depth + 0.5;
    if (std::string(method.row->id) == "wavelet") {
        const auto cells = reference::wavelet_cells(
            reference::wavelet_coefficients(f, method.number("rank"), kUnlimited));
        return [=](double z) {
            return std::min(1.0, reference::wavelet_transmittance(cells, 0.5 * z + 0.5, true));
        };
    }
    const auto sums = reference::fourier_sums(f, method.number("terms"), kUnlimited);
    const bool damped = method.value("window") == "lanczos";
    return [=](double z) {
        return std::min(1.0, reference::fourier_transmittance(sums, 0.5 * z + 0.5, damped));
    };
}

// Optical depth is a sum of up to 31 terms, each of which is the list's sum, d' at most, times a
// sine to a few units of the last place; so it is off by 100 u d' at most, u = 2^-24, and
// transmittance by as much of itself or, where the series falls below 0, of 1. d' is 30 times
// -ln(1 - 0.7) = 36 at most.
TEST(Series, AreThoseOfDoubles)
{
    RandomLayers make{std::mt19937(5)};
    for (const std::string& name : kSeries) {
        const ChosenMethod method = choose_method(name);
        const auto function = transmittance_function(method);
        for (int round = 0; round < 100; ++round) {
            Fragments f;
            for (int i = 0; i <= round % 30; ++i) {
                f.push_back(make.at(make.place(), 0.7f * make.uniform(make.random)));
            }
            const State state = function->prepare(sums_of(*function, f));
            const auto exact = exact_transmittance(method, f);
            double depth = 0;
            for (const Fragment& one : f) depth += reference::absorbance(one.opacity);
            for (const float place : places_to_ask(f, make)) {
                const auto through = static_cast<double>(function->transmittance(state, place));
                EXPECT_NEAR(through, exact(static_cast<double>(place)), 100 * 0x1p-24 * (1 + depth))
                    << name << ", " << f.size() << " layers, at " << place;
            }
        }
    }
}

// At the far end both are exact: a wavelet's last cell lies behind all fragments.
TEST(Series, BehindAllFragmentsTheyAreExact)
{
    RandomLayers make{std::mt19937(6)};
    for (const std::string& name : kSeries) {
        const auto function = transmittance_function(choose_method(name));
        Fragments f;
        double through = 1;
        for (int i = 0; i < 8; ++i) {
            f.push_back(make.at(make.place(), 0.4f * make.uniform(make.random)));
            through *= 1 - f.back().opacity;
        }
        const State state = function->prepare(sums_of(*function, f));
        EXPECT_NEAR(static_cast<double>(function->transmittance(state, 1)), through, 1e-5) << name;
    }
}

TEST(Series, AnyListGivesNumbers)
{
    for (const std::string& name : kSeries) {
        SCOPED_TRACE(name);
        expect_numbers_of_hard_lists(*transmittance_function(choose_method(name)));
    }
}

}  // namespace
}  // namespace sheer::test
