// Lists of fragments at places from -1 to 1 for the functions of transmittance_functions.h, and
// what every such function promises of any list.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "methods/transmittance_oracle.h"

namespace sheer::test {

inline Sums sums_of(const TransmittanceFunction& function, const Fragments& fragments)
{
    Sums sums(function.sums());
    for (const Fragment& f : fragments) {
        function.add(sums, static_cast<float>(f.depth),
                     FloatText::optical_depth(static_cast<float>(f.opacity)));
    }
    return sums;
}

// Places and opacities that floats have.
struct RandomLayers {
    std::mt19937 random;
    std::uniform_real_distribution<float> uniform{0, 1};

    float place() { return 2 * uniform(random) - 1; }
    Fragment at(float z, float opacity)
    {
        return {static_cast<double>(z), static_cast<double>(opacity), {}, 0};
    }
};

inline double quantile(std::vector<double> values, double part)
{
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

// Long lists, opacities to the last float below 1, equal places, all in one place or far apart.
inline Fragments hard_list(RandomLayers& make, int round)
{
    const int count = 1 + static_cast<int>(make.random() % (round % 10 == 0 ? 1000 : 30));
    const float extent = std::ldexp(1.0f, -static_cast<int>(make.random() % 20));
    const float start = make.place() * (1 - extent);
    Fragments f;
    for (int i = 0; i < count; ++i) {
        const float z = make.random() % 4 == 0 && i > 0 ? static_cast<float>(f.back().depth)
                                                        : start + extent * make.place();
        const float opacity = make.random() % 16 == 0 ? 1 - 0x1p-24f
                              : make.random() % 8 == 0
                                  ? std::ldexp(1.0f, -static_cast<int>(make.random() % 60))
                                  : make.uniform(make.random) * (round % 3 == 0 ? 0.05f : 1.0f);
        f.push_back(make.at(std::clamp(z, -1.0f, 1.0f), std::min(opacity, 1 - 0x1p-24f)));
    }
    return f;
}

// Anywhere, and where fragments are; from near to far.
inline std::vector<float> places_to_ask(const Fragments& f, RandomLayers& make)
{
    std::vector<float> places;
    for (int i = 0; i < 40; ++i) places.push_back(make.place());
    for (std::size_t i = 0; i < std::min<std::size_t>(f.size(), 40); ++i) {
        places.push_back(static_cast<float>(f[i].depth));
    }
    std::sort(places.begin(), places.end());
    return places;
}

inline void expect_numbers_of_hard_lists(const TransmittanceFunction& function)
{
    RandomLayers make{std::mt19937(3)};
    for (int round = 0; round < 60; ++round) {
        const Fragments f = hard_list(make, round);
        const State state = function.prepare(sums_of(function, f));
        for (const float place : places_to_ask(f, make)) {
            const float through = function.transmittance(state, place);
            ASSERT_TRUE(through >= 0 && through <= 1) << round << " at " << place;
        }
    }
}

// `bright` is a method's function without overestimation, `dark` with all of it: what is true lies
// between, and light falls with depth, to 1e-3. Bounds are those of a measure of which `bias` is a
// part that may lie anywhere.
inline void expect_bounds_of_hard_lists(const TransmittanceFunction& bright,
                                        const TransmittanceFunction& dark, double bias, int rounds)
{
    RandomLayers make{std::mt19937(2)};
    for (int round = 0; round < rounds; ++round) {
        const Fragments f = hard_list(make, round);
        const State state = bright.prepare(sums_of(bright, f));
        double last = 1;
        for (const float place : places_to_ask(f, make)) {
            const auto z = static_cast<double>(place);
            const auto least = static_cast<double>(dark.transmittance(state, place));
            const auto most = static_cast<double>(bright.transmittance(state, place));
            ASSERT_TRUE(least >= 0 && least <= most && most <= 1) << round << " at " << place;
            EXPECT_LE(most, last + 1e-3) << round << " at " << place;
            last = most;
            double before = 0, own = 0, all = 0;
            for (const Fragment& one : f) {
                const double depth = reference::absorbance(one.opacity);
                before += one.depth < z ? depth : 0;
                own += one.depth == z ? depth : 0;
                all += depth;
            }
            EXPECT_LE(std::exp(-before - own - bias * all), most + 1e-3)
                << round << " at " << place;
            EXPECT_GE(std::exp(bias * all - before), least - 1e-3) << round << " at " << place;
        }
    }
}

// One fragment or two, at least `gap` apart: the largest errors at their own depths, against what
// is true, and between them, against `exact`.
struct FewLayersErrors {
    std::vector<double> at, between;
};
template <class Exact>
FewLayersErrors errors_of_few_layers(const TransmittanceFunction& function, int rounds,
                                     float least_gap, Exact&& exact)
{
    RandomLayers make{std::mt19937(1)};
    FewLayersErrors errors;
    for (int round = 0; round < rounds; ++round) {
        const float gap =
            least_gap + (2 - least_gap) * make.uniform(make.random) * make.uniform(make.random);
        const float z1 = -1 + (2 - gap) * make.uniform(make.random), z2 = std::min(z1 + gap, 1.0f);
        Fragments f = {make.at(z1, make.uniform(make.random)),
                       make.at(z2, make.uniform(make.random))};
        if (round % 4 == 0) f.pop_back();
        const State state = function.prepare(sums_of(function, f));
        const auto error = [&](double z, double expected) {
            const float through = function.transmittance(state, static_cast<float>(z));
            return std::abs(static_cast<double>(through) - expected);
        };
        errors.at.push_back(error(f[0].depth, 1));
        if (f.size() == 1) continue;
        errors.at.push_back(error(f[1].depth, 1 - f[0].opacity));
        const float z = z1 + (z2 - z1) * make.uniform(make.random);
        errors.between.push_back(error(static_cast<double>(z), exact(f, static_cast<double>(z))));
    }
    return errors;
}

}  // namespace sheer::test
