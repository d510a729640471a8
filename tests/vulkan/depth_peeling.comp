#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/layers.glsl"
#include "sheer/depth_peeling.glsl"
#include "fragment_list.glsl"

layout(constant_id = 1) const int kPeels = 1;

float beyond_any = uintBitsToFloat(0x7f800000u);  // infinity

void main()
{
    DepthPeel peel = depth_peeling_clear(beyond_any);
    bool found = true;
    for (int p = 0; p < kPeels && found; ++p) {
        if (p > 0) peel = depth_peeling_begin(peel, beyond_any);
        for (uint i = list_begin(); i < list_end(); ++i) {
            Fragment f = fragments[i];
            Layer here = layer_of(covers(f), layer_clear(beyond_any), depth_here(f), f.primitive,
                                  color_of(f), f.opacity);
            peel = depth_peeling_insert(peel, here);
        }
        found = peel.nearest.depth < beyond_any;
    }
    Layer all = depth_peeling_begin(peel, beyond_any).front;
    keep(all.color, all.opacity, all.depth);
    put(layer_resolve(all, backdrop()), 1 - all.opacity);
}
