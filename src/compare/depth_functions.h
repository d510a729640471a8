// What methods take a pixel's transmittance for, as a function of depth.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/pixel_fragments.h"
#include "lanes/targets.h"
#include "methods/method.h"

namespace sheer {

struct DepthFunctionSetting {
    const SampleSet& samples;
    TargetSet targets;
    std::uint32_t key = 0;  // of random numbers
};

// Whether the method keeps such a function, with these values of its parameters.
bool keeps_depth_function(const ChosenMethod& method, const DepthFunctionSetting& setting);

// Rows that do, with their standard values, but for those of `bench` alone and the random ones.
std::vector<std::string> methods_with_depth_functions(const DepthFunctionSetting& setting);

// What the store lets pass to the eye from each depth, as fragments have it, once it has seen all
// fragments of the pixel.
std::vector<double> depth_function(const ChosenMethod& method, const PixelFragments& pixel,
                                   std::span<const float> depths,
                                   const DepthFunctionSetting& setting);

struct DepthsToAsk {
    int distances = 480;            // about two for each point of a chart across
    std::size_t most_steps = 1000;  // of which both sides are asked for
};

// Where a pixel's functions are worth knowing: at equal distances from before its nearest fragment
// to behind its farthest, and on both sides of every step, if they are not too many. Sorted.
std::vector<float> depths_to_ask(std::span<const TransmittanceStep> steps, const EyeSpace& eye,
                                 const DepthsToAsk& asked = {});

// The distance from the eye, along the view.
double distance_of(float depth, const EyeSpace& eye);

}  // namespace sheer
