#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/alpha_test.glsl"
#include "fragment_list.glsl"

layout(constant_id = 1) const float kCutoff = 0.5;

bool keeps(Fragment f)
{
    return alpha_test(f.opacity, kCutoff);
}

#include "nearest_kept.glsl"
