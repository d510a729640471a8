#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/layers.glsl"
#include "sheer/mlab.glsl"
#include "fragment_list.glsl"
#include "layer_list.glsl"

void main()
{
    clear_layers();
    for (uint i = list_begin(); i < list_end(); ++i) {
        Layer fallen = exchange_layers(layer_here(fragments[i]));
        layers[kLayers - 1] = mlab_merge(layers[kLayers - 1], fallen);
    }
    Layer last = layers[kLayers - 1], all = all_layers();
    keep(last.color, last.opacity, last.depth);
    put(layer_resolve(all, backdrop()), 1 - all.opacity);
}
