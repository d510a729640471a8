// The functions of methods that approximate transmittance, one plain number at a time: what is
// added up for a fragment, what is kept of that, and what it says. For transmittance_alone.h.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lanes/lone.h"
#include "methods/moment_settings.h"

namespace sheer::test {

template <class L>
struct TransmittanceTexts {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/exponential.glsl"
#include "sheer/transmittance.glsl"
#include "sheer/power_moments.glsl"
#include "sheer/moment.glsl"
#include "sheer/moment_formats.glsl"
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

class MomentFunction : public TransmittanceFunction {
public:
    explicit MomentFunction(const MomentSettings& settings) : settings_(settings) {}

    int passes() const override { return settings_.passes; }
    std::size_t sums() const override { return 5; }
    Sums addends(float place, float depth) const override
    {
        const auto z = static_cast<double>(place), d = static_cast<double>(depth);
        const double z2 = z * z, d2 = d * z2;
        return {d, d * z, d2, d2 * z, d2 * z2};
    }
    FloatText::MomentCurve curve(const Sums& sums) const
    {
        DoubleText::PowerMoments m = {};
        for (std::size_t k = 0; k < 5; ++k) m.m[k] = sums[k] / depth_divisor(sums);
        if (settings_.format == MomentFormat::fp16 || settings_.format == MomentFormat::unorm16) {
            FloatText::FourMoments b{as_float(m.m[1]), as_float(m.m[2]), as_float(m.m[3]),
                                     as_float(m.m[4])};
            b = settings_.format == MomentFormat::fp16 ? FloatText::moments_as_halves(b)
                                                       : FloatText::moments_as_unorm16(b);
            const float rounded[] = {b.b1, b.b2, b.b3, b.b4};
            for (std::size_t k = 0; k < 4; ++k) m.m[k + 1] = static_cast<double>(rounded[k]);
        }
        const DoubleText::MomentBias bias{settings_.bias, {1, settings_.even2, settings_.even4}};
        const auto r = DoubleText::recurrence_of(DoubleText::biased_moments(m, bias, 2), 2,
                                                 0.1 * settings_.bias);
        auto curve = FloatText::moment_curve(as_float(r.a[0]), as_float(r.a[1]), as_float(r.b[1]),
                                             as_float(r.b[2]), as_float(std::sqrt(r.b[1])),
                                             as_float(sums[0]));
        if (settings_.format != MomentFormat::fp32) {
            curve.depth = FloatText::half_float(curve.depth);
        }
        if (settings_.format != MomentFormat::nlqm) return curve;
        return FloatText::curve_of_quantised(FloatText::quantised_moments(curve), curve.depth);
    }
    State prepare(const Sums& sums) const override
    {
        const auto c = curve(sums);
        return {c.mean, c.inverse_deviation, c.skewness, c.sharpness, c.depth};
    }
    float transmittance(const State& state, float place) const override
    {
        const FloatText::MomentCurve c{state[0], state[1], state[2], state[3], state[4]};
        return FloatText::moment_transmittance(
            c, place,
            settings_.adapts ? FloatText::moment_adaptive(c, as_float(settings_.bias))
                             : settings_.overestimation);
    }

private:
    MomentSettings settings_;
};

// Null: the method is none of these.
inline std::unique_ptr<TransmittanceFunction> transmittance_function(const ChosenMethod& method)
{
    const std::string id = method.row->id;
    if (id == "moment") return std::make_unique<MomentFunction>(moment_settings(method));
    return nullptr;
}

}  // namespace sheer::test
