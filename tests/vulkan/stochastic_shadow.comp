#version 450
#extension GL_GOOGLE_include_directive : require
// Each function of stochastic_shadow.glsl, of six numbers a lane.
#include "sheer/prelude.glsl"
#include "sheer/stochastic_shadow.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Numbers { float numbers[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Results { float results[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (6 * i >= numbers.length()) return;
    float n[6];
    for (uint k = 0; k < 6; ++k) n[k] = numbers[6 * i + k];
    results[5 * i] = shadow_is_lit(n[0], n[1]) ? 1.0f : 0.0f;
    results[5 * i + 1] = shadow_depth_at(n[0], n[1], n[2], n[3], n[4]);
    results[5 * i + 2] = shadow_sum(n[0], n[1], n[2], n[3]);
    results[5 * i + 3] = shadow_random_place(n[0], n[1], n[2], n[3]);
    results[5 * i + 4] = shadow_corrected(n[0], n[4], n[5]);
}
