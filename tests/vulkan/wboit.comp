#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/wboit.glsl"
#include "fragment_list.glsl"
#include "buffer_depth.glsl"

layout(constant_id = 1) const int kEquation = 9;

void main()
{
    WboitStore s = wboit_clear();
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        float z = distance_of(f);
        float weight = wboit_weight(kEquation, z, depth_in_buffer(z), f.opacity);
        s = wboit_insert(s, covers(f), color_of(f), f.opacity, weight);
    }
    keep(s.color, s.weight, s.transmittance);
    put(wboit_resolve(s, backdrop()), s.transmittance);
}
