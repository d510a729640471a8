#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/weighted_average.glsl"
#include "sheer/layers.glsl"
#include "sheer/hybrid.glsl"
#include "fragment_list.glsl"
#include "layer_list.glsl"

layout(constant_id = 2) const int kKind = 0;

void main()
{
    clear_layers();
    HybridTail tail = hybrid_clear();
    for (uint i = list_begin(); i < list_end(); ++i) {
        tail = hybrid_add(tail, exchange_layers(layer_here(fragments[i])), beyond_any);
    }
    keep(tail.sum.color, tail.sum.opacity, tail.transmittance);
    Layer core = all_layers();
    put(hybrid_resolve(kKind, core, tail, backdrop()), hybrid_transmittance(kKind, core, tail));
}
