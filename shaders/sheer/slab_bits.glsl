// Coverage masks of up to 128 bits, for stochastic layered alpha blending.
//
// A mask has floor(opacity b + xi) of its b bits, every choice alike. Up to 64 bits it is the very
// mask with which stochastic transparency chooses as many samples (stochastic_masks.glsl).
// Needs prelude.glsl, bits.glsl, random.glsl, stochastic_masks.glsl.

// Bit i is in the word i / 32.
struct SlabBits {
    whole a;
    whole b;
    whole c;
    whole d;
};

SHEER_FN SlabBits slab_no_bits()
{
    SlabBits bits;
    bits.a = whole(0u);
    bits.b = whole(0u);
    bits.c = whole(0u);
    bits.d = whole(0u);
    return bits;
}

// The first `count` bits of a word, of which there may be more or fewer than 32.
SHEER_FN whole slab_first_bits(int count)
{
    if (count <= 0) return whole(0u);
    if (count >= 32) return whole(0xffffffffu);
    return whole((1u << count) - 1u);
}

SHEER_FN SlabBits slab_all_bits(int count)
{
    SlabBits bits;
    bits.a = slab_first_bits(count);
    bits.b = slab_first_bits(count - 32);
    bits.c = slab_first_bits(count - 64);
    bits.d = slab_first_bits(count - 96);
    return bits;
}

SHEER_FN SlabBits slab_union(SlabBits x, SlabBits y)
{
    x.a = x.a | y.a;
    x.b = x.b | y.b;
    x.c = x.c | y.c;
    x.d = x.d | y.d;
    return x;
}

SHEER_FN SlabBits slab_common(SlabBits x, SlabBits y)
{
    x.a = x.a & y.a;
    x.b = x.b & y.b;
    x.c = x.c & y.c;
    x.d = x.d & y.d;
    return x;
}

// Those of x that y does not have.
SHEER_FN SlabBits slab_without(SlabBits x, SlabBits y)
{
    SlabBits both = slab_common(x, y);
    x.a = x.a ^ both.a;
    x.b = x.b ^ both.b;
    x.c = x.c ^ both.c;
    x.d = x.d ^ both.d;
    return x;
}

SHEER_FN SlabBits slab_bits_if(mask m, SlabBits x)
{
    x.a = zero_unless(m, x.a);
    x.b = zero_unless(m, x.b);
    x.c = zero_unless(m, x.c);
    x.d = zero_unless(m, x.d);
    return x;
}

SHEER_FN SlabBits slab_select_bits(mask m, SlabBits x, SlabBits y)
{
    x.a = select(m, x.a, y.a);
    x.b = select(m, x.b, y.b);
    x.c = select(m, x.c, y.c);
    x.d = select(m, x.d, y.d);
    return x;
}

SHEER_FN mask slab_any(SlabBits x)
{
    return !(((x.a | x.b) | (x.c | x.d)) == whole(0u));
}

SHEER_FN whole slab_count(SlabBits x)
{
    return (bit_count(x.a) + bit_count(x.b)) + (bit_count(x.c) + bit_count(x.d));
}

// Bit i alone; none from 128 on.
SHEER_FN SlabBits slab_bit(whole i)
{
    whole bit = whole(1u) << (i & whole(31u));
    whole word = i >> 5;
    SlabBits bits;
    bits.a = zero_unless(word == whole(0u), bit);
    bits.b = zero_unless(word == whole(1u), bit);
    bits.c = zero_unless(word == whole(2u), bit);
    bits.d = zero_unless(word == whole(3u), bit);
    return bits;
}

// As `with_one_more`: adds a random one of bits 0 to t, or t itself where that is there already;
// nothing where t is not below `all`. What the choice leaves of `random`, 24 bits, serves another.
SHEER_FN SlabBits slab_with_one_more(SlabBits bits, SHEER_INOUT(whole) random, whole t, whole all)
{
    whole product = random * (t + whole(1u));  // below 2^31 where t is below 128
    random = product & whole(0xffffffu);
    SlabBits at_r = slab_bit(product >> 24);
    mask is_new = !slab_any(slab_common(bits, at_r));
    SlabBits more = slab_select_bits(is_new, at_r, slab_bit(t));
    return slab_union(bits, slab_bits_if(t < all, more));
}

// As `chosen_samples`: `taken` of bits 0 to b - 1, every choice alike, for up to 128.
SHEER_FN SlabBits slab_chosen_bits(SHEER_INOUT(whole) seed, whole taken, int b)
{
    whole all = whole(b);
    whole left_out = all - taken;
    mask inverted = left_out < taken;
    whole chosen = select(inverted, left_out, taken);
    SlabBits bits = slab_no_bits();
    whole t = all - chosen;
    for (int i = 0; i < b / 2; i += 2) {
        whole random = next_random(seed);
        bits = slab_with_one_more(bits, random, t, all);
        bits = slab_with_one_more(bits, random, t + whole(1u), all);
        t = t + whole(2u);
    }
    return slab_select_bits(inverted, slab_without(slab_all_bits(b), bits), bits);
}

// R of b bits, R = floor(opacity b + xi), xi in [0, 1); b is 128 at most.
SHEER_FN SlabBits slab_mask(whole seed, real xi, real opacity, int b)
{
    if (b > 64) {
        whole taken = rounded_at_random(opacity * to_real(whole(b)), xi);
        return slab_chosen_bits(seed, taken, b);
    }
    SampleBits samples = stratified_mask(seed, xi, opacity, b);
    SlabBits bits = slab_no_bits();
    bits.a = samples.low;
    bits.b = samples.high;
    return slab_common(bits, slab_all_bits(b));
}

// A pixel's samples have masks of their own. From the fragment's seed this makes the seed of one
// sample, and xi: those of a pixel's S samples are 1 / S apart, so that their masks together have
// floor(opacity b S + xi) bits or the next, and `apart` is 2^24 / S. Sample 0 has what stochastic
// transparency takes for the pixel.
SHEER_FN real slab_xi(SHEER_INOUT(whole) seed, whole sample_number, whole apart)
{
    whole of_pixel = next_random(seed) + sample_number * apart;
    seed = seed ^ hash_whole(sample_number);
    return to_real(of_pixel & whole(0xffffffu)) * real(5.9604644775390625e-8f);  // 2^-24
}

// Of a fragment at one sample.
SHEER_FN SlabBits slab_random_mask(whole seed, whole sample_number, whole apart, real opacity,
                                   int b)
{
    real xi = slab_xi(seed, sample_number, apart);
    return slab_mask(seed, xi, opacity, b);
}
