// What a sample adds to a pixel under each estimator of E. Enderton et al., "Stochastic
// transparency", 2010, sections 3.1 to 3.4, where it is known which fragment owns it: by whatever
// masks.
//
// Written from the paper alone; it shares nothing with the methods that it judges.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "reference/stratified_listing.h"

namespace sheer::reference {

struct SampleSum {
    std::array<double, 3> color = {};
    double weight = 0;
};

// The owner's colour and 1, or nothing. `owner`: as in stratified_owners.
SampleSum owned_sum(std::span<const PixelFragment> fragments, int owner);

// Over the fragments that cover the sample and are not behind the owner: opacity times colour, and
// opacity.
SampleSum seen_sum(std::span<const PixelFragment> fragments, int owner, std::size_t sample);

// The product of 1 - opacity over all fragments that cover the sample.
double total_transmittance(std::span<const PixelFragment> fragments, std::size_t sample);

}  // namespace sheer::reference
