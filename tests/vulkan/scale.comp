#version 450
// The least that shows that buffers and constants arrive: a copy, and the same times a constant.
layout(local_size_x = 32) in;
layout(std430, set = 0, binding = 0) readonly buffer Given { uint given[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Copied { uint copied[]; };
layout(std430, set = 0, binding = 2) buffer Scaled { float scaled[]; };

layout(constant_id = 3) const uint kAdded = 1;
layout(constant_id = 5) const float kFactor = 1.0;

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= given.length()) return;
    copied[i] = given[i] + kAdded;
    scaled[i] = scaled[i] * kFactor;
}
