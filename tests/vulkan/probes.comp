#version 450
#extension GL_GOOGLE_include_directive : require
// A lane for each row of eight operands.
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Operands { float operands[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Results { float results[]; };

layout(constant_id = 0) const int kProbes = 1;

#include "probe_moments.glsl"

void main()
{
    uint row = gl_GlobalInvocationID.x;
    if (8 * row >= operands.length()) return;
    float a = operands[8 * row];
    float b = operands[8 * row + 1];
    float c = operands[8 * row + 2];
    float d = operands[8 * row + 3];
    float e = operands[8 * row + 4];
    float f = operands[8 * row + 5];
    float g = operands[8 * row + 6];
    float h = operands[8 * row + 7];
#define PROBE(index) results[kProbes * row + (index)]
#include "probes.glsl"
}
