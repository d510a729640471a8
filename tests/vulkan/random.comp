#version 450
#extension GL_GOOGLE_include_directive : require
// Hashes, random numbers and masks, of one seed and opacity a lane.
#include "sheer/prelude.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 0) const int kSamples = 1;
layout(std430, set = 0, binding = 0) readonly buffer Seeds { uint seeds[]; };
layout(std430, set = 0, binding = 1) readonly buffer Opacities { float opacities[]; };
layout(std430, set = 0, binding = 2) writeonly buffer Results { uint results[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= seeds.length()) return;
    uint seed = seeds[i];
    float opacity = opacities[i];
    uint state = seed;
    uint next = next_random(state);
    float next_real = next_random_real(state);
    SampleBits naive = naive_mask(seed, opacity, kSamples);
    uint own = seed;
    float xi = next_random_real(own);
    SampleBits stratified = stratified_mask(own, xi, opacity, kSamples);
    float dithered = dithered_xi(seed & 0x3fffu, i & 0x3fffu, next, own);
    SampleBits part = sample_part(stratified, kSamples / 2, kSamples - kSamples / 2);
    uint count = uint(bitCount(naive.low) + (kSamples > 32 ? bitCount(naive.high) : 0));
    SampleBits open = stratified_mask_of_open(own, xi, opacity, naive, count, kSamples);
    uint index = mask_table_index(seed, opacity);
    SampleBits table = mask_of_table(index / 2047u, index % 2047u, kSamples);
    uint[18] all = uint[](hash_whole(seed), identity_seed(i, seed), fragment_seed(seed, i, next),
                          next, floatBitsToUint(next_real), state, naive.low, naive.high,
                          stratified.low, stratified.high, floatBitsToUint(dithered), part.low,
                          part.high, open.low, open.high, index, table.low, table.high);
    for (uint k = 0; k < 18; ++k) results[18 * i + k] = all[k];
}
