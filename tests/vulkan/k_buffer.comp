#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/layers.glsl"
#include "sheer/k_buffer.glsl"
#include "fragment_list.glsl"
#include "layer_list.glsl"

layout(constant_id = 2) const int kMerge = 0;  // front, nearest two, discard

void main()
{
    clear_layers();
    Layer emitted = layer_clear(beyond_any);
    for (uint i = list_begin(); i < list_end(); ++i) {
        Layer fallen = exchange_layers(layer_here(fragments[i]));
        if (kMerge == 2) continue;
        bool overflows = k_buffer_overflows(fallen, beyond_any);
        Layer nearest = layers[0];
        for (int k = 0; k < kLayers; ++k) {
            Layer next = fallen;
            if (k + 1 < kLayers) next = layers[k + 1];
            layers[k] = layer_select(overflows, next, layers[k]);
        }
        if (kMerge == 0) {
            emitted = k_buffer_join(overflows, emitted, nearest);
        } else {
            layers[0] = k_buffer_join(overflows, nearest, layers[0]);
        }
    }
    keep(layers[0].color, layers[0].opacity, emitted.opacity);
    Layer all = layer_over(emitted, all_layers());
    put(layer_resolve(all, backdrop()), 1 - all.opacity);
}
