// Alpha test, then alpha blend: what reaches a high threshold is opaque and drawn first; the rest
// is blended over it in the order of arrival, where nothing that is opaque hides it.
//
// What engines do against halos, as section 3 of Wyman and McGuire has it: Improved Alpha Testing
// Using Hashed Sampling. TVCG 25(2), 2019. Two passes over the fragments. Exact where what is
// blended arrives from far to near and nothing between the threshold and 1 is opaque.
// Needs prelude.glsl, random.glsl, over.glsl, stochastic.glsl, alpha_test.glsl, blend.glsl.

struct TestThenBlendStore {
    StochasticStore opaque;  // the nearest that passes
    BlendStore rest;         // what lies before that
};

SHEER_FN TestThenBlendStore test_then_blend_clear(real beyond_any)
{
    TestThenBlendStore s;
    s.opaque = stochastic_clear(beyond_any);
    s.rest = blend_clear();
    return s;
}

// The first pass.
SHEER_FN TestThenBlendStore test_then_blend_test(TestThenBlendStore s, mask covered,
                                                 StochasticStore f, real opacity, real threshold)
{
    s.opaque = stochastic_insert(s.opaque, covered && alpha_test(opacity, threshold), f);
    return s;
}

// The second one.
SHEER_FN TestThenBlendStore test_then_blend_blend(TestThenBlendStore s, mask covered,
                                                  StochasticStore f, real opacity, real threshold)
{
    mask shown = covered && !alpha_test(opacity, threshold) && stochastic_nearer(s.opaque, f);
    s.rest = blend_insert(s.rest, shown, f.color, opacity);
    return s;
}

// All of `later` arrived after all of `s`. After the first pass nothing is blended yet.
SHEER_FN TestThenBlendStore test_then_blend_merge(TestThenBlendStore s, TestThenBlendStore later,
                                                  real beyond_any)
{
    s.opaque = stochastic_insert(s.opaque, later.opaque.depth < beyond_any, later.opaque);
    s.rest = blend_merge(s.rest, later.rest);
    return s;
}

SHEER_FN real3 test_then_blend_resolve(TestThenBlendStore s, real beyond_any, real3 backdrop)
{
    return blend_resolve(s.rest, stochastic_resolve(s.opaque, beyond_any, backdrop));
}

SHEER_FN real test_then_blend_transmittance(TestThenBlendStore s, real beyond_any)
{
    return s.rest.transmittance * stochastic_transmittance(s.opaque, beyond_any);
}
