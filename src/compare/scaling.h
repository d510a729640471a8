// How a time grows with what there is to do.
#pragma once

#include <span>
#include <vector>

#include <sheer/scene.h>

namespace sheer {

// y = factor x^exponent.
struct PowerLaw {
    double exponent;
    double error;  // the exponent's standard error; NaN: fewer than three points
};

// By least squares between the logarithms. Both are NaN where there is no such law: fewer than two
// different x, or a number that is not above 0.
PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y);

// All objects, then those that are transparent once more for each time after the first, in the same
// places: each pixel gets `times` as many fragments. The copies have ids of their own. What is MASK
// is among them for methods that test it.
std::vector<Object> repeat_transparent(const Scene& scene, int times, bool tests_masks);

}  // namespace sheer
