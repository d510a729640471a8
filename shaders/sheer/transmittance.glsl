// What methods share that approximate transmittance as a function of depth: T(z), the part of the
// light that gets from depth z to the eye. Wyman. Exploring and Expanding the Continuum of OIT
// Algorithms. HPG 2016. Sharpe. Moment Transparency. HPG 2018, sections 3.2 and 3.3.
//
// A pass over the fragments in any order adds up what their function is made from, with each
// fragment's optical depth (exponential.glsl) as its weight. Another adds up their colours, each as
// far as the function lets it be seen; the sum is scaled to the total alpha:
//   C = sum(T(z) a c) / sum(T(z) a) (1 - T) + T B,   T = e^(-sum of optical depths).
// Exact for one fragment. A fragment with a = 1 has no optical depth: the nearest of them takes the
// backdrop's place, and what is behind it is left out of all sums.
// Needs prelude.glsl, exponential.glsl, over.glsl.

// A depth, as -1 / distance or (`is_distance`) the distance itself, in [-1, 1], which the shape of
// the function and the rounding of its sums want: logarithmic in perspective, with which all scales
// are as precise, else linear. `from`: what is to become -1, as ln(distance) or the distance.
SHEER_FN real warped_depth(bool is_distance, real depth, real from, real scale)
{
    real place = depth;
    if (!is_distance) place = real(0.0f) - log_of(max(real(0.0f) - depth, real(1e-30f)));
    return min(max((place - from) * scale - real(1.0f), real(-1.0f)), real(1.0f));
}

// How much a fragment counts. T is 2^-30 at least, so that where all is dark something is seen.
SHEER_FN real visible_alpha(real transmittance, real opacity)
{
    return opacity * max(transmittance, real(9.3132257e-10f));
}

// `color` and `weight` are the sums, `transmittance` that of all fragments.
SHEER_FN real3 visible_resolve(real3 color, real weight, real transmittance, real3 backdrop)
{
    real divisor = select(weight > real(0.0f), weight, real(1.0f));
    real part = (real(1.0f) - transmittance) / divisor;
    return over(part * color, transmittance, backdrop);
}
