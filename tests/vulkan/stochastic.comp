#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic.glsl"
#include "fragment_list.glsl"

layout(constant_id = 1) const bool kStratified = true;
layout(constant_id = 2) const uint kSeedBy = 1;  // depth, primitive, object

void main()
{
    const float kBeyondAny = uintBitsToFloat(0x7f800000u);  // infinity
    uint place = pixel % kTilePixels;
    uint x = tile.x + place % kTileSize, y = tile.y + place / kTileSize;
    StochasticStore s = stochastic_clear(kBeyondAny);
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        uint[3] names = uint[](floatBitsToUint(f.center), f.primitive, f.object);
        uint own = fragment_seed(x, y, identity_seed(names[kSeedBy], tile.key));
        SampleBits bits = kStratified ? stratified_mask(own, f.opacity, kSamples)
                                      : naive_mask(own, f.opacity, kSamples);
        StochasticStore here = StochasticStore(depth_here(f), f.primitive, color_of(f));
        s = stochastic_insert(s, covers(f) && has_sample(bits.low, bits.high), here);
    }
    keep(s.color, s.depth, 0);
    put(stochastic_resolve(s, kBeyondAny, backdrop()), stochastic_transmittance(s, kBeyondAny));
}
