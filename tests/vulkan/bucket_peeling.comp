#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/bits.glsl"
#include "sheer/layers.glsl"
#include "sheer/depth_peeling.glsl"
#include "sheer/bucket_peeling.glsl"
#include "fragment_list.glsl"

layout(constant_id = 1) const int kBuckets = 32;
layout(constant_id = 2) const bool kAdaptive = false;
layout(constant_id = 3) const int kPeels = 1;

float beyond_any = uintBitsToFloat(0x7f800000u);  // infinity

BucketRange range;
uint bins[32];
uint before[33];
DepthPeel peels[kBuckets];

uint place(Fragment f, int parts)
{
    return bucket_place(range, covers(f), depth_here(f), parts);
}

uint bucket_here(Fragment f)
{
    if (!kAdaptive) return place(f, kBuckets);
    uint bin = place(f, 1024);
    uint word = bucket_word(bin);
    return bucket_of_rank(bucket_rank(before[word], bins[word], bin), before[32], kBuckets);
}

void find_bins()
{
    for (int w = 0; w < 32; ++w) bins[w] = 0u;
    for (uint i = list_begin(); i < list_end(); ++i) {
        uint bin = place(fragments[i], 1024);
        bins[bucket_word(bin)] = bucket_mark(bins[bucket_word(bin)], covers(fragments[i]), bin);
    }
    before[0] = 0u;
    for (int w = 0; w < 32; ++w) before[w + 1] = before[w] + bit_count(bins[w]);
}

void main()
{
    range = bucket_range_clear(beyond_any);
    for (uint i = list_begin(); i < list_end(); ++i) {
        range = bucket_range_insert(range, covers(fragments[i]), depth_here(fragments[i]));
    }
    if (kAdaptive) find_bins();
    for (int b = 0; b < kBuckets; ++b) peels[b] = depth_peeling_clear(beyond_any);
    bool found = true;
    for (int p = 0; p < kPeels && found; ++p) {
        for (int b = 0; b < kBuckets && p > 0; ++b) {
            peels[b] = depth_peeling_begin(peels[b], beyond_any);
        }
        for (uint i = list_begin(); i < list_end(); ++i) {
            Fragment f = fragments[i];
            Layer here = layer_of(covers(f), layer_clear(beyond_any), depth_here(f), f.primitive,
                                  color_of(f), f.opacity);
            uint b = bucket_here(f);
            peels[b] = depth_peeling_insert(peels[b], here);
        }
        found = false;
        for (int b = 0; b < kBuckets; ++b) found = found || peels[b].nearest.depth < beyond_any;
    }
    Layer all = layer_clear(beyond_any);
    for (int b = 0; b < kBuckets; ++b) {
        all = layer_over(all, depth_peeling_begin(peels[b], beyond_any).front);
    }
    keep(all.color, range.nearest, range.farthest);
    put(layer_resolve(all, backdrop()), 1.0 - all.opacity);
}
