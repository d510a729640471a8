// Noise that comes with distance: near the eye an alpha test at a half, far away a hashed or random
// one. C. Wyman, M. McGuire. Improved Alpha Testing Using Hashed Sampling. TVCG 25(2), 2019:
// section 7.1, equations 3 to 5.
//
// In an engine: x is the mipmap level that the texture is read at, textureQueryLod(...).x, times
// texture_anisotropy of the texture coordinates' derivatives;
// discard where opacity < faded_threshold(threshold, fade_in(x, 6.0)).
// Needs prelude.glsl.

// How many times as long as wide a pixel is on the texture, 1 to 1e6, by how far texture
// coordinates change in a pixel to the right (dx) and down (dy).
SHEER_FN real texture_anisotropy(real dx_u, real dx_v, real dy_u, real dy_v)
{
    const real one = real(1.0f);
    real x = dx_u * dx_u + dx_v * dx_v;
    real y = dy_u * dy_u + dy_v * dy_v;
    real most = min(max(x, y), real(1e30f));
    real least = max(min(x, y), max(most * real(1e-12f), real(1e-36f)));
    return max(sqrt(most / least), one);
}

// b(x), 0 for an alpha test, 1 for nothing but noise, from `levels` on. With the square of x:
// apparent noise goes with a solid angle.
SHEER_FN real fade_in(real x, real levels)
{
    real part = min(max(x / levels, real(0.0f)), real(1.0f));
    return part * part;
}

SHEER_FN real faded_threshold(real threshold, real b)
{
    const real middle = real(0.5f);
    return middle + (threshold - middle) * b;
}
