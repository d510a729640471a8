// Stochastic layered alpha blending.
// Wyman. Exploring and Expanding the Continuum of OIT Algorithms. HPG 2016.
//
// A sample keeps the nearest of those layers that are seen. Explicit coverage: a layer has a random
// mask of b bits, and is seen where it has a bit that no layer in front of it has. With as many
// layers as bits that is stochastic transparency of b samples. Implicit coverage: a layer hides by
// its opacity, and is seen with the chance of such a mask; with b beyond all bounds, always, which
// makes it a k-buffer that discards the farthest.
//
// The first pass over the fragments, in any order:
//   SlabFront front = slab_no_front();
//   for (int i = 0; i < LAYERS; ++i) front = slab_behind(front, slab_in_front(layers[i], f),
//                                                        layers[i]);
//   if (!slab_shows(KIND, front, f)) f = slab_clear(beyond_any);
//   for (int i = 0; i < LAYERS; ++i) slab_exchange(layers[i], f);
// and what is left in f is forgotten, unless layers in front of it are purged: those, near to far,
// that are no longer seen. To keep the nearest without asking whether they are seen makes stores
// that merge exactly.
//
// Depth based, the second pass adds up all fragments as far as the layers let them be seen, as
// stochastic_depth.glsl does; over the exact total alpha (alpha_correction.glsl). Else layers have
// colours and show themselves. Either may be corrected by total alpha.
//
// How the chance is met: for each fragment a number of hidden bits is drawn up to which it is seen,
// so that P(hidden <= limit) are the paper's formulas. A layer can so be asked again.
// Needs prelude.glsl, bits.glsl, random.glsl, stochastic_masks.glsl, slab_bits.glsl.

struct SlabLayer {
    real depth;     // beyond any where there is none
    whole id;       // below 2^31; breaks ties: the smaller is in front
    SlabBits bits;  // explicit coverage
    real limit;     // implicit coverage: seen behind what hides less than this
    real opacity;   // the same
    real3 color;    // straight; if not depth based
};

SHEER_FN SlabLayer slab_clear(real beyond_any)
{
    SlabLayer s;
    s.depth = beyond_any;
    s.id = whole(0x7fffffffu);
    s.bits = slab_no_bits();
    s.limit = real(0.0f);
    s.opacity = real(0.0f);
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    return s;
}

SHEER_FN mask slab_in_front(SlabLayer a, SlabLayer b)
{
    return a.depth < b.depth || (a.depth == b.depth && a.id < b.id);
}

SHEER_FN SlabLayer slab_select(mask m, SlabLayer a, SlabLayer b)
{
    SlabLayer s;
    s.depth = select(m, a.depth, b.depth);
    s.id = select(m, a.id, b.id);
    s.bits = slab_select_bits(m, a.bits, b.bits);
    s.limit = select(m, a.limit, b.limit);
    s.opacity = select(m, a.opacity, b.opacity);
    s.color = select(m, a.color, b.color);
    return s;
}

// The nearer stays, the farther goes on.
SHEER_FN void slab_exchange(SHEER_INOUT(SlabLayer) kept, SHEER_INOUT(SlabLayer) f)
{
    mask stays = !slab_in_front(f, kept);
    SlabLayer nearer = slab_select(stays, kept, f);
    f = slab_select(stays, f, kept);
    kept = nearer;
}

// What the layers in front of something hide.
struct SlabFront {
    SlabBits bits;
    real transmittance;
};

SHEER_FN SlabFront slab_no_front()
{
    SlabFront front;
    front.bits = slab_no_bits();
    front.transmittance = real(1.0f);
    return front;
}

// The same and one layer more, if it is in front.
SHEER_FN SlabFront slab_behind(SlabFront front, mask in_front, SlabLayer layer)
{
    front.bits = slab_union(front.bits, slab_bits_if(in_front, layer.bits));
    real through = front.transmittance * (real(1.0f) - layer.opacity);
    front.transmittance = select(in_front, through, front.transmittance);
    return front;
}

// Whether a layer is seen.
SHEER_FN mask slab_shows(bool is_explicit, SlabFront front, SlabLayer f)
{
    if (is_explicit) return slab_any(slab_without(f.bits, front.bits));
    return real(1.0f) - front.transmittance < f.limit;
}

// The part of what is behind that is seen, of b bits.
SHEER_FN real slab_visibility(bool is_explicit, SlabFront front, int b)
{
    if (!is_explicit) return front.transmittance;
    whole left = whole(b) - slab_count(front.bits);
    return to_real(left) / to_real(whole(b));
}

// The part of a pixel that one layer shows, if its colour is kept.
SHEER_FN real slab_part(bool is_explicit, SlabFront front, SlabLayer layer, int b)
{
    if (!is_explicit) return front.transmittance * layer.opacity;
    return to_real(slab_count(slab_without(layer.bits, front.bits))) / to_real(whole(b));
}

// Implicit coverage. The mask that a fragment would have is seen behind one of beta bits with the
// chance 1 - Q(beta). Of stratified bits, of which it has beta_B,
//   Q(beta) = C(beta, beta_B) / C(b, beta_B),   Q(beta) / Q(beta + 1) = 1 - beta_B / (beta + 1),
// of naive ones Q(beta) = (1 - alpha_B)^(b - beta). With `random` in [0, 1) this is the number of
// values of beta below b for which it is seen: as Q grows, those from 0 on.
SHEER_FN real slab_seen_behind(bool stratified, real random, real opacity, real xi, int b)
{
    real taken = to_real(rounded_at_random(opacity * to_real(whole(b)), xi));
    real chance = real(1.0f) - random;
    real hidden = real(1.0f);
    real count = real(0.0f);
    for (int beta = b - 1; beta >= 0; --beta) {
        if (stratified) {
            real next = to_real(whole(beta + 1));
            hidden = hidden * (max(next - taken, real(0.0f)) / next);
        } else {
            hidden = hidden * (real(1.0f) - opacity);
        }
        count = count + select(hidden < chance, real(1.0f), real(0.0f));
    }
    return count;
}

// What hides alpha_A hides floor(alpha_A b + xi) bits, so that on average they are as many as it
// says: fewer than `count` if alpha_A is less than this.
SHEER_FN real slab_limit(real count, real xi, int b)
{
    return max(count - xi, real(0.0f)) / to_real(whole(b));
}

// Of a fragment at one sample, whose seed is as slab_xi has it.
SHEER_FN real slab_random_limit(whole seed, whole sample_number, whole apart, bool stratified,
                                real opacity, int b)
{
    real xi = slab_xi(seed, sample_number, apart);
    real random = next_random_real(seed);
    real count = slab_seen_behind(stratified, random, opacity, xi, b);
    return slab_limit(count, next_random_real(seed), b);
}

// Where bits have no number, or layers wait for the others.
SHEER_FN real slab_no_limit()
{
    return real(2.0f);
}

// Sampling in the order of depth: of the sum of the chances of all fragments, near to far, those
// are kept at which it passes a whole number. This is the chance of one to be seen behind what
// hides alpha_A: the mean over both ways of rounding alpha_A b, and alpha_B b if bits are
// stratified.
SHEER_FN real slab_chance(bool stratified, real alpha_a, real opacity, int b)
{
    real all = to_real(whole(b));
    real beta = to_real(to_whole(alpha_a * all));
    real more = alpha_a * all - beta;
    real taken = to_real(to_whole(opacity * all));
    real one_more = opacity * all - taken;
    real hidden = real(1.0f);          // behind beta bits
    real hidden_by_more = real(1.0f);  // behind beta + 1
    for (int i = 0; i < b; ++i) {
        real at = to_real(whole(i));
        real factor = real(1.0f) - opacity;
        if (stratified) {
            mask is_bit = at < taken;
            real left = all - at;
            hidden = select(is_bit, hidden * (max(beta - at, real(0.0f)) / left), hidden);
            hidden_by_more =
                select(is_bit, hidden_by_more * (max(beta + real(1.0f) - at, real(0.0f)) / left),
                       hidden_by_more);
        } else {
            hidden = select(at < beta, hidden, hidden * factor);
            hidden_by_more =
                select(at < beta + real(1.0f), hidden_by_more, hidden_by_more * factor);
        }
    }
    if (stratified) {
        // Of one bit more; there is none where all are taken.
        real left = max(all - taken, real(1.0f));
        real next = max(beta - taken, real(0.0f)) / left;
        real next_by_more = max(beta + real(1.0f) - taken, real(0.0f)) / left;
        hidden = hidden * (real(1.0f) - one_more * (real(1.0f) - next));
        hidden_by_more = hidden_by_more * (real(1.0f) - one_more * (real(1.0f) - next_by_more));
    }
    return real(1.0f) - (hidden + more * (hidden_by_more - hidden));
}

// Whether the sum of the chances passes a whole number, of which `sum` is what is left.
SHEER_FN mask slab_passes(SHEER_INOUT(real) sum, real chance)
{
    real next = sum + chance;
    mask within = next < real(1.0f);
    sum = select(within, next, next - real(1.0f));
    return !within;
}
