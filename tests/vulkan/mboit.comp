#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/exponential.glsl"
#include "sheer/transmittance.glsl"
#include "sheer/moment.glsl"
#include "sheer/moment_formats.glsl"
#include "sheer/mboit_formats.glsl"
#include "sheer/secular.glsl"
#include "sheer/circle_fraction.glsl"
#undef real
#define real double
double select(bool m, double a, double b)
{
    return m ? a : b;
}
#include "sheer/power_moments.glsl"
#include "sheer/gauss_rule.glsl"
#include "sheer/trigonometric_moments.glsl"
#undef real
#define real float
#include "fragment_list.glsl"
#include "transmittance_list.glsl"

layout(constant_id = 1) const int kTrigonometric = 0;
layout(constant_id = 2) const int kCount = 2;  // half of the moments
layout(constant_id = 3) const int kRounded = 0;
layout(constant_id = 4) const float kOverestimation = 0.25;
layout(constant_id = 5) const uint kBiasLow = 0;  // the halves of doubles
layout(constant_id = 6) const uint kBiasHigh = 0;
layout(constant_id = 7) const uint kEven2Low = 0;
layout(constant_id = 8) const uint kEven2High = 0;
layout(constant_id = 9) const uint kEven4Low = 0;
layout(constant_id = 10) const uint kEven4High = 0;
layout(constant_id = 11) const uint kEven6Low = 0;
layout(constant_id = 12) const uint kEven6High = 0;
layout(constant_id = 13) const uint kEven8Low = 0;
layout(constant_id = 14) const uint kEven8High = 0;
layout(constant_id = 15) const uint kHalfDepthLow = 0;
layout(constant_id = 16) const uint kHalfDepthHigh = 0;
layout(constant_id = 17) const float kEdge = 0;
layout(constant_id = 18) const float kCosine = 0;
layout(constant_id = 19) const float kSine = 0;
layout(constant_id = 20) const float kBegins = 0;
layout(constant_id = 21) const float kRest = 0;

double bias_amount = packDouble2x32(uvec2(kBiasLow, kBiasHigh));
double half_depth = packDouble2x32(uvec2(kHalfDepthLow, kHalfDepthHigh));
CircleForm form;
float depth_of_all;

void add_sums(float place, float depth)
{
    double d = depth;
    add_exactly(0, d);
    if (kTrigonometric == 0) {
        for (int k = 1; k <= 2 * kCount; ++k) {
            d = d * double(place);
            add_exactly(k, d);
        }
        return;
    }
    TrigonometricMoments b = trigonometric_moments(half_angle(double(place) * half_depth), kCount);
    for (int j = 1; j <= kCount; ++j) {
        add_exactly(2 * j - 1, d * b.cosine[j]);
        add_exactly(2 * j, d * b.sine[j]);
    }
}

PowerMoments rounded(PowerMoments m)
{
    if (kCount == 2) {
        FourMoments b = moments_as_unorm16(
            FourMoments(float(m.m[1]), float(m.m[2]), float(m.m[3]), float(m.m[4])));
        m.m[1] = b.b1;
        m.m[2] = b.b2;
        m.m[3] = b.b3;
        m.m[4] = b.b4;
        return m;
    }
    RoundedNumbers odd, even;
    for (int k = 0; k < 4; ++k) odd.n[k] = even.n[k] = 0;
    for (int k = 0; k < kCount; ++k) {
        odd.n[k] = float(m.m[2 * k + 1]);
        even.n[k] = float(m.m[2 * k + 2]);
    }
    odd = odd_as_unorm16(odd, kCount);
    even = even_as_unorm16(even, kCount);
    for (int k = 0; k < kCount; ++k) {
        m.m[2 * k + 1] = odd.n[k];
        m.m[2 * k + 2] = even.n[k];
    }
    return m;
}

double in_format(double x)
{
    if (kRounded == 0) return x;
    return double((unorm16(0.5 * float(x) + 0.5) - 0.5) * 2.0);
}

void prepare_power()
{
    PowerMoments m;
    for (int k = 0; k <= 2 * kCount; ++k) m.m[k] = sums[k] / depth_divisor();
    if (kRounded != 0) m = rounded(m);
    MomentBias bias;
    bias.amount = bias_amount;
    bias.even[0] = 1.0lf;
    bias.even[1] = packDouble2x32(uvec2(kEven2Low, kEven2High));
    bias.even[2] = packDouble2x32(uvec2(kEven4Low, kEven4High));
    bias.even[3] = packDouble2x32(uvec2(kEven6Low, kEven6High));
    bias.even[4] = packDouble2x32(uvec2(kEven8Low, kEven8High));
    Recurrence r = recurrence_of(biased_moments(m, bias, kCount), kCount, 1e-4lf * bias_amount);
    GaussRule rule = gauss_rule(r, kCount);
    for (int k = 0; k < kCount; ++k) {
        form.line.point[k] = float(rule.point[k]);
        form.line.strength[k] = float(rule.strength[k]);
        form.line.share[k] = float(rule.share[k]);
    }
}

void prepare_trigonometric()
{
    TrigonometricMoments b;
    b.cosine[0] = 1.0lf;
    b.sine[0] = 0.0lf;
    for (int j = 1; j <= kCount; ++j) {
        b.cosine[j] = in_format(sums[2 * j - 1] / depth_divisor());
        b.sine[j] = in_format(sums[2 * j] / depth_divisor());
    }
    LineMoments line = line_moments(biased_trigonometric(b, kCount, bias_amount), kCount);
    Recurrence r = recurrence_of(line.power, kCount, 1e-6lf * bias_amount);
    GaussRule rule = gauss_rule(r, kCount);
    for (int k = 0; k < kCount; ++k) {
        form.line.point[k] = float(rule.point[k]);
        form.line.strength[k] = float(rule.strength[k]);
        form.line.share[k] = 0;
        form.a[k] = float(r.a[k]);
        form.root[k + 1] = float(sqrt(r.b[k + 1]));
    }
    form.mass = float(line.mass);
}

void prepare()
{
    depth_of_all = float(sums[0]);
    if (kTrigonometric != 0) {
        prepare_trigonometric();
    } else {
        prepare_power();
    }
}

float seen_from(float place)
{
    WrappingZone zone = WrappingZone(float(half_depth), kRest, kEdge, kCosine, kSine, kBegins);
    float part = kTrigonometric != 0
                     ? circle_fraction(form, kCount, zone, place, kOverestimation)
                     : secular_fraction(form.line, kCount, place, kOverestimation);
    return exp_of(0.0 - depth_of_all * part);
}

// The first four that are kept.
vec4 kept_numbers()
{
    vec4 numbers = vec4(form.line.point[0], form.line.point[1], form.line.strength[0],
                        form.line.strength[1]);
    if (kCount == 3) numbers.zw = vec2(form.line.point[2], form.line.strength[0]);
    if (kCount == 4) numbers.zw = vec2(form.line.point[2], form.line.point[3]);
    return numbers;
}

void main()
{
    run_passes(1);
}
