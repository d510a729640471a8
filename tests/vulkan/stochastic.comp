#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/alpha_correction.glsl"
#include "fragment_list.glsl"
#include "stochastic_names.glsl"

void main()
{
    const float kBeyondAny = uintBitsToFloat(0x7f800000u);  // infinity
    StochasticStore s = stochastic_clear(kBeyondAny);
    float transmittance = 1.0;
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        StochasticStore here = StochasticStore(depth_here(f), f.primitive, color_of(f));
        s = stochastic_insert(s, takes(f), here);
        transmittance = total_alpha_insert(transmittance, covers(f), f.opacity);
    }
    keep(s.color, s.depth, transmittance);
    float empty = stochastic_transmittance(s, kBeyondAny);
    if (kCorrects) {
        vec3 shown = stochastic_resolve(s, kBeyondAny, vec3(0.0));
        vec3 corrected = alpha_corrected(shown, 1.0 - empty, 1.0 - transmittance);
        put(over(corrected, transmittance, backdrop()), transmittance);
    } else {
        put(stochastic_resolve(s, kBeyondAny, backdrop()), empty);
    }
}
