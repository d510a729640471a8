#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/alpha_test.glsl"
#include "fragment_list.glsl"

layout(constant_id = 1) const bool kEach = false;  // sample has a threshold of its own

bool keeps(Fragment f)
{
    uint place = pixel % kTilePixels;
    uint x = tile.x + place % kTileSize, y = tile.y + place / kTileSize;
    uint seed = fragment_seed(x, y, identity_seed(f.primitive, tile.key));
    if (!kEach) return alpha_test(f.opacity, random_threshold(seed));
    SampleBits bits = naive_mask(seed, f.opacity, kSamples);
    return has_sample(bits.low, bits.high);
}

#include "nearest_kept.glsl"
