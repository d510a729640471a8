#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/alpha_to_coverage.glsl"
#include "sheer/screen_door.glsl"
#include "fragment_list.glsl"

layout(constant_id = 1) const int kBits = 2;  // of the square's side
layout(constant_id = 2) const bool kByObject = true;
layout(constant_id = 3) const bool kApart = true;
layout(constant_id = 4) const bool kJittered = true;

bool keeps(Fragment f)
{
    uint place = pixel % kTilePixels;
    uint x = tile.x + place % kTileSize, y = tile.y + place / kTileSize;
    uint name = kByObject ? 2 * f.object + f.back_facing : f.primitive;
    return screen_door_keeps(f.opacity, x, y, kBits, identity_seed(name, 0), kApart, kJittered);
}

#include "nearest_kept.glsl"
