#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/blend.glsl"
#include "fragment_list.glsl"

void main()
{
    BlendStore s = blend_clear();
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        s = blend_insert(s, covers(f), color_of(f), f.opacity);
    }
    keep(s.color, s.transmittance, 0);
    put(blend_resolve(s, backdrop()), s.transmittance);
}
