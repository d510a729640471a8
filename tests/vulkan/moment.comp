#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/exponential.glsl"
#include "sheer/transmittance.glsl"
#include "sheer/moment.glsl"
#include "sheer/moment_formats.glsl"
#undef real
#define real double
#include "sheer/power_moments.glsl"
#undef real
#define real float
#include "fragment_list.glsl"
#include "transmittance_list.glsl"

layout(constant_id = 1) const int kMomentPasses = 1;
layout(constant_id = 2) const int kFormat = 0;  // fp32, fp16, unorm16, nlqm
layout(constant_id = 3) const int kAdapts = 0;
layout(constant_id = 4) const float kOverestimation = 0.25;
layout(constant_id = 5) const uint kBiasLow = 0;  // the halves of doubles
layout(constant_id = 6) const uint kBiasHigh = 0;
layout(constant_id = 7) const uint kEven2Low = 0;
layout(constant_id = 8) const uint kEven2High = 0;
layout(constant_id = 9) const uint kEven4Low = 0;
layout(constant_id = 10) const uint kEven4High = 0;

double bias_amount = packDouble2x32(uvec2(kBiasLow, kBiasHigh));
MomentCurve curve;
MomentCurve first_curve;  // of two
bool has_first = false;
bool has_curve = false;

void add_sums(float place, float depth)
{
    double z = place, d = depth;
    double z2 = z * z, d2 = d * z2;
    add_exactly(0, d);
    add_exactly(1, d * z);
    add_exactly(2, d2);
    add_exactly(3, d2 * z);
    add_exactly(4, d2 * z2);
}

void prepare()
{
    has_first = has_curve;
    first_curve = curve;
    has_curve = true;
    PowerMoments m;
    for (int k = 0; k < 5; ++k) m.m[k] = sums[k] / depth_divisor();
    if (kFormat == 1 || kFormat == 2) {
        FourMoments b = FourMoments(float(m.m[1]), float(m.m[2]), float(m.m[3]), float(m.m[4]));
        if (kFormat == 1) b = moments_as_halves(b);
        if (kFormat == 2) b = moments_as_unorm16(b);
        m.m[1] = b.b1;
        m.m[2] = b.b2;
        m.m[3] = b.b3;
        m.m[4] = b.b4;
    }
    MomentBias bias;
    bias.amount = bias_amount;
    bias.even[0] = 1.0lf;
    bias.even[1] = packDouble2x32(uvec2(kEven2Low, kEven2High));
    bias.even[2] = packDouble2x32(uvec2(kEven4Low, kEven4High));
    Recurrence r = recurrence_of(biased_moments(m, bias, 2), 2, 0.1lf * bias_amount);
    curve = moment_curve(float(r.a[0]), float(r.a[1]), float(r.b[1]), float(r.b[2]),
                         float(sqrt(r.b[1])), float(sums[0]));
    if (kFormat != 0) curve.depth = half_float(curve.depth);
    if (kFormat == 3) curve = curve_of_quantised(quantised_moments(curve), curve.depth);
}

float seen_through(MomentCurve c, float place)
{
    float overestimation = kOverestimation;
    if (kAdapts != 0) overestimation = moment_adaptive(c, float(bias_amount));
    return moment_transmittance(c, place, overestimation);
}
float seen_from(float place)
{
    float through = seen_through(curve, place);
    if (has_first) through = seen_through(first_curve, place) * through;
    return through;
}

vec4 kept_numbers()
{
    MomentCurve c = curve;
    if (has_first) c = first_curve;
    return vec4(c.mean, c.inverse_deviation, c.skewness, c.sharpness);
}

void main()
{
    run_passes(kMomentPasses);
}
