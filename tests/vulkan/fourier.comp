#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/exponential.glsl"
#include "sheer/transmittance.glsl"
#include "sheer/fourier.glsl"
#include "fragment_list.glsl"
#include "transmittance_list.glsl"

layout(constant_id = 1) const int kTerms = 7;
layout(constant_id = 2) const int kDamped = 0;

FourierSeries series;

void add_sums(float place, float depth)
{
    FourierAngles angles = fourier_angles(place, kTerms);
    add_exactly(0, double(depth));
    for (int k = 1; k <= kTerms; ++k) {
        add_exactly(2 * k - 1, double(depth) * double(angles.cosine[k]));
        add_exactly(2 * k, double(depth) * double(angles.sine[k]));
    }
}

void prepare()
{
    series.depth = float(sums[0]);
    for (int k = 1; k <= kTerms; ++k) {
        series.cosine[k] = float(sums[2 * k - 1]);
        series.sine[k] = float(sums[2 * k]);
    }
    series = fourier_series(series, kTerms, kDamped != 0);
}

float seen_from(float place)
{
    return fourier_transmittance(series, place, kTerms);
}

vec4 kept_numbers()
{
    return vec4(series.depth, series.cosine[1], series.sine[1], series.cosine[2]);
}

void main()
{
    run_passes(1);
}
