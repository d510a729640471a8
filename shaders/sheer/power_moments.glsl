// From a measure's power moments to what bounds are read from: Jacobi's recurrence.
// Gautschi. Orthogonal Polynomials: Computation and Approximation. 2004, section 2.1.7.
//
// The measure is that of optical depth over depth z in [-1, 1]: fragment i has the mass d_i at z_i.
// Its sums are 2 count + 1:  sum of d_i z_i^j, j = 0 to 2 count. Polynomials that are orthogonal
// under it obey
//   p_k+1(z) = (z - a_k) p_k(z) - b_k p_k-1(z),   p_0 = 1,
// and a_k, b_k, as many as there are sums, say the same as these do, with digits that do not
// cancel: b_k > 0 wherever there are more than k fragments. Moments of few fragments lie at the
// limit of what is a measure at all, where rounding leads out of it. So they are mixed with those
// of a measure that is far from it, 1 part in many. Muenstermann, Krumpen, Klein and Peters.
// Moment-Based Order-Independent Transparency. I3D 2018, section 3.4.
//
// All this is to be done once a pixel, and `real` should be a double here: b_k are differences of
// nearly equal numbers, down to 1e-7 of them. The sums too should be exact to more than a float's
// digits; then what is read from floats is right to 1e-4 wherever layers are a tenth apart.
// Needs prelude.glsl.

// Of `count` 4 at most; what is beyond 2 count means nothing.
struct PowerMoments {
    real m[9];  // m[0] becomes 1
};

struct MomentBias {
    real amount;
    real even[5];  // moments 0, 2, .. of the measure that is mixed in; the odd ones are 0
};

SHEER_FN PowerMoments biased_moments(PowerMoments m, MomentBias bias, int count)
{
    real keeps = real(1.0) - bias.amount;
    m.m[0] = real(1.0);  // even of no fragments at all
    for (int k = 1; k <= count; ++k) {
        m.m[2 * k - 1] = keeps * m.m[2 * k - 1];
        m.m[2 * k] = keeps * m.m[2 * k] + bias.amount * bias.even[k];
    }
    return m;
}

struct Recurrence {
    real a[4];
    real b[5];  // b[0] means nothing
};

// Chebyshev's algorithm. `least` keeps b_k above 0 where rounding does not.
SHEER_FN Recurrence recurrence_of(PowerMoments m, int count, real least)
{
    Recurrence r;
    real before[9];  // the integrals of p_k-1(z) z^l
    real here[9];    // of p_k(z) z^l
    for (int l = 0; l <= 2 * count; ++l) {
        before[l] = real(0.0);
        here[l] = m.m[l];
    }
    r.a[0] = m.m[1];
    r.b[0] = real(0.0);
    for (int k = 1; k <= count; ++k) {
        real next[9];
        for (int l = k; l <= 2 * count - k; ++l) {
            next[l] = (here[l + 1] - r.a[k - 1] * here[l]) - r.b[k - 1] * before[l];
        }
        next[k] = max(next[k], least * here[k - 1]);
        r.b[k] = next[k] / here[k - 1];
        if (k < count) r.a[k] = next[k + 1] / next[k] - here[k] / here[k - 1];
        for (int l = k; l <= 2 * count - k; ++l) {
            before[l] = here[l];
            here[l] = next[l];
        }
    }
    return r;
}
