#version 450
#extension GL_GOOGLE_include_directive : require
// Hashes, random numbers and masks, of one seed and opacity a lane.
#include "sheer/prelude.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic.glsl"

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
    SampleBits stratified = stratified_mask(seed, opacity, kSamples);
    uint[10] all = uint[](hash_whole(seed), identity_seed(i, seed), fragment_seed(seed, i, next),
                          next, floatBitsToUint(next_real), state, naive.low, naive.high,
                          stratified.low, stratified.high);
    for (uint k = 0; k < 10; ++k) results[10 * i + k] = all[k];
}
