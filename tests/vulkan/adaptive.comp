#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/adaptive.glsl"
#include "fragment_list.glsl"

layout(constant_id = 1) const int kNodes = 8;

float beyond_any = uintBitsToFloat(0x7f800000u);  // infinity

AdaptiveNode nodes[kNodes];

AdaptiveFragment fragment_here(Fragment f)
{
    return adaptive_fragment(covers(f), beyond_any, depth_here(f), f.primitive, f.opacity);
}

void lower(AdaptiveFragment f)
{
    AdaptiveNode carried = adaptive_node(f);
    for (int k = 0; k < kNodes; ++k) adaptive_exchange(nodes[k], carried, f);
    AdaptiveChoice choice = adaptive_no_choice();
    for (int k = 1; k < kNodes; ++k) {
        choice = adaptive_choose(choice, uint(k), nodes[k - 1], nodes[k]);
    }
    choice = adaptive_choose_last(choice, uint(kNodes), nodes[kNodes - 1], carried, beyond_any);
    for (int k = 0; k < kNodes; ++k) {
        AdaptiveNode next = carried;
        if (k + 1 < kNodes) next = nodes[k + 1];
        nodes[k] = adaptive_remove(choice, uint(k), nodes[k], next);
    }
}

void main()
{
    for (int k = 0; k < kNodes; ++k) nodes[k] = adaptive_clear(beyond_any);
    for (uint i = list_begin(); i < list_end(); ++i) lower(fragment_here(fragments[i]));
    vec3 sum = vec3(0.0);
    for (uint i = list_begin(); i < list_end(); ++i) {
        AdaptiveFragment f = fragment_here(fragments[i]);
        float seen = 1.0;
        for (int k = 0; k < kNodes; ++k) seen = adaptive_seen(seen, nodes[k], f);
        sum = adaptive_add(sum, seen, f, color_of(fragments[i]));
    }
    keep(sum, nodes[0].depth, nodes[0].transmittance);
    AdaptiveNode last = nodes[kNodes - 1];
    put(adaptive_resolve(sum, last, backdrop()), last.transmittance);
}
