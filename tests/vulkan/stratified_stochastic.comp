#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/bits.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/stratified_stochastic.glsl"
#include "fragment_list.glsl"

layout(constant_id = 1) const bool kTracking = true;
layout(constant_id = 2) const bool kCompaction = true;
layout(constant_id = 3) const bool kSort = true;
layout(constant_id = 4) const uint kDither = 2;  // none, morton, hilbert
layout(constant_id = 5) const int kSequence = 0;  // 4: systematic numbers

// Of the samples of the group's pixels: whether the fragment is open to them, and what they keep.
shared bool opens[64];
shared float depths[64];

// The fragments of the group's pixel that has most: all of a group go through as many.
uint longest_list()
{
    uint longest = 0;
    uint pixels = 64 / uint(kSamples);
    uint from = gl_WorkGroupID.x * pixels;
    for (uint p = from; p < from + pixels; ++p) longest = max(longest, first[p + 1] - first[p]);
    return longest;
}

uint place_on_curve()
{
    uint place = pixel % kTilePixels;
    uint x = tile.x + place % kTileSize, y = tile.y + place / kTileSize;
    uint index = kDither == 2 ? hilbert_index(x, y) : kDither == 1 ? morton_index(x, y) : 0u;
    return reversed_bits(index * (kSequence == 4 ? 1u : uint(kSamples)));
}

bool takes(float opacity, uint number, uint place, uint surface)
{
    if (kSequence == 4) {
        return systematic_takes(opacity, reference_bits(0, place, surface) >> 8, number);
    }
    return stratified_takes(opacity,
                            reference_bits(kSequence, reversed_bits(number) + place, surface));
}

void main()
{
    const float kBeyondAny = uintBitsToFloat(0x7f800000u);  // infinity
    uint own = gl_LocalInvocationID.x, others = own - at;
    uint place = place_on_curve(), longest = longest_list();
    StochasticStore s = stochastic_clear(kBeyondAny);
    StratifiedSurface surface = stratified_clear(tile.key);
    for (uint k = 0; k < longest; ++k) {
        bool there = list_begin() + k < list_end();
        Fragment f = fragments[there ? list_begin() + k : 0];
        StochasticStore here = StochasticStore(depth_here(f), f.primitive, color_of(f));
        bool open = there && covers(f) && stochastic_nearer(s, here);
        opens[own] = open;
        depths[own] = s.depth;
        barrier();
        uint low = 0, high = 0, sooner = 0;
        for (uint t = 0; t < uint(kSamples); ++t) {
            if (!opens[others + t]) continue;
            if (t < 32) low |= 1u << t;
            if (t >= 32) high |= 1u << (t - 32);
            bool before = kSort ? stratified_before(depths[others + t], t, s.depth, at) : t < at;
            sooner += before ? 1 : 0;
        }
        barrier();
        if ((low | high) == 0) continue;
        uint number = stratified_begin(surface, low, high, kTracking);
        number = kCompaction ? number + sooner : at;
        s = stochastic_insert(s, open && takes(f.opacity, number, place, surface.id), here);
    }
    keep(s.color, s.depth, 0.0);
    put(stochastic_resolve(s, kBeyondAny, backdrop()), stochastic_transmittance(s, kBeyondAny));
}
