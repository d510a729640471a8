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
#include "fragment_list.glsl"

layout(constant_id = 1) const int kLayers = 8;
layout(constant_id = 2) const int kBits = 32;  // 0: more than any number
layout(constant_id = 3) const bool kMasks = true;
layout(constant_id = 4) const bool kStratified = true;
layout(constant_id = 5) const bool kInDepth = false;
layout(constant_id = 6) const int kKeep = 0;  // purged, visible, nearest
layout(constant_id = 7) const bool kDepthBased = true;
layout(constant_id = 8) const bool kAddsTail = true;
layout(constant_id = 9) const bool kCorrects = false;

const int kCandidates = 32;
float beyond_any = uintBitsToFloat(0x7f800000u);  // infinity
uint apart = (1u << 24) / uint(kSamples);
bool asks = kKeep != 2 && !kInDepth;

SlabLayer layers[kCandidates + 1];
int count = 0;

uint seed_of(uint name)
{
    uint place = pixel % kTilePixels;
    return fragment_seed(tile.x + place % kTileSize, tile.y + place / kTileSize,
                         identity_seed(name, tile.key));
}

// As much of it as tells where it is.
SlabLayer place_of(Fragment f)
{
    SlabLayer s = slab_clear(beyond_any);
    s.depth = depth_here(f);
    s.id = f.primitive;
    return s;
}

SlabLayer layer_of_fragment(Fragment f)
{
    SlabLayer s = place_of(f);
    s.color = color_of(f);
    uint seed = seed_of(f.primitive);
    if (kMasks) {
        s.bits = slab_random_mask(seed, at, apart, f.opacity, kBits);
        return s;
    }
    s.opacity = f.opacity;
    s.limit = slab_no_limit();
    if (kBits > 0 && !kInDepth) {
        s.limit = slab_random_limit(seed, at, apart, kStratified, f.opacity, kBits);
    }
    return s;
}

SlabFront front_of(SlabLayer f)
{
    SlabFront front = slab_no_front();
    for (int j = 0; j < count; ++j) {
        front = slab_behind(front, slab_in_front(layers[j], f), layers[j]);
    }
    return front;
}

// Those that are not seen go.
void purge()
{
    SlabFront front = slab_no_front();
    int left = 0;
    for (int j = 0; j < count; ++j) {
        bool seen = slab_shows(kMasks, front, layers[j]);
        front = slab_behind(front, seen, layers[j]);
        if (seen) layers[left++] = layers[j];
    }
    count = left;
}

void insert(SlabLayer f)
{
    SlabFront front = slab_no_front();
    if (asks) front = front_of(f);
    if (!slab_shows(kMasks, front, f)) return;
    for (int j = 0; j < count; ++j) slab_exchange(layers[j], f);
    layers[count++] = f;
    if (kKeep == 0 && !kInDepth) purge();
    count = min(count, kInDepth ? kCandidates : kLayers);
}

void choose()
{
    uint seed = seed_of(0x7fffffffu);
    float sum = slab_xi(seed, at, apart);
    SlabFront front = slab_no_front();
    int left = 0;
    for (int j = 0; j < count; ++j) {
        float alpha = 1.0 - front.transmittance;
        bool kept = slab_passes(sum, slab_chance(kStratified, alpha, layers[j].opacity, kBits));
        front = slab_behind(front, kept, layers[j]);
        if (kept) layers[left++] = layers[j];
    }
    count = min(left, kLayers);
}

void main()
{
    for (uint i = list_begin(); i < list_end(); ++i) {
        if (covers(fragments[i])) insert(layer_of_fragment(fragments[i]));
    }
    if (kInDepth) choose();

    StochasticDepthSum sum = stochastic_depth_no_sum();
    float through = 1.0;
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        if (!covers(f)) continue;
        through = total_alpha_insert(through, true, f.opacity);
        if (!kDepthBased) continue;
        SlabLayer here = place_of(f);
        bool is_full = count == kLayers;
        bool dropped = !kAddsTail && is_full && slab_in_front(layers[max(count, 1) - 1], here);
        float seen = slab_visibility(kMasks, front_of(here), kBits);
        sum = stochastic_depth_add(sum, dropped ? 0.0 : seen * f.opacity, color_of(f));
    }
    if (!kDepthBased) {
        SlabFront front = slab_no_front();
        for (int j = 0; j < count; ++j) {
            float part = slab_part(kMasks, front, layers[j], kBits);
            sum = stochastic_depth_add(sum, part, layers[j].color);
            front = slab_behind(front, true, layers[j]);
        }
        if (!kCorrects) through = slab_visibility(kMasks, front, kBits);
    }
    keep(sum.color, sum.weight, through);
    vec3 shown = sum.color;
    if (kCorrects) shown = alpha_corrected(sum.color, sum.weight, 1.0 - through);
    put(over(shown, through, backdrop()), through);
}
