// From trigonometric moments to power moments, which have the same bounds.
// Muenstermann, Krumpen, Klein and Peters. Moment-Based Order-Independent Transparency. I3D 2018,
// section 3.5, by another way than the paper's.
//
// Depth z in [-1, 1] lies on a circle at the angle t = z (pi - zone / 2), but for the zone, which
// is opposite to z = 0. What e^(i j t) up to j = m is on the circle, w^k up to k = 2 m is on the
// line of w = tan(t / 2), with masses that are cos(t / 2)^(2 m) of those of the circle: both are
// linear in sin(t / 2)^k cos(t / 2)^(2 m - k). So all that power_moments.glsl and what follows it
// say of a measure on a line goes for this one.
//
// To be done once a pixel, and `real` should be a double.
// Needs prelude.glsl, power_moments.glsl.

// Of `m` 4 at most.
struct TrigonometricMoments {
    real cosine[5];  // cosine[0] is 1
    real sine[5];    // sine[0] is 0
};

// sin(t / 2) and cos(t / 2) for |t| < pi: Taylor's series, to 1e-11.
struct HalfAngle {
    real sine;
    real cosine;
};
SHEER_FN HalfAngle half_angle(real half_t)
{
    real x2 = half_t * half_t;
    real s = real(1.0);
    real c = real(1.0);
    for (int n = 16; n > 0; n = n - 2) {
        s = real(1.0) - x2 * s / real(n * (n + 1));
        c = real(1.0) - x2 * c / real(n * (n - 1));
    }
    HalfAngle h;
    h.sine = half_t * s;
    h.cosine = c;
    return h;
}

// cos(j t) and sin(j t), the moments of mass 1 at t.
SHEER_FN TrigonometricMoments trigonometric_moments(HalfAngle h, int m)
{
    TrigonometricMoments b;
    b.cosine[0] = real(1.0);
    b.sine[0] = real(0.0);
    b.cosine[1] = h.cosine * h.cosine - h.sine * h.sine;
    b.sine[1] = real(2.0) * (h.sine * h.cosine);
    for (int j = 2; j <= m; ++j) {
        b.cosine[j] = b.cosine[j - 1] * b.cosine[1] - b.sine[j - 1] * b.sine[1];
        b.sine[j] = b.sine[j - 1] * b.cosine[1] + b.cosine[j - 1] * b.sine[1];
    }
    return b;
}

// All points of the circle alike, mixed in as in biased_moments.
SHEER_FN TrigonometricMoments biased_trigonometric(TrigonometricMoments b, int m, real bias)
{
    for (int j = 1; j <= m; ++j) {
        b.cosine[j] = (real(1.0) - bias) * b.cosine[j];
        b.sine[j] = (real(1.0) - bias) * b.sine[j];
    }
    return b;
}

// The integral of sin(t / 2)^k cos(t / 2)^(2 m - k): with x = e^(-i t) the coefficients of
// (1 - x)^k (1 + x)^(2 m - k) say what each moment has to do with it.
SHEER_FN real half_angle_moment(TrigonometricMoments b, int m, int k)
{
    real q[9];  // whole numbers
    for (int i = 0; i <= 2 * m; ++i) q[i] = real(i == 0 ? 1.0 : 0.0);
    for (int factor = 0; factor < 2 * m; ++factor) {
        for (int i = factor + 1; i > 0; --i) {
            if (factor < k) q[i] = q[i] - q[i - 1];
            if (factor >= k) q[i] = q[i] + q[i - 1];
        }
    }
    bool is_even = k % 2 == 0;
    real sum = real(0.0);
    for (int l = m; l > 0; --l) {
        real moment = b.sine[l];
        if (is_even) moment = b.cosine[l];
        sum = sum + (q[m - l] + q[m - l]) * moment;
    }
    if (is_even) sum = sum + q[m];
    real scale = real(k % 4 < 2 ? 1.0 : -1.0);
    for (int i = 0; i < m; ++i) scale = scale * real(0.25);
    return scale * sum;
}

struct LineMoments {
    PowerMoments power;
    real mass;  // of the measure on the line
};
SHEER_FN LineMoments line_moments(TrigonometricMoments b, int m)
{
    LineMoments line;
    line.mass = half_angle_moment(b, m, 0);
    line.power.m[0] = real(1.0);
    for (int k = 1; k <= 2 * m; ++k) {
        line.power.m[k] = half_angle_moment(b, m, k) / line.mass;
    }
    return line;
}
