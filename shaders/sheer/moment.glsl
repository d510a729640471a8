// Moment transparency: transmittance from four power moments of optical depth over depth.
// Sharpe. Moment Transparency. HPG 2018. The bounds: Peters and Klein. Moment Shadow Mapping. I3D
// 2015, by other formulas, which don't fail at a fragment's own depth.
//
// What power_moments.glsl makes of a pixel's sums (a: a_0, a_1; b: b_1, b_2) is read here by each
// fragment of the pixel. Exact at two fragments' depths but for the bias, and in between from a gap
// of a few tenths on; more become approximate.
// Needs prelude.glsl, exponential.glsl.

// The measure of optical depth, as far as four moments tell.
struct MomentCurve {
    real mean;
    real inverse_deviation;
    real skewness;   // of the measure in y = (z - mean) / deviation
    real sharpness;  // b_1 / b_2; the kurtosis is 1 + skewness^2 + 1 / sharpness
    real depth;      // optical, of all fragments
};

// `deviation`: the root of b_1, given as it is taken of a double.
SHEER_FN MomentCurve moment_curve(real a0, real a1, real b1, real b2, real deviation, real depth)
{
    MomentCurve curve;
    curve.mean = a0;
    curve.inverse_deviation = real(1.0f) / deviation;
    curve.skewness = (a1 - a0) / deviation;
    curve.sharpness = b1 / b2;
    curve.depth = depth;
    return curve;
}

// The largest mass that may lie at y: 1 / K(y, y), K(x, y) = 1 + x y + sharpness q(x) q(y).
SHEER_FN real moment_mass(MomentCurve c, real y, real q)
{
    return real(1.0f) / (real(1.0f) + y * y + c.sharpness * (q * q));
}

SHEER_FN real moment_quadratic(MomentCurve c, real y)
{
    return (y * y - c.skewness * y) - real(1.0f);
}

// Never 0, for divisions.
SHEER_FN real moment_divisor(real x)
{
    real least = real(1e-12f);
    return select(max(x, real(0.0f) - x) < least, least, x);
}

// Part of the optical depth that lies before depth z: of all measures with these moments the least,
// and `overestimation` times what the most adds to it.
//
// There is one measure that has as much mass at z as can be: three points, of which the other two
// are the roots of K(y, x). Each point's mass is the largest that may be there. The sum of the
// three, 1 but for rounding, divides: so the result is in [0, 1] in any case.
SHEER_FN real moment_fraction(MomentCurve c, real z, real overestimation)
{
    real y = (z - c.mean) * c.inverse_deviation;
    real q = moment_quadratic(c, y);
    real k2 = c.sharpness * q;  // K(y, x) = k0 + k1 x + k2 x^2
    real k1 = y - k2 * c.skewness;
    real k0 = real(1.0f) - k2;
    // The roots are real, and the larger term's sign saves the smaller root's digits.
    real root = sqrt(max(k1 * k1 - real(4.0f) * (k2 * k0), real(0.0f)));
    root = select(k1 < real(0.0f), real(0.0f) - root, root);
    real sum = moment_divisor(real(-0.5f) * (k1 + root));
    real x1 = sum / moment_divisor(k2);
    real x2 = k0 / sum;
    real here = moment_mass(c, y, q);
    real mass1 = moment_mass(c, x1, moment_quadratic(c, x1));
    real mass2 = moment_mass(c, x2, moment_quadratic(c, x2));
    real before = select(x1 < y, mass1, real(0.0f)) + select(x2 < y, mass2, real(0.0f));
    return (before + overestimation * here) / ((here + mass1) + mass2);
}

SHEER_FN real moment_transmittance(MomentCurve c, real z, real overestimation)
{
    return exp_of(real(0.0f) - c.depth * moment_fraction(c, z, overestimation));
}

// Overestimation makes up for what is lost of many fragments, and darkens where there are two, of
// which nothing is lost: b_2 of two fragments is the bias and no more. An experiment: as much of it
// as b_1 b_2 exceeds the bias's share of it, `least`.
SHEER_FN real moment_adaptive(MomentCurve c, real least)
{
    real deviation = real(1.0f) / c.inverse_deviation;
    real variance = deviation * deviation;
    real excess = variance * variance / c.sharpness;
    real bias = real(32.0f) * least;
    return real(0.25f) * (excess / (excess + bias));
}
