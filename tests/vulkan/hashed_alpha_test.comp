#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/alpha_test.glsl"
#include "sheer/hashed_threshold.glsl"
#include "fragment_list.glsl"
#include "hashed_names.glsl"

bool keeps(Fragment f)
{
    return alpha_test(f.opacity, threshold_of(cells_of(f)));
}

#include "nearest_kept.glsl"
