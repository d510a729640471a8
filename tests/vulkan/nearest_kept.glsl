// The nearest fragment of those that keep the sample. Needs stochastic.glsl, fragment_list.glsl and
// bool keeps(Fragment).
void main()
{
    const float kBeyondAny = uintBitsToFloat(0x7f800000u);  // infinity
    StochasticStore s = stochastic_clear(kBeyondAny);
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        StochasticStore here = StochasticStore(depth_here(f), f.primitive, color_of(f));
        s = stochastic_insert(s, keeps(f) && covers(f), here);
    }
    keep(s.color, s.depth, 0.0);
    put(stochastic_resolve(s, kBeyondAny, backdrop()), stochastic_transmittance(s, kBeyondAny));
}
