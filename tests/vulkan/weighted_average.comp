#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/weighted_average.glsl"
#include "fragment_list.glsl"

void main()
{
    WeightedAverageStore s = weighted_average_clear();
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        s = weighted_average_insert(s, covers(f), color_of(f), f.opacity);
    }
    keep(s.color, s.opacity, s.count);
    put(weighted_average_resolve(s, backdrop()), weighted_average_transmittance(s));
}
