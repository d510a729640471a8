// Phenomenological transparency.
// McGuire and Mara. Phenomenological Transparency. TVCG 23(5), 2017.
//
// As weighted blended transparency (wboit.glsl), with a weight of its own, and what is behind is
// seen through each channel by itself, exactly:
//   C = sum(w a c) / sum(w a) (1 - mean T) + T B,   T = product of what each lets through.
// Exact for one fragment, coloured or not, and for fragments of one colour. Seven sums and
// products.
// Needs prelude.glsl.

// `d`: distance as a depth buffer has it, in [0, 1].
SHEER_FN real phenomenological_weight(real d, real opacity)
{
    real x = real(1.0f) - real(0.99f) * d;
    real by_depth = min(max(x * x * x * real(1e4f), real(1e-3f)), real(1.0f));
    return min(max(opacity * by_depth, real(1e-3f)), real(1.5e2f));
}

struct PhenomenologicalStore {
    real3 color;          // sum of w a c
    real weight;          // sum of w a
    real3 transmittance;  // product, of each channel
};

SHEER_FN PhenomenologicalStore phenomenological_clear()
{
    PhenomenologicalStore s;
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    s.weight = real(0.0f);
    s.transmittance = real3(real(1.0f), real(1.0f), real(1.0f));
    return s;
}

// `through`: the parts of red, green and blue that pass, of which 1 - opacity is the mean.
SHEER_FN PhenomenologicalStore phenomenological_insert(PhenomenologicalStore s, mask covered,
                                                       real3 straight_color, real opacity,
                                                       real3 through, real weight)
{
    real amount = select(covered, weight * opacity, real(0.0f));
    s.color = s.color + amount * straight_color;
    s.weight = s.weight + amount;
    s.transmittance = select(covered, s.transmittance * through, s.transmittance);
    return s;
}

SHEER_FN PhenomenologicalStore phenomenological_merge(PhenomenologicalStore a,
                                                      PhenomenologicalStore b)
{
    a.color = a.color + b.color;
    a.weight = a.weight + b.weight;
    a.transmittance = a.transmittance * b.transmittance;
    return a;
}

// The mean over the channels.
SHEER_FN real phenomenological_transmittance(PhenomenologicalStore s)
{
    return (s.transmittance.x + s.transmittance.y + s.transmittance.z) * real(0.33333334f);
}

// What is added is as much as is taken away, on the mean of the channels: each channel's own part
// would give light of the complementary colour to what coloured glass reflects.
SHEER_FN real3 phenomenological_resolve(PhenomenologicalStore s, real3 backdrop)
{
    real divisor = select(s.weight > real(0.0f), s.weight, real(1.0f));
    real part = (real(1.0f) - phenomenological_transmittance(s)) / divisor;
    return part * s.color + s.transmittance * backdrop;
}
