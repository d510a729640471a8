// Weighted blended order-independent transparency.
// McGuire and Bavoil. Weighted Blended Order-Independent Transparency. JCGT 2(2), 2013.
//
// An average whose weights fall with distance, and the exact transmittance:
//   C = sum(w a c) / sum(w a) (1 - T) + T B,   T = product of (1 - a).
// Exact for one fragment and for fragments of one colour. Five sums and products.
// Needs prelude.glsl, over.glsl.

// The weight of equation 7, 8, 9 or 10, or 1 for `equation` 0. `z`: distance from the eye along the
// axis of view, the paper's in [0.1, 500]; `d`: the same as a depth buffer has it, in [0, 1], for
// equation 10 alone. The paper multiplies each by the opacity, here as there.
SHEER_FN real wboit_weight(int equation, real z, real d, real opacity)
{
    if (equation == 0) return real(1.0f);
    real w = real(0.0f);
    real x = z * real(0.005f);  // z / 200
    real x2 = x * x;
    if (equation == 7) {
        real near = z * real(0.2f);  // z / 5
        w = real(10.0f) / (real(1e-5f) + near * near + x2 * x2 * x2);
    } else if (equation == 8) {
        real near = z * real(0.1f);
        w = real(10.0f) / (real(1e-5f) + near * near * near + x2 * x2 * x2);
    } else if (equation == 9) {
        w = real(0.03f) / (real(1e-5f) + x2 * x2);
    } else {
        real e = real(1.0f) - d;
        w = real(3e3f) * (e * e * e);
    }
    return opacity * max(real(1e-2f), min(real(3e3f), w));
}

struct WboitStore {
    real3 color;         // sum of w a c
    real weight;         // sum of w a
    real transmittance;  // product of 1 - a
};

SHEER_FN WboitStore wboit_clear()
{
    WboitStore s;
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    s.weight = real(0.0f);
    s.transmittance = real(1.0f);
    return s;
}

SHEER_FN WboitStore wboit_insert(WboitStore s, mask covered, real3 straight_color, real opacity,
                                 real weight)
{
    real alpha = select(covered, opacity, real(0.0f));
    real amount = weight * alpha;
    s.color = s.color + amount * straight_color;
    s.weight = s.weight + amount;
    s.transmittance = s.transmittance * (real(1.0f) - alpha);
    return s;
}

SHEER_FN WboitStore wboit_merge(WboitStore a, WboitStore b)
{
    a.color = a.color + b.color;
    a.weight = a.weight + b.weight;
    a.transmittance = a.transmittance * b.transmittance;
    return a;
}

// The paper divides by max(sum, 1e-5) for the sake of empty pixels, which darkens faint ones; here
// only empty ones are kept from the division.
SHEER_FN real3 wboit_resolve(WboitStore s, real3 backdrop)
{
    real divisor = select(s.weight > real(0.0f), s.weight, real(1.0f));
    real weight = (real(1.0f) - s.transmittance) / divisor;
    return over(weight * s.color, s.transmittance, backdrop);
}
