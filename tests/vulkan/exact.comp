#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/exact.glsl"
#include "fragment_list.glsl"

void main()
{
    ExactSum s = exact_clear();
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[sorted[at * fragments.length() + i]];
        s = exact_add(s, covers(f), color_of(f), f.opacity);
    }
    keep(s.color, s.transmittance, 0);
    put(exact_resolve(s, backdrop()), s.transmittance);
}
