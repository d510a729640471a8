// Wavelet transparency: optical depth as a series of Haar's wavelets over depth.
// Aizenshtein, Smal and McGuire. Wavelet Transparency. 2022.
//
// A(z), the optical depth before z, is kept as its mean in each of n = 2^(rank + 1) cells between
// depths -1 and 1, by a sum of steps: wavelets 2 i + 1 and 2 i + 2 are on the nearer and the
// farther half of wavelet i, and coefficient n - 1 is the mean of all. A fragment touches rank + 2
// of them. Between the cells A is read as a line, so that a layer's step is a ramp, a cell wide.
// Needs prelude.glsl, exponential.glsl.

// The place from 0 to 1, less the last cell, which stays behind all fragments.
SHEER_FN real wavelet_place(real place, real cells)
{
    return (real(0.5f) * place + real(0.5f)) * ((cells - real(1.0f)) / cells);
}

SHEER_FN whole wavelet_cell(real d, real cells)
{
    return to_whole(d * cells);  // cells - 1 at most
}

// What a fragment with optical depth 1 at d adds to the coefficient of the wavelet that is `up`
// steps of the tree above its cell, 1 to rank + 1: the amplitude times the distance from the nearer
// end of the wavelet. `scale` is 2^p, of the wavelet's length 2^-p, and `root` its root.
SHEER_FN real wavelet_addend(real d, whole cell, int up, real scale, real root)
{
    whole wavelet = cell >> up;  // from the left among those of its length
    mask is_left = ((cell >> (up - 1)) & whole(1u)) == whole(0u);
    real begin = to_real(wavelet) / scale;
    real end = (to_real(wavelet) + real(1.0f)) / scale;
    return root * select(is_left, d - begin, end - d);
}

// Optical depth at d, between the means of its cell and the one before.
SHEER_FN real wavelet_transmittance(real d, whole cell, real cells, real before, real here)
{
    real part = d * cells - to_real(cell);
    return exp_of(min(real(0.0f) - (before + part * (here - before)), real(0.0f)));
}
