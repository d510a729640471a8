// Logarithms and exponentials from operations that every processor rounds alike, and optical depth.
//
// Within 2 units of the last place but where a comment says less.
// Needs prelude.glsl.

// ln(1 + f) / f for f in [sqrt(1/2) - 1, sqrt(2) - 1]: the series of 2 atanh(t), t = f / (2 + f),
// |t| < 0.172; what is left out is below 2^-28.
SHEER_FN real log_quotient(real f)
{
    real divisor = real(2.0f) + f;
    real t = f / divisor;
    real t2 = t * t;
    real series =
        real(0.33333334f) + t2 * (real(0.2f) + t2 * (real(0.14285715f) + t2 * real(0.11111111f)));
    return (real(2.0f) + real(2.0f) * (t2 * series)) / divisor;
}

// x = 2^(exponent - 127) m, m in [sqrt(1/2), sqrt(2)); x is positive and no denormal.
SHEER_FN real split_exponent(real x, SHEER_INOUT(whole) exponent)
{
    // Counted from sqrt(1/2), so that the exponent's bits round the way that m needs.
    whole from_root = bits_of(x) - whole(0x3f3504f3u);
    exponent = (from_root + whole(0x3f800000u)) >> 23;
    return real_of_bits((from_root & whole(0x007fffffu)) + whole(0x3f3504f3u));
}

// ln x, to 2^-23 absolutely where |ln x| < 1.
SHEER_FN real log_of(real x)
{
    whole exponent = whole(0u);
    real f = split_exponent(x, exponent) - real(1.0f);
    return (to_real(exponent) - real(127.0f)) * real(0.69314718f) + f * log_quotient(f);
}

// e^x for x <= 0, and e^-87 = 1.6e-38 below -87. e^0 is 1.
//
// x = -k ln 2 + r, with ln 2 taken off in two parts, of which the first times k is exact (Cody and
// Waite. Software Manual for the Elementary Functions. 1980); then Taylor's series, of which what
// is left out is below 2^-27.
SHEER_FN real exp_of(real x)
{
    x = max(x, real(-87.0f));
    whole k = to_whole(real(0.5f) - x * real(1.44269504f));
    real r = (x + to_real(k) * real(0.693359375f)) + to_real(k) * real(-2.12194440e-4f);
    real series =
        real(0.5f) +
        r * (real(0.16666667f) +
             r * (real(0.041666668f) + r * (real(0.0083333333f) +
                                            r * (real(0.0013888889f) + r * real(0.00019841270f)))));
    return (real(1.0f) + (r + (r * r) * series)) * real_of_bits((whole(127u) - k) << 23);
}

// -ln(1 - a): additive, where what light passes through multiplies. `opacity` is in [0, 1); small
// ones lose nothing to the difference. A float below 1 gives 16.64 at most.
SHEER_FN real optical_depth(real opacity)
{
    whole exponent = whole(0u);
    real m = split_exponent(real(1.0f) - opacity, exponent);
    mask is_small = exponent == whole(127u);
    real f = select(is_small, real(0.0f) - opacity, m - real(1.0f));
    real halvings = real(127.0f) - to_real(exponent);
    return halvings * real(0.69314718f) - f * log_quotient(f);
}
