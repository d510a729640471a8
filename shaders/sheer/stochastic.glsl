// Stochastic transparency, basic.
// Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. I3D 2010, sections 3.1 and 4.
//
// Each fragment takes a random part of its samples, in proportion to its opacity, and at each of
// them the nearest fragment stays: unbiased, with an error that falls as samples grow.
// Depth, id and colour for each sample.
// Needs prelude.glsl, random.glsl.

// A fragment's random samples: sample i in bit i, from 32 on in bit i - 32 of `high`.
struct SampleBits {
    whole low;
    whole high;
};

// Every sample for itself, with probability `opacity`.
SHEER_FN SampleBits naive_mask(whole seed, real opacity, int samples)
{
    SampleBits bits;
    bits.low = whole(0u);
    bits.high = whole(0u);
    whole bit = whole(1u);
    for (int i = 0; i < samples; ++i) {
        mask taken = next_random_real(seed) < opacity;
        if (i == 32) bit = whole(1u);
        if (i < 32) {
            bits.low = bits.low | select(taken, bit, whole(0u));
        } else {
            bits.high = bits.high | select(taken, bit, whole(0u));
        }
        bit = bit + bit;
    }
    return bits;
}

// R = floor(opacity S + xi), xi in [0, 1). opacity S, which is exact, is cut in two first: a sum
// with xi would be rounded.
SHEER_FN whole stratified_count(real xi, real opacity, int samples)
{
    real expected = opacity * to_real(whole(samples));
    whole least = to_whole(expected);
    mask one_more = xi < expected - to_real(least);
    return least + select(one_more, whole(1u), whole(0u));
}

// R samples, every choice of R among S alike: each sample in turn is taken with probability
// (still to take) / (still to come). Knuth. The Art of Computer Programming 2, 3.4.2, algorithm S.
SHEER_FN SampleBits stratified_mask(whole seed, real opacity, int samples)
{
    SampleBits bits;
    bits.low = whole(0u);
    bits.high = whole(0u);
    whole to_take = stratified_count(next_random_real(seed), opacity, samples);
    whole bit = whole(1u);
    for (int i = 0; i < samples; ++i) {
        // 24 bits times at most 64, against at most 64 times 2^24.
        whole scaled = next_random(seed) * whole(samples - i);
        mask taken = scaled < (to_take << 24);
        to_take = to_take - select(taken, whole(1u), whole(0u));
        if (i == 32) bit = whole(1u);
        if (i < 32) {
            bits.low = bits.low | select(taken, bit, whole(0u));
        } else {
            bits.high = bits.high | select(taken, bit, whole(0u));
        }
        bit = bit + bit;
    }
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
    mask wins = taken && nearer;
    s.depth = select(wins, f.depth, s.depth);
    s.id = select(wins, f.id, s.id);
    s.color = select(wins, f.color, s.color);
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
