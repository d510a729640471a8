#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/hashed_threshold.glsl"
#include "sheer/alpha_to_coverage.glsl"
#include "fragment_list.glsl"
#include "hashed_names.glsl"

layout(constant_id = 7) const bool kEach = false;  // sample has a number of its own
layout(constant_id = 8) const bool kApart = true;

bool keeps(Fragment f)
{
    HashCells cells = cells_of(f);
    uint n = uint(kSamples), offset = 0, increment = 1;
    if (kApart) {
        offset = coverage_offset(n, threshold_of(other_cells(cells, 1)));
        increment = coverage_increment(n, threshold_of(other_cells(cells, 2)));
    }
    SampleBits bits =
        coverage_mask(f.opacity, threshold_of(cells), kEach, offset, increment, kSamples);
    return has_sample(bits.low, bits.high);
}

#include "nearest_kept.glsl"
