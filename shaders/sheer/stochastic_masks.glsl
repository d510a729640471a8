// Which samples a fragment of stochastic transparency takes: a random part of them, in proportion
// to its opacity, that has nothing to do with what other fragments take. Enderton, Sintorn, Shirley
// and Luebke. Stochastic Transparency. I3D 2010, sections 3.1 and 5.
//
// A pass has up to 64 samples. Several passes may share one mask of all their samples, up to 64
// together, of which each takes its part.
// Needs prelude.glsl, random.glsl.

// A fragment's random samples: sample i in bit i, from 32 on in bit i - 32 of `high`. Bits beyond
// the number of samples mean nothing.
struct SampleBits {
    whole low;
    whole high;
};

// floor(x + xi), but exact: the sum would be rounded.
SHEER_FN whole rounded_at_random(real x, real xi)
{
    whole least = to_whole(x);
    mask one_more = xi < x - to_real(least);
    return least + zero_unless(one_more, whole(1u));
}

// Bit i, which may be as many as 1.5 times `samples`: what is beyond them means nothing.
SHEER_FN SampleBits sample_bit(whole i, int samples)
{
    SampleBits bits;
    bits.high = whole(0u);
    if (samples <= 16) {
        bits.low = whole(1u) << i;
        return bits;
    }
    whole bit = whole(1u) << (i & whole(31u));
    mask is_low = i < whole(32u);
    bits.low = select(is_low, bit, whole(0u));
    bits.high = select(is_low, whole(0u), bit);
    return bits;
}

// Adds a random one of samples 0 to t, or t itself where that is there already; nothing where t is
// not below `all`. What the choice leaves of `random`, 24 bits, serves another: t + 1 choices take
// log2(t + 1) bits.
SHEER_FN SampleBits with_one_more(SampleBits bits, SHEER_INOUT(whole) random, whole t, whole all,
                                  int samples)
{
    whole product = random * (t + whole(1u));  // below 2^31
    random = product & whole(0xffffffu);
    SampleBits at_r = sample_bit(product >> 24, samples);
    SampleBits at_t = sample_bit(t, samples);
    mask is_new = ((bits.low & at_r.low) | (bits.high & at_r.high)) == whole(0u);
    whole low = select(is_new, at_r.low, at_t.low);
    whole high = select(is_new, at_r.high, at_t.high);
    mask wanted = t < all;
    bits.low = bits.low | zero_unless(wanted, low);
    bits.high = bits.high | zero_unless(wanted, high);
    return bits;
}

// Every sample for itself, with probability `opacity`. A number of the sequence serves two samples,
// 16 bits each; the threshold is rounded at random to as many, so that none is favoured.
SHEER_FN SampleBits naive_mask(whole seed, real opacity, int samples)
{
    SampleBits bits;
    bits.low = whole(0u);
    bits.high = whole(0u);
    whole threshold = rounded_at_random(opacity * real(65536.0f), next_random_real(seed));
    whole bit = whole(1u);
    for (int i = 0; i < samples; i += 2) {
        whole random = next_hash(seed);
        whole pair = zero_unless((random & whole(0xffffu)) < threshold, bit);
        bit = bit + bit;
        pair = pair | zero_unless((random >> 16) < threshold, bit);
        bit = bit + bit;
        if (i < 32) {
            bits.low = bits.low | pair;
        } else {
            bits.high = bits.high | pair;
        }
        if (i == 30) bit = whole(1u);
    }
    return bits;
}

// `taken` of samples 0 to all - 1, every choice alike; `all` is `samples` at most. What is beyond
// them means nothing.
//
// A sample for each of R numbers: with t from S - R on, a random one of 0 to t, or t itself where
// that is taken already. Floyd, in Bentley. Programming Pearls: A Sample of Brilliance. CACM 30(9),
// 1987. Where R is more than half of S, the S - R that are left out are chosen instead. `most`: no
// less than the smaller of these two numbers.
SHEER_FN SampleBits chosen_samples(SHEER_INOUT(whole) seed, whole taken, whole all, int most,
                                   int samples)
{
    whole left_out = all - taken;
    mask inverted = left_out < taken;
    whole chosen = select(inverted, left_out, taken);
    SampleBits bits;
    bits.low = whole(0u);
    bits.high = whole(0u);
    whole t = all - chosen;
    for (int i = 0; i < most; i += 2) {
        whole random = next_random(seed);
        bits = with_one_more(bits, random, t, all, samples);
        bits = with_one_more(bits, random, t + whole(1u), all, samples);
        t = t + whole(2u);
    }
    whole flip = zero_unless(inverted, whole(0xffffffffu));
    bits.low = bits.low ^ flip;
    bits.high = bits.high ^ flip;
    return bits;
}

// R of S samples, R = floor(opacity S + xi), xi in [0, 1). `most` as above, for any xi; S / 2
// serves all opacities.
SHEER_FN SampleBits stratified_mask_of_most(whole seed, real xi, real opacity, int most,
                                            int samples)
{
    whole all = whole(samples);
    whole taken = rounded_at_random(opacity * to_real(all), xi);
    return chosen_samples(seed, taken, all, most, samples);
}
SHEER_FN SampleBits stratified_mask(whole seed, real xi, real opacity, int samples)
{
    return stratified_mask_of_most(seed, xi, opacity, samples / 2, samples);
}

// xi that is dithered across a tile: for one identity seed the 64 pixels of an aligned square of 8
// x 8 have one of each 64th of [0, 1), in the order of Bayer's matrix (An Optimum Method for
// Two-Level Rendition of Continuous-Tone Pictures. ICC 1973), shifted for each identity so that
// layers do not know of one another.
SHEER_FN real dithered_xi(whole x, whole y, whole identity, SHEER_INOUT(whole) seed)
{
    whole q = x ^ y;
    whole place = ((q & whole(1u)) << 5) | ((y & whole(1u)) << 4) | ((q & whole(2u)) << 2) |
                  ((y & whole(2u)) << 1) | ((q & whole(4u)) >> 1) | ((y & whole(4u)) >> 2);
    whole within = next_random(seed) >> 6;
    whole shift = hash_whole(identity + whole(0x9e3779b9u)) >> 8;
    whole sum = ((place << 18) + within + shift) & whole(0xffffffu);
    return to_real(sum) * real(5.9604644775390625e-8f);  // 2^-24
}

// The samples of one pass among those of several: `samples` from `first` on.
SHEER_FN SampleBits sample_part(SampleBits bits, int first, int samples)
{
    if (first >= 32) {
        bits.low = bits.high >> (first - 32);
    } else if (first > 0) {
        bits.low = (bits.low >> first) | (bits.high << (32 - first));
        bits.high = bits.high >> first;
    }
    if (samples < 32) bits.low = bits.low & whole((1u << samples) - 1u);
    return bits;
}

// Sample i of `bits` for the i-th of the samples that are `open`.
SHEER_FN SampleBits deposited(SampleBits bits, SampleBits open, int samples)
{
    SampleBits result;
    result.low = whole(0u);
    result.high = whole(0u);
    for (int i = 0; i < samples; ++i) {
        whole at = whole(1u) << (i & 31);
        mask is_open = (((i < 32) ? open.low : open.high) & at) == at;
        whole there = zero_unless((bits.low & whole(1u)) == whole(1u), at);
        there = zero_unless(is_open, there);
        if (i < 32) {
            result.low = result.low | there;
        } else {
            result.high = result.high | there;
        }
        whole carried = (bits.low >> 1) | (bits.high << 31);
        bits.low = select(is_open, carried, bits.low);
        bits.high = select(is_open, bits.high >> 1, bits.high);
    }
    return result;
}

// The depth test before the number of samples is drawn: of the n that are open, floor(opacity n +
// xi). The masks that Laine and Karras compare theirs with (Stratified Sampling for Stochastic
// Transparency. EGSR 2011, section 4). Depends on the order of the fragments, in its noise alone.
SHEER_FN SampleBits stratified_mask_of_open(whole seed, real xi, real opacity, SampleBits open,
                                            whole count, int samples)
{
    whole taken = rounded_at_random(opacity * to_real(count), xi);
    return deposited(chosen_samples(seed, taken, count, samples / 2, samples), open, samples);
}

// The paper's table: masks made beforehand, 2047 (columns) for each of the opacities 0, 1 / 1000,
// ..., 1 (rows). It costs a look-up a fragment, and rounds the opacity: off by 1 / 2000 at most.
SHEER_FN int mask_table_size()
{
    return 2047 * 1001;
}

// What the table has there: R of S samples, xi one of as many equal parts of [0, 1) as columns.
SHEER_FN SampleBits mask_of_table(whole row, whole column, int samples)
{
    real opacity = to_real(row) / real(1000.0f);
    real xi = (to_real(column) + real(0.5f)) / real(2047.0f);
    return stratified_mask(hash_whole(row * whole(2047u) + column + whole(1u)), xi, opacity,
                           samples);
}

// Where a fragment's mask is in the table, row by row.
SHEER_FN whole mask_table_index(whole seed, real opacity)
{
    whole row = to_whole(opacity * real(1000.0f) + real(0.5f));
    whole random = next_hash(seed) >> 16;
    return row * whole(2047u) + ((random * whole(2047u)) >> 16);
}
