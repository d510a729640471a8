#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/alpha_to_coverage.glsl"
#include "fragment_list.glsl"

bool keeps(Fragment f)
{
    SampleBits bits = coverage_mask(f.opacity, 0.5, false, 0, 1, kSamples);
    return has_sample(bits.low, bits.high);
}

#include "nearest_kept.glsl"
