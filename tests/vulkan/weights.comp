#version 450
#extension GL_GOOGLE_include_directive : require
// Weights of wboit.glsl, of one distance, depth in a buffer and opacity a lane.
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/wboit.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 0) const int kEquation = 0;
struct Place {
    float z, d, opacity;
};
layout(std430, set = 0, binding = 0) readonly buffer Places { Place places[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Weights { float weights[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= places.length()) return;
    weights[i] = wboit_weight(kEquation, places[i].z, places[i].d, places[i].opacity);
}
