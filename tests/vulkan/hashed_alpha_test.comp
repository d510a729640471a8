#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/alpha_test.glsl"
#include "sheer/hashed_threshold.glsl"
#include "sheer/temporal_threshold.glsl"
#include "sheer/fade_in.glsl"
#include "fragment_list.glsl"
#include "hashed_names.glsl"
layout(constant_id = 7) const float kFadeLevels = 0.0;

bool keeps(Fragment f)
{
    float threshold = threshold_of(cells_of(f));
    if (kFadeLevels > 0.0) threshold = faded_threshold(threshold, fade_in(f.level, kFadeLevels));
    return alpha_test(f.opacity, threshold);
}

#include "nearest_kept.glsl"
