// Alpha to coverage: of n samples as many as the opacity says, each with a threshold of its own.
// C. Wyman, M. McGuire. Improved Alpha Testing Using Hashed Sampling. TVCG 25(2), 2019, section 8.
//
// Thresholds (chi + stratum) / n: one in each stratum, so that the number of samples is floor or
// ceil of n times the opacity. chi = 1/2 and strata in turn are what GPUs have (equation 7): layers
// of one opacity take the same samples. A random chi rounds their number without bias (equation 8);
// strata that begin anywhere and go on by an odd step (equation 9) keep layers apart.
// Needs prelude.glsl, random.glsl, stochastic_masks.glsl.

// The stratum of sample i of n, a power of 2; `increment` odd.
SHEER_FN whole coverage_stratum(whole i, whole n, whole offset, whole increment)
{
    return (offset + i * increment) & (n - whole(1u));
}
SHEER_FN whole coverage_offset(whole n, real xi)
{
    return to_whole(to_real(n) * xi);
}
SHEER_FN whole coverage_increment(whole n, real xi)
{
    whole half_of = to_whole(to_real(n) * real(0.5f) * xi);
    return half_of + half_of + whole(1u);
}

// chi in (0, 1]: what has no opacity keeps no sample, what is opaque all of them.
SHEER_FN mask coverage_keeps(real opacity, whole stratum, real chi, whole n)
{
    return opacity * to_real(n) >= chi + to_real(stratum);
}

// Sample i's chi: the same for all, or apart by the golden ratio. Only the stratum that the opacity
// ends in is ever in doubt, so it is one fragment's samples that then no longer agree, not their
// number.
SHEER_FN real coverage_chi(real chi, whole i, bool each)
{
    real turned = chi + to_real(i) * real(0.618034f);
    return each ? max(turned - floor(turned), real(1e-6f)) : chi;
}

SHEER_FN SampleBits coverage_mask(real opacity, real chi, bool each, whole offset, whole increment,
                                  int samples)
{
    SampleBits bits;
    bits.low = whole(0u);
    bits.high = whole(0u);
    whole n = whole(1u);
    for (int k = 1; k < samples; k += k) n = n + n;
    whole i = whole(0u);
    whole bit = whole(1u);
    for (int k = 0; k < samples; ++k) {
        whole stratum = coverage_stratum(i, n, offset, increment);
        mask kept = coverage_keeps(opacity, stratum, coverage_chi(chi, i, each), n);
        if (k < 32) {
            bits.low = bits.low | zero_unless(kept, bit);
        } else {
            bits.high = bits.high | zero_unless(kept, bit);
        }
        bit = k == 31 ? whole(1u) : bit + bit;
        i = i + whole(1u);
    }
    return bits;
}
