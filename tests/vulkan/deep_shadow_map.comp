#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/alpha_correction.glsl"
#include "sheer/deep_shadow_map.glsl"
#include "fragment_list.glsl"

layout(constant_id = 1) const uint kErrorBits = 0;
layout(constant_id = 2) const bool kCorrects = true;

float error = uintBitsToFloat(kErrorBits);
float beyond_any = uintBitsToFloat(0x7f800000u);  // infinity

const uint kMostVertices = 512;
DeepShadowVertex vertices[kMostVertices];
uint count = 0u;
DeepShadowLine line;
float through = 1.0;

void append(bool there)
{
    if (!there || count == kMostVertices) return;
    vertices[count].z = line.z;
    vertices[count].v = line.v;
    ++count;
}

void go_on(bool there, float z)
{
    bool ends = deep_shadow_ends(line, there, z, through, error);
    line = deep_shadow_end(line, ends);
    append(ends);
    bool steps = deep_shadow_steps(line, there, z, through, error);
    line = deep_shadow_pass(line, there, steps, z, through, error);
    append(steps);
}

// The first fragment of the sample behind depth z and id; the list's end if there is none.
uint next_behind(float z, uint id)
{
    uint found = list_end();
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        if (!covers(f)) continue;
        float depth = depth_here(f);
        if (!(depth > z || (depth == z && f.primitive > id))) continue;
        if (found < list_end()) {
            float found_depth = depth_here(fragments[found]);
            if (found_depth < depth) continue;
            if (found_depth == depth && fragments[found].primitive < f.primitive) continue;
        }
        found = i;
    }
    return found;
}

float depth_or_beyond(uint i)
{
    return i < list_end() ? depth_here(fragments[i]) : beyond_any;
}

void make_curve()
{
    uint i = next_behind(-beyond_any, 0u);
    float before = -beyond_any;
    line = deep_shadow_begin(depth_or_beyond(i), 1.0);
    append(i < list_end());
    while (i < list_end()) {
        Fragment f = fragments[i];
        float z = depth_here(f);
        go_on(before < z, z);
        through = through * (1.0 - f.opacity);
        i = next_behind(z, f.primitive);
        go_on(z < depth_or_beyond(i), z);
        before = z;
    }
    bool ends = line.last > line.z;
    line = deep_shadow_end(line, ends);
    append(ends);
}

void main()
{
    make_curve();
    DeepShadowSum sum = deep_shadow_no_sum();
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        float seen = 1.0;
        for (uint k = 0; k + 1 < count; ++k) {
            seen = deep_shadow_seen(seen, vertices[k], vertices[k + 1], depth_here(f));
        }
        sum = deep_shadow_add(sum, covers(f), color_of(f), f.opacity, seen);
    }
    keep(sum.color, sum.weight, float(count));
    put(deep_shadow_resolve(kCorrects, sum, through, backdrop()), through);
}
