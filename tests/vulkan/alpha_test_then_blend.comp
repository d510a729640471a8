#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/alpha_test.glsl"
#include "sheer/blend.glsl"
#include "sheer/alpha_test_then_blend.glsl"
#include "fragment_list.glsl"

layout(constant_id = 1) const float kCutoff = 0.95;

StochasticStore here(Fragment f)
{
    return StochasticStore(depth_here(f), f.primitive, color_of(f));
}

void main()
{
    const float kBeyondAny = uintBitsToFloat(0x7f800000u);  // infinity
    TestThenBlendStore s = test_then_blend_clear(kBeyondAny);
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        s = test_then_blend_test(s, covers(f), here(f), f.opacity, kCutoff);
    }
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        s = test_then_blend_blend(s, covers(f), here(f), f.opacity, kCutoff);
    }
    keep(s.rest.color, s.rest.transmittance, s.opaque.depth);
    put(test_then_blend_resolve(s, kBeyondAny, backdrop()),
        test_then_blend_transmittance(s, kBeyondAny));
}
