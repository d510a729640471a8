#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/bits.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/alpha_correction.glsl"
#include "sheer/stochastic_depth.glsl"
#include "sheer/slab_bits.glsl"
#include "sheer/slab.glsl"
#include "sheer/mlcb.glsl"
#include "fragment_list.glsl"

layout(constant_id = 1) const int kLayers = 8;
layout(constant_id = 2) const int kBits = 32;
layout(constant_id = 3) const int kKeep = 0;  // purged, visible, nearest
layout(constant_id = 4) const bool kCorrects = true;

const int kMostLayers = 32;
float beyond_any = uintBitsToFloat(0x7f800000u);  // infinity

SlabLayer layers[kMostLayers + 1];
int count = 0;

SlabLayer layer_of_fragment(Fragment f)
{
    SlabLayer s = slab_clear(beyond_any);
    s.depth = depth_here(f);
    s.id = f.primitive;
    s.color = color_of(f);
    uint place = pixel % kTilePixels;
    uint seed = fragment_seed(tile.x + place % kTileSize, tile.y + place / kTileSize,
                              identity_seed(f.primitive, tile.key));
    s.bits = slab_random_mask(seed, at, (1u << 24) / uint(kSamples), f.opacity, kBits);
    return s;
}

// Those that are not seen go.
void purge()
{
    SlabFront front = slab_no_front();
    int left = 0;
    for (int j = 0; j < count; ++j) {
        bool seen = slab_shows(true, front, layers[j]);
        front = slab_behind(front, seen, layers[j]);
        if (seen) layers[left++] = layers[j];
    }
    count = left;
}

void insert(SlabLayer f)
{
    SlabFront front = slab_no_front();
    if (kKeep != 2) {
        for (int j = 0; j < count; ++j) {
            front = slab_behind(front, slab_in_front(layers[j], f), layers[j]);
        }
    }
    if (!slab_shows(true, front, f)) return;
    for (int j = 0; j < count; ++j) slab_exchange(layers[j], f);
    layers[count++] = f;
    if (kKeep == 0) purge();
    if (count <= kLayers) return;
    count = kLayers;
    layers[kLayers - 1] = mlcb_join(layers[kLayers - 1], layers[kLayers]);
}

void main()
{
    float through = 1.0;
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        if (!covers(f)) continue;
        insert(layer_of_fragment(f));
        through = total_alpha_insert(through, true, f.opacity);
    }
    StochasticDepthSum sum = stochastic_depth_no_sum();
    SlabFront front = slab_no_front();
    for (int j = 0; j < count; ++j) {
        float part = slab_part(true, front, layers[j], kBits);
        sum = stochastic_depth_add(sum, part, layers[j].color);
        front = slab_behind(front, true, layers[j]);
    }
    if (!kCorrects) through = slab_visibility(true, front, kBits);
    keep(sum.color, sum.weight, through);
    vec3 shown = sum.color;
    if (kCorrects) shown = alpha_corrected(sum.color, sum.weight, 1.0 - through);
    put(over(shown, through, backdrop()), through);
}
