// What a method's function of transmittance is, one plain number at a time, and the texts that it
// is made of.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lanes/lone.h"

namespace sheer::test {

template <class L>
struct TransmittanceTexts {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/exponential.glsl"
#include "sheer/transmittance.glsl"
#include "sheer/power_moments.glsl"
#include "sheer/gauss_rule.glsl"
#include "sheer/trigonometric_moments.glsl"
#include "sheer/moment.glsl"
#include "sheer/moment_formats.glsl"
#include "sheer/mboit_formats.glsl"
#include "sheer/secular.glsl"
#include "sheer/circle_fraction.glsl"
#include "sheer/fourier.glsl"
#include "sheer/wavelet.glsl"
};
using FloatText = TransmittanceTexts<Lone<float>>;
using DoubleText = TransmittanceTexts<Lone<double>>;

// Rounded to the grid of exact sums; doubles add up numbers of a grid without loss.
inline double on_grid(double x, double magic)
{
    return (x + magic) - magic;
}
inline double grid_magic(int exponent)
{
    return std::ldexp(1.5, 52 + exponent);
}
inline constexpr int kDepthGrid = -38, kColorGrid = -48;

using Sums = std::vector<double>;
using State = std::vector<float>;

inline float as_float(double x)
{
    return static_cast<float>(x);
}

class TransmittanceFunction {
public:
    virtual ~TransmittanceFunction() = default;
    virtual int passes() const { return 1; }
    virtual std::size_t sums() const = 0;
    // The first of the sums is that of the optical depths.
    virtual Sums addends(float place, float depth) const = 0;
    virtual State prepare(const Sums& sums) const = 0;
    // After a second pass.
    virtual State prepare_again(State state, const Sums&) const { return state; }
    virtual float transmittance(const State& state, float place) const = 0;

    void add(Sums& to, float place, float depth) const
    {
        const Sums some = addends(place, depth);
        const double magic = grid_magic(kDepthGrid);
        for (std::size_t k = 0; k < to.size(); ++k) to[k] += on_grid(some[k], magic);
    }
};

inline double depth_divisor(const Sums& sums)
{
    return std::max(sums[0], 0x1p-38);
}

}  // namespace sheer::test
