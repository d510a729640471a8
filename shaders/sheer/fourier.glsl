// Fourier opacity maps: optical depth as a Fourier series over depth.
// Jansen and Bavoil. Fourier Opacity Mapping. I3D 2010, here from the eye instead of a light.
//
// Exact at both ends of the range of depths, and for nothing between; thin layers make it ring.
// Needs prelude.glsl, exponential.glsl.

// cos(k t) and sin(k t), k = 0 to `terms` of 7 at most, t = pi (1 + place): once around while depth
// goes from -1 to 1.
struct FourierAngles {
    real cosine[8];
    real sine[8];
};

// Taylor's series of half the angle from place 0 on, place pi / 2.
SHEER_FN FourierAngles fourier_angles(real place, int terms)
{
    real half_t = place * real(1.5707964f);
    real x2 = half_t * half_t;
    real s = real(1.0f);
    real c = real(1.0f);
    for (int n = 16; n > 0; n = n - 2) {
        s = real(1.0f) - x2 * s / real(float(n * (n + 1)));
        c = real(1.0f) - x2 * c / real(float(n * (n - 1)));
    }
    s = half_t * s;
    FourierAngles angles;
    angles.cosine[0] = real(1.0f);
    angles.sine[0] = real(0.0f);
    angles.cosine[1] = s * s - c * c;
    angles.sine[1] = real(-2.0f) * (s * c);
    for (int k = 2; k <= terms; ++k) {
        angles.cosine[k] =
            angles.cosine[k - 1] * angles.cosine[1] - angles.sine[k - 1] * angles.sine[1];
        angles.sine[k] =
            angles.sine[k - 1] * angles.cosine[1] + angles.cosine[k - 1] * angles.sine[1];
    }
    return angles;
}

// What is read of the sums of d cos(k t) and d sin(k t).
struct FourierSeries {
    real depth;      // optical, of all fragments
    real cosine[8];  // sums over pi k
    real sine[8];
};

// Lanczos's factors sin(pi k / n) / (pi k / n), which damp what rings; with `damped` k from 1.
SHEER_FN real fourier_factor(int k, int terms, bool damped)
{
    if (!damped) return real(1.0f);
    if (terms == 3) {
        if (k == 1) return real(0.82699334f);
        if (k == 2) return real(0.41349667f);
        return real(0.0f);
    }
    if (k == 1) return real(0.96676639f);
    if (k == 2) return real(0.87102641f);
    if (k == 3) return real(0.72410145f);
    if (k == 4) return real(0.54307609f);
    if (k == 5) return real(0.34841057f);
    if (k == 6) return real(0.16112773f);
    return real(0.0f);
}

SHEER_FN FourierSeries fourier_series(FourierSeries sums, int terms, bool damped)
{
    for (int k = 1; k <= terms; ++k) {
        real factor = fourier_factor(k, terms, damped);
        real divisor = real(float(k)) * real(3.1415927f);
        sums.cosine[k] = factor * sums.cosine[k] / divisor;
        sums.sine[k] = factor * sums.sine[k] / divisor;
    }
    return sums;
}

// Where the series falls below 0, it is taken for that.
SHEER_FN real fourier_transmittance(FourierSeries series, real place, int terms)
{
    FourierAngles angles = fourier_angles(place, terms);
    real depth = series.depth * (real(0.5f) * place + real(0.5f));
    for (int k = 1; k <= terms; ++k) {
        depth = depth + (series.cosine[k] * angles.sine[k] +
                         series.sine[k] * (real(1.0f) - angles.cosine[k]));
    }
    return exp_of(min(real(0.0f) - depth, real(0.0f)));
}
