// The parameters of moment-based order-independent transparency.
#pragma once

#include <array>
#include <string>

#include "methods/method.h"

namespace sheer {

struct MboitSettings {
    bool trigonometric;
    int half;      // of the numbers that moments are: 2, 3 or 4
    bool rounded;  // to 16 bits
    float overestimation;

    double bias;
    std::array<double, 5> even;  // of power moments: 0, 2, ... of what is mixed in
};

// Muenstermann, Krumpen, Klein and Peters. Moment-Based Order-Independent Transparency. I3D 2018,
// table 1 and supplement.
inline MboitSettings mboit_settings(const ChosenMethod& method)
{
    MboitSettings s{};
    s.trigonometric = method.value("basis") == "trigonometric";
    s.half = method.number("moments") / 2;
    s.rounded = method.value("format") == "unorm16";
    s.overestimation = static_cast<float>(method.real("overestimation"));
    constexpr double kTrigonometric[2][3] = {{4e-7, 8e-7, 1.5e-6}, {4e-4, 6.5e-4, 8.5e-4}};
    constexpr double kPower[2][3] = {{5e-7, 5e-6, 5e-5}, {6e-5, 6e-4, 2.5e-3}};
    const auto row = static_cast<std::size_t>(s.rounded ? 1 : 0);
    const auto column = static_cast<std::size_t>(s.half - 2);
    s.bias = (s.trigonometric ? kTrigonometric : kPower)[row][column];
    constexpr std::array<double, 5> kEven[2][3] = {
        {{1, 0.375, 0.375, 0, 0},
         {1, 0.48, 0.451, 0.45, 0},
         {1, 0.75, 2.03 / 3, 0.63, 0.60030303030303034}},
        {{1, 0.628, 0.628, 0, 0},
         {1, 0.5566, 0.489, 0.47869382, 0},
         {1, 0.42474916, 0.22407803, 0.15369231, 0.12900441}}};
    s.even = kEven[row][column];
    return s;
}

}  // namespace sheer
