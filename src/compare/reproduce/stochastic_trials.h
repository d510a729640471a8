// Stochastic transparency by enumeration and by rendering: full-screen layers, all samples at the
// pixel's centre, so that every pixel of a picture is a trial of its own.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sheer/render.h>
#include <sheer/scene.h>

#include "reference/stochastic_estimators.h"

namespace sheer {

// Layers, nearest first, over a background.
struct Stack {
    std::vector<double> opacities;
    std::vector<Float3> colors;  // as many
    Float3 background = {0, 0, 0};

    std::string source() const;  // of the built-in scene
    reference::EstimatedPixel pixel(int samples) const;
    std::array<double, 3> truth() const;
};

// An estimator, and the method whose pictures are of it.
struct Estimation {
    const char* title;
    reference::Estimator estimator;
    reference::Masks masks;
    const char* method;    // nullptr: of none
    bool clamped = false;  // its pictures are to be clamped to [0, 1]
};

// Naive, stratified, A, U, U clamped, D.
std::span<const Estimation> stochastic_estimations();
const Estimation& stochastic_estimation(reference::Estimator estimator);

using ExactMoments = std::array<reference::Moments, 4>;
ExactMoments exact_moments(const Estimation& estimation, const Stack& stack, int samples);

// Red, green and blue over the pixels of a picture.
struct Trials {
    std::size_t count = 0;
    std::array<double, 3> mean{}, variance{};
};

Image clamp_colors(Image image);  // to [0, 1]

struct TrialsRequest {
    const Stack& stack;
    int samples;
    int side;  // of the picture, pixels
};

Trials render_trials(const Estimation& estimation, const TrialsRequest& request, Options options);

// What was measured against what is so: the standard error that an estimate of that many trials
// has, and the difference in units of it. Empty where nothing is random.
struct Test {
    double error, z;
};
std::optional<Test> test_mean(double measured, double expected, double variance,
                              std::size_t trials);
// Of the standard deviation.
std::optional<Test> test_deviation(double measured, const reference::Moments& exact,
                                   std::size_t trials);

}  // namespace sheer
