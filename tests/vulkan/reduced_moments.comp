#version 450
#extension GL_GOOGLE_include_directive : require
// Each function of reduced_moments.glsl, of four numbers a lane.
#include "sheer/prelude.glsl"
#include "sheer/reduced_moments.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Numbers { float numbers[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Results { float results[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (4 * i >= numbers.length()) return;
    float n[4];
    for (uint k = 0; k < 4; ++k) n[k] = numbers[4 * i + k];
    MissingFragment missing = missing_fragment(n[0], n[1], n[2], n[3]);
    results[4 * i] = reduced_mix(n[0], n[1], n[2]);
    results[4 * i + 1] = missing.keeps;
    results[4 * i + 2] = missing.depth;
    results[4 * i + 3] = missing.place;
}
