// Alpha testing: a fragment is opaque where its opacity reaches a threshold, and absent elsewhere.
//
// The threshold is a number for all (0.5), a random one for each fragment, which passes with a
// chance of its opacity (stochastic.glsl with one sample), or one that stays with the surface
// (hashed_threshold.glsl). Wyman and McGuire. Improved Alpha Testing Using Hashed Sampling. TVCG
// 25(2), 2019.
// Needs prelude.glsl, random.glsl.

SHEER_FN mask alpha_test(real opacity, real threshold)
{
    return opacity >= threshold;
}

// In (0, 1], so that the chance to pass is the opacity and what has none never does. `seed`: of a
// fragment in a pixel.
SHEER_FN real random_threshold(whole seed)
{
    return next_random_real(seed) + real(5.9604644775390625e-8f);  // 2^-24
}
