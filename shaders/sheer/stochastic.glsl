// Stochastic transparency, basic.
// Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. I3D 2010, sections 3.1 and 4.
//
// Each fragment takes a random part of its samples, in proportion to its opacity, and at each of
// them the nearest fragment stays: unbiased, with an error that falls as samples grow.
// Depth, id and colour for each sample.
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

// Sample i, which may be as many as 1.5 times `samples`: what is beyond them means nothing.
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

// Adds a random one of samples 0 to t, or t itself where that is there already; nothing where there
// is no sample t. What the choice leaves of `random`, 24 bits, serves another: t + 1 choices take
// log2(t + 1) bits.
SHEER_FN SampleBits with_one_more(SampleBits bits, SHEER_INOUT(whole) random, whole t, int samples)
{
    whole product = random * (t + whole(1u));  // below 2^31
    random = product & whole(0xffffffu);
    SampleBits at_r = sample_bit(product >> 24, samples);
    SampleBits at_t = sample_bit(t, samples);
    mask is_new = ((bits.low & at_r.low) | (bits.high & at_r.high)) == whole(0u);
    whole low = select(is_new, at_r.low, at_t.low);
    whole high = select(is_new, at_r.high, at_t.high);
    mask wanted = t < whole(samples);
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

// R of S samples, every choice alike, R = floor(opacity S + xi) with a random xi in [0, 1).
//
// A sample for each of R numbers: with t from S - R on, a random one of 0 to t, or t itself where
// that is taken already. Floyd, in Bentley. Programming Pearls: A Sample of Brilliance. CACM 30(9),
// 1987. Where R is more than half of S, the S - R that are left out are chosen instead.
SHEER_FN SampleBits stratified_mask(whole seed, real opacity, int samples)
{
    whole all = whole(samples);
    whole taken = rounded_at_random(opacity * to_real(all), next_random_real(seed));
    whole left_out = all - taken;
    mask inverted = left_out < taken;
    whole chosen = select(inverted, left_out, taken);
    SampleBits bits;
    bits.low = whole(0u);
    bits.high = whole(0u);
    whole t = all - chosen;
    for (int i = 0; i < samples / 2; i += 2) {
        whole random = next_random(seed);
        bits = with_one_more(bits, random, t, samples);
        bits = with_one_more(bits, random, t + whole(1u), samples);
        t = t + whole(2u);
    }
    whole flip = zero_unless(inverted, whole(0xffffffffu));
    bits.low = bits.low ^ flip;
    bits.high = bits.high ^ flip;
    return bits;
}

struct StochasticStore {
    real depth;   // of the nearest fragment; beyond any where there is none
    whole id;     // below 2^31; breaks ties: the smaller is in front
    real3 color;  // straight
};

SHEER_FN StochasticStore stochastic_clear(real beyond_any)
{
    StochasticStore s;
    s.depth = beyond_any;
    s.id = whole(0x7fffffffu);
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    return s;
}

// The nearer of the two; `taken`: whether the fragment's mask has this sample.
SHEER_FN StochasticStore stochastic_insert(StochasticStore s, mask taken, StochasticStore f)
{
    mask nearer = f.depth < s.depth || (f.depth == s.depth && f.id < s.id);
    // Not "wins": where s lies in memory, what is kept can then be an instruction's own operand.
    mask stays = !(taken && nearer);
    s.depth = select(stays, s.depth, f.depth);
    s.id = select(stays, s.id, f.id);
    s.color = select(stays, s.color, f.color);
    return s;
}

SHEER_FN real3 stochastic_resolve(StochasticStore s, real beyond_any, real3 backdrop)
{
    return select(s.depth < beyond_any, s.color, backdrop);
}

SHEER_FN real stochastic_transmittance(StochasticStore s, real beyond_any)
{
    return select(s.depth < beyond_any, real(0.0f), real(1.0f));
}
