// What four moments become in formats of 16 bits, to be read from where they were added up in
// others. Sharpe. Moment Transparency. HPG 2018, section 4.2.
// Needs prelude.glsl, exponential.glsl, moment.glsl.

// The nearest of 16 bits' numbers from 0 to 1.
SHEER_FN real unorm16(real x)
{
    real inside = min(max(x, real(0.0f)), real(1.0f));
    return to_real(to_whole(inside * real(65535.0f) + real(0.5f))) / real(65535.0f);
}

// The nearest half float; beyond 65504 that. Ties go to the even one.
SHEER_FN real half_float(real x)
{
    whole bits = bits_of(x);
    whole size = bits & whole(0x7fffffffu);
    whole rounded = (size + whole(0xfffu) + ((size >> 13) & whole(1u))) & whole(0x7fffe000u);
    // Below 2^-14 halves are 2^-24 apart, as floats are from 1/2 to 1.
    real tiny = (real_of_bits(size) + real(0.5f)) - real(0.5f);
    real result = select(size < whole(0x38800000u), tiny, real_of_bits(rounded));
    result = min(result, real(65504.0f));
    return select((bits >> 31) == whole(1u), real(0.0f) - result, result);
}

struct FourMoments {
    real b1;
    real b2;
    real b3;
    real b4;
};

SHEER_FN FourMoments moments_as_halves(FourMoments b)
{
    b.b1 = half_float(b.b1);
    b.b2 = half_float(b.b2);
    b.b3 = half_float(b.b3);
    b.b4 = half_float(b.b4);
    return b;
}

// Turned so that the rounding harms least, each component from 0 to 1, and back. Muenstermann,
// Krumpen, Klein and Peters. Moment-Based Order-Independent Transparency. I3D 2018, supplement.
SHEER_FN FourMoments moments_as_unorm16(FourMoments b)
{
    real odd1 = unorm16((real(1.5f) * b.b1 - real(2.0f) * b.b3) + real(0.5f));
    real odd2 = unorm16((real(0.8660254f) * b.b1 - real(0.3849002f) * b.b3) + real(0.5f));
    real even1 = unorm16(real(4.0f) * (b.b2 - b.b4));
    real even2 = unorm16(real(0.5f) * (b.b2 + b.b4));
    odd1 = odd1 - real(0.5f);
    odd2 = odd2 - real(0.5f);
    b.b1 = real(1.7320508f) * odd2 - real(0.33333334f) * odd1;
    b.b3 = real(1.2990381f) * odd2 - real(0.75f) * odd1;
    b.b2 = real(0.125f) * even1 + even2;
    b.b4 = even2 - real(0.125f) * even1;
    return b;
}

// Non-linearly quantised: four numbers from 0 to 1. Peters. Non-Linearly Quantized Moment Shadow
// Maps. HPG 2017.
struct QuantisedMoments {
    real first;  // of the two points that have the first three moments, (1 + z) / 2
    real second;
    real weight;  // of the second
    real excess;  // of the fourth moment over theirs, warped
};

// ln ln(x / 1e-7), the excess's scale, from 1.2e-7 to 1/4.
SHEER_FN real quantised_scale(real x)
{
    return log_of(log_of(x * real(1e7f)));
}

SHEER_FN QuantisedMoments quantised_moments(MomentCurve c)
{
    // In y the points are the roots of y^2 - skewness y - 1.
    real middle = real(0.5f) * c.skewness;
    real apart = sqrt(middle * middle + real(1.0f));
    real deviation = real(1.0f) / c.inverse_deviation;
    real d0 = c.mean + (middle - apart) * deviation;
    real d1 = c.mean + (middle + apart) * deviation;
    real variance = deviation * deviation;
    real excess = max(variance * variance / c.sharpness, real(1.2e-7f));
    real least = quantised_scale(real(1.2e-7f));
    real most = quantised_scale(real(0.25f));
    QuantisedMoments q;
    q.first = unorm16(real(0.5f) * d0 + real(0.5f));
    q.second = unorm16(real(0.5f) * d1 + real(0.5f));
    q.weight = unorm16(real(0.5f) * (apart - middle) / apart);
    q.excess = unorm16((quantised_scale(excess) - least) / (most - least));
    return q;
}

// Peters has its own formulas for the bound; these give what moment_fraction wants, overestimation
// too.
SHEER_FN MomentCurve curve_of_quantised(QuantisedMoments q, real depth)
{
    real least = quantised_scale(real(1.2e-7f));
    real most = quantised_scale(real(0.25f));
    // exp_of is for what is below 0: e^3 and 1e-7 e^15.
    real logarithm = real(20.085537f) * exp_of((least + q.excess * (most - least)) - real(3.0f));
    real excess = real(0.32690174f) * exp_of(logarithm - real(15.0f));
    real w = min(max(q.weight, real(5e-6f)), real(1.0f) - real(5e-6f));
    real d0 = real(2.0f) * q.first - real(1.0f);
    real d1 = max(real(2.0f) * q.second - real(1.0f), d0 + real(5e-6f));
    real gap = d1 - d0;
    real spread = w * (real(1.0f) - w);
    real deviation = gap * sqrt(spread);
    MomentCurve c;
    c.mean = d0 + w * gap;
    c.inverse_deviation = real(1.0f) / deviation;
    c.skewness = (real(1.0f) - real(2.0f) * w) / sqrt(spread);
    c.sharpness = (deviation * deviation) * (deviation * deviation) / excess;
    c.depth = depth;
    return c;
}
