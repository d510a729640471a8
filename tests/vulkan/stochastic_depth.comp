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
    StochasticDepthStore s = stochastic_depth_clear(uintBitsToFloat(0x7f800000u));  // infinity
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        s = stochastic_depth_insert(s, takes(f), depth_here(f), f.primitive);
    }
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        s = stochastic_depth_add(s, covers(f), depth_here(f), f.primitive, color_of(f), f.opacity);
        s.transmittance = total_alpha_insert(s.transmittance, covers(f), f.opacity);
    }
    keep(s.color, s.weight, s.transmittance);
    vec3 front = kCorrects ? alpha_corrected(s.color, s.weight, 1.0 - s.transmittance) : s.color;
    put(over(front, s.transmittance, backdrop()), s.transmittance);
}
