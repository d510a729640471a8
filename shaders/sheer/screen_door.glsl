// Screen door transparency: alpha to coverage with the pixels of a square in place of samples.
// C. Wyman, M. McGuire. Improved Alpha Testing Using Hashed Sampling. TVCG 25(2), 2019, section 8;
// the order of the pixels is B. Bayer's (An Optimum Method for Two-Level Rendition of Continuous
// Tone Pictures, 1973).
//
// The opacity is right over a square, not in a pixel. What sets the strata apart must be the same
// for a layer's pixels: its object's or triangle's identity.
// Needs prelude.glsl, random.glsl, stochastic_masks.glsl, alpha_to_coverage.glsl.

// Pixel (x, y) of a square of 2^bits pixels a side, in Bayer's order: bits of x ^ y and y by turns,
// the lowest first and most significant.
SHEER_FN whole bayer_number(whole x, whole y, int bits)
{
    whole number = whole(0u);
    whole mixed = x ^ y;
    for (int k = 0; k < bits; ++k) {
        number = (number << 2) | (((mixed >> k) & whole(1u)) << 1) | ((y >> k) & whole(1u));
    }
    return number;
}

// `seed`: of the layer; `apart`: whether it sets the strata of layers apart; `jittered`: whether it
// rounds the number of pixels.
SHEER_FN mask screen_door_keeps(real opacity, whole x, whole y, int bits, whole seed, bool apart,
                                bool jittered)
{
    whole n = whole(1u);
    for (int k = 0; k < bits; ++k) n = n << 2;
    real chi = next_random_real(seed) + real(5.9604644775390625e-8f);  // 2^-24: above 0
    whole offset = coverage_offset(n, next_random_real(seed));
    whole increment = coverage_increment(n, next_random_real(seed));
    if (!jittered) chi = real(0.5f);
    if (!apart) {
        offset = whole(0u);
        increment = whole(1u);
    }
    whole stratum = coverage_stratum(bayer_number(x, y, bits), n, offset, increment);
    return coverage_keeps(opacity, stratum, chi, n);
}
