#version 450
#extension GL_GOOGLE_include_directive : require
#include "sheer/prelude.glsl"
#include "sheer/over.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/exponential.glsl"
#include "sheer/transmittance.glsl"
#include "sheer/wavelet.glsl"
#include "fragment_list.glsl"
#include "transmittance_list.glsl"

layout(constant_id = 1) const int kRank = 3;

const int kCells = 2 << kRank;
float means[32];

// wavelet_addend in doubles, for which the text is of floats here.
double addend(double d, uint cell, int up)
{
    double scale = double(1 << (kRank + 1 - up));
    uint wavelet = cell >> up;
    bool is_left = ((cell >> (up - 1)) & 1u) == 0u;
    double begin = double(wavelet) / scale;
    double end = (double(wavelet) + 1.0lf) / scale;
    return sqrt(scale) * (is_left ? d - begin : end - d);
}

void add_sums(float place, float depth)
{
    float d = wavelet_place(place, float(kCells));
    uint cell = wavelet_cell(d, float(kCells));
    double through = depth;
    add_exactly(0, through);
    add_exactly(kCells, through * (1.0lf - double(d)));
    for (int up = 1; up <= kRank + 1; ++up) {
        add_exactly((1 << (kRank + 1 - up)) + int(cell >> up),
                    through * addend(double(d), cell, up));
    }
}

void prepare()
{
    for (uint cell = 0; cell < uint(kCells); ++cell) {
        double mean = sums[kCells];
        for (int up = 1; up <= kRank + 1; ++up) {
            int power = kRank + 1 - up;
            double s = sqrt(double(1 << power)) * sums[(1 << power) + int(cell >> up)];
            mean = (cell >> (up - 1) & 1u) == 0u ? mean - s : mean + s;
        }
        means[cell] = float(mean);
    }
}

float seen_from(float place)
{
    float d = wavelet_place(place, float(kCells));
    uint cell = wavelet_cell(d, float(kCells));
    float here = means[cell];
    float before = 0;
    if (cell > 0) before = means[cell - 1];
    if (place >= 1) before = here;
    return wavelet_transmittance(d, cell, float(kCells), before, here);
}

vec4 kept_numbers()
{
    return vec4(means[0], means[1], means[2], means[3]);
}

void main()
{
    run_passes(1);
}
