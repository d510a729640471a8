// The exact moments of every estimator of E. Enderton et al., "Stochastic transparency", 2010, for
// a pixel with all its samples at one place.
//
// Written from the paper alone; it shares nothing with the methods that it judges.
#pragma once

#include <array>
#include <vector>

#include "reference/methods.h"

namespace sheer::reference {

// The paper's section 4 has the symbols. C: the truth, `over`. T: what all layers let through.
// alpha_C = 1 - T. svis(z_i): the part of the samples that no layer in front of layer i chose.
enum class Estimator {
    basic,                  // B, the mean of the samples
    alpha_corrected,        // A = alpha_C B / B1 where a sample is occupied, else 0; + T backdrop
    depth_based,            // U = sum svis(z_i) alpha_i c_i; + T backdrop
    depth_based_clamped,    // that, clamped to [0, 1] as a display does
    depth_based_empty,      // U + (1 - R/S) backdrop, R the number of occupied samples
    depth_based_remainder,  // U + (1 - U1) backdrop
    depth_corrected,        // D = alpha_C U / U1; + T backdrop
    // alpha_C U / (R/S), + T backdrop: no estimator of the paper's text, but the one that gives the
    // numbers which it prints for D in example 1.
    depth_over_coverage,
};

struct EstimatedPixel {
    std::vector<Fragment> fragments;  // in any order; each covers all samples before masking
    Rgba backdrop;
    int samples = 1;
};

// Of red, green, blue and alpha, premultiplied, by dynamic programming over how many samples are
// still uncovered, and for two estimators also over how many have seen layers of each opacity, or
// of each weight in a channel. 1 to 256 samples and any number of layers, but for those two: time
// and memory grow with the number of such counts. 64 samples are fine with 64 layers of one opacity
// and with 4 layers of different ones.
std::array<Moments, 4> estimate(Estimator estimator, const EstimatedPixel& pixel, Masks masks);

// The probability of a fragment's choosing just the samples whose bits are set in `mask`.
using MaskChance = double (*)(unsigned mask, double opacity, int samples);
double naive_chance(unsigned mask, double opacity, int samples);
double stratified_chance(unsigned mask, double opacity, int samples);
// floor(opacity S + xi) samples in a row from a random one on, the first after the last: cheaper
// than all sets of that size, and with a larger variance of what two of them share.
double contiguous_chance(unsigned mask, double opacity, int samples);

// The same by trying all masks of all layers, with the estimators evaluated sample by sample:
// 2^(samples layers) cases, fewer where masks have no chance. For up to 16 samples; 4 layers of 4
// samples, or 2 of 8.
std::array<Moments, 4> estimate_by_listing(Estimator estimator, const EstimatedPixel& pixel,
                                           MaskChance chance);

// Root of the mean square of what is off from `truth`.
double rms_error(const Moments& moments, double truth);

}  // namespace sheer::reference
