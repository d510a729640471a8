// What methods that are not exact must answer for one sample, in double precision, and for the
// random ones the exact moments of their answer.
//
// Written from the papers alone, as plain loops over the fragments; it shares nothing with the
// methods that it judges.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "reference/reference.h"

namespace sheer::reference {

// Over in the order of arrival: what arrives first ends up behind.
Rgba blend(std::span<const Fragment> fragments, Rgba backdrop);

// L. Bavoil, K. Myers, "Order independent transparency with dual depth peeling", 2008, weighted
// average.
Rgba weighted_average(std::span<const Fragment> fragments, Rgba backdrop);

// M. McGuire, L. Bavoil, "Weighted blended order-independent transparency", 2013: its equations,
// and a weight that ignores depth and opacity.
enum class WboitWeight { eq7, eq8, eq9, eq10, uniform };

// The weight without the factor opacity that equations 7 to 10 begin with. z is the distance from
// the camera, positive; only equation 10 uses the planes. zfar = 0: there is no far plane.
double wboit_weight(WboitWeight weight, double z, double znear, double zfar);

// Weighted blended transparency; the fragments' depth is z.
Rgba wboit(std::span<const Fragment> fragments, WboitWeight weight, double znear, double zfar,
           Rgba backdrop);

// How stochastic transparency chooses the samples that a fragment keeps: E. Enderton et al.,
// "Stochastic transparency", 2010. Naive: each by its own throw. Stratified: R = floor(opacity S +
// xi) of them, all such sets equally likely.
enum class Masks { naive, stratified };

struct Moments {
    double mean = 0;
    double variance = 0;
    double fourth = 0;  // central
};

// Probabilities of 0, 1, ..., `uncovered` of the uncovered samples becoming covered by a layer.
// Samples are 1 to 256, here and below.
std::vector<double> newly_covered(int uncovered, double opacity, Masks masks, int samples);

// Of the uncovered fraction of the samples, behind each of the layers.
std::vector<Moments> uncovered(std::span<const double> opacities, Masks masks, int samples);

// Of a pixel's red, green, blue and alpha, premultiplied, under basic stochastic transparency: the
// mean of its samples. Each fragment covers them all before masking. Fragments in any order; ties
// in depth: the smaller id is in front.
std::array<Moments, 4> stochastic(std::vector<Fragment> fragments, Masks masks, int samples,
                                  Rgba backdrop);

}  // namespace sheer::reference
