#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/alpha_correction.glsl"
#include "sheer/stochastic_depth.glsl"
#include "fragment_list.glsl"
#include "stochastic_names.glsl"

void main()
{
    StochasticDepth s = stochastic_depth_clear(uintBitsToFloat(0x7f800000u));  // infinity
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        s = stochastic_depth_insert(s, takes(f), StochasticDepth(depth_here(f), f.primitive));
    }
    StochasticDepthSum sum = stochastic_depth_no_sum();
    float transmittance = 1.0;
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        StochasticDepth here = StochasticDepth(depth_here(f), f.primitive);
        bool shown = stochastic_depth_shows(s, covers(f), here);
        sum = stochastic_depth_add(sum, shown ? f.opacity : 0.0, color_of(f));
        transmittance = total_alpha_insert(transmittance, covers(f), f.opacity);
    }
    keep(sum.color, sum.weight, transmittance);
    vec3 front = sum.color;
    if (kCorrects) front = alpha_corrected(sum.color, sum.weight, 1.0 - transmittance);
    put(over(front, transmittance, backdrop()), transmittance);
}
