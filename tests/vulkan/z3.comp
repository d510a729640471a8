#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/layers.glsl"
#include "sheer/z3.glsl"
#include "fragment_list.glsl"
#include "layer_list.glsl"

void main()
{
    clear_layers();
    for (uint i = list_begin(); i < list_end(); ++i) {
        Layer fallen = exchange_layers(layer_here(fragments[i]));
        Z3Choice choice = z3_no_choice();
        for (int k = 0; k + 1 < kLayers; ++k) {
            choice = z3_choose(choice, uint(k), layers[k], layers[k + 1]);
        }
        choice = z3_choose_last(choice, uint(kLayers), layers[kLayers - 1], fallen, beyond_any);
        for (int k = 0; k < kLayers; ++k) {
            Layer next = fallen;
            if (k + 1 < kLayers) next = layers[k + 1];
            layers[k] = z3_join(choice, uint(k), layers[k], next);
        }
    }
    Layer last = layers[kLayers - 1];
    keep(last.color, last.opacity, last.depth);
    Layer all = all_layers();
    put(layer_resolve(all, backdrop()), 1.0 - all.opacity);
}
