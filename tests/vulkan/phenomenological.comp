#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/phenomenological.glsl"
#include "fragment_list.glsl"
#include "buffer_depth.glsl"

void main()
{
    PhenomenologicalStore s = phenomenological_clear();
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        float weight = phenomenological_weight(depth_in_buffer(distance_of(f)), f.opacity);
        vec3 through = vec3(1.0 - f.opacity);
        s = phenomenological_insert(s, covers(f), color_of(f), f.opacity, through, weight);
    }
    keep(s.color, s.weight, s.transmittance.x);
    put(phenomenological_resolve(s, backdrop()), phenomenological_transmittance(s));
}
