#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/wboit.glsl"
#include "sheer/exponential.glsl"
#include "sheer/transmittance.glsl"
#include "fragment_list.glsl"
#include "buffer_depth.glsl"

layout(constant_id = 1) const int kEquation = 9;
layout(constant_id = 2) const int kScaled = 0;  // to what is drawn

void main()
{
    WboitStore s = wboit_clear();
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        float z = distance_of(f);
        float d = depth_in_buffer(z);
        if (kScaled != 0) {
            float depth = clamp_depth(f, f.center);
            d = 0.5 * warped_depth(tile.orthographic != 0, depth, tile.from, tile.scale) + 0.5;
        }
        float weight = wboit_weight(kEquation, z, d, f.opacity);
        s = wboit_insert(s, covers(f), color_of(f), f.opacity, weight);
    }
    keep(s.color, s.weight, s.transmittance);
    put(wboit_resolve(s, backdrop()), s.transmittance);
}
