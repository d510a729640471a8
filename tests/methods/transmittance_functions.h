// The functions of methods that approximate transmittance, one plain number at a time: what is
// added up for a fragment, what is kept of that, and what it says. For transmittance_alone.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "methods/mboit_settings.h"
#include "methods/moment_settings.h"
#include "methods/series_functions.h"
#include "methods/wrapping_zone.h"

namespace sheer::test {

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
    State prepare_again(State state, const Sums& sums) const override
    {
        const State second = prepare(sums);
        state.insert(state.end(), second.begin(), second.end());
        return state;
    }
    float transmittance(const State& state, float place) const override
    {
        const float first = transmittance_of(&state[0], place);
        return state.size() > 5 ? first * transmittance_of(&state[5], place) : first;
    }

private:
    float transmittance_of(const float* state, float place) const
    {
        const FloatText::MomentCurve c{state[0], state[1], state[2], state[3], state[4]};
        return FloatText::moment_transmittance(
            c, place,
            settings_.adapts ? FloatText::moment_adaptive(c, as_float(settings_.bias))
                             : settings_.overestimation);
    }

    MomentSettings settings_;
};

class PowerFunction : public TransmittanceFunction {
public:
    explicit PowerFunction(const MboitSettings& settings) : settings_(settings) {}

    std::size_t sums() const override { return 2 * half() + 1; }
    Sums addends(float place, float depth) const override
    {
        Sums some = {static_cast<double>(depth)};
        while (some.size() < sums()) some.push_back(some.back() * static_cast<double>(place));
        return some;
    }
    State prepare(const Sums& sums) const override
    {
        DoubleText::PowerMoments m = {};
        for (std::size_t k = 0; k < sums.size(); ++k) m.m[k] = sums[k] / depth_divisor(sums);
        if (settings_.rounded) round(m);
        DoubleText::MomentBias bias = {};
        bias.amount = settings_.bias;
        std::copy_n(settings_.even.begin(), 5, bias.even);
        const auto r =
            DoubleText::recurrence_of(DoubleText::biased_moments(m, bias, settings_.half),
                                      settings_.half, 1e-4 * settings_.bias);
        const auto rule = DoubleText::gauss_rule(r, settings_.half);
        State state;
        for (std::size_t k = 0; k < half(); ++k) state.push_back(as_float(rule.point[k]));
        for (std::size_t k = 0; k < half(); ++k) state.push_back(as_float(rule.strength[k]));
        for (std::size_t k = 0; k < half(); ++k) state.push_back(as_float(rule.share[k]));
        state.push_back(as_float(sums[0]));
        return state;
    }
    float transmittance(const State& state, float place) const override
    {
        FloatText::SecularForm form = {};
        std::copy_n(&state[0], half(), form.point);
        std::copy_n(&state[half()], half(), form.strength);
        std::copy_n(&state[2 * half()], half(), form.share);
        const float part =
            FloatText::secular_fraction(form, settings_.half, place, settings_.overestimation);
        return FloatText::exp_of(0.0f - state[3 * half()] * part);
    }

private:
    std::size_t half() const { return static_cast<std::size_t>(settings_.half); }
    void round(DoubleText::PowerMoments& m) const
    {
        if (settings_.half == 2) {
            const auto b = FloatText::moments_as_unorm16(
                {as_float(m.m[1]), as_float(m.m[2]), as_float(m.m[3]), as_float(m.m[4])});
            const float rounded[] = {b.b1, b.b2, b.b3, b.b4};
            for (std::size_t k = 0; k < 4; ++k) m.m[k + 1] = static_cast<double>(rounded[k]);
            return;
        }
        FloatText::RoundedNumbers odd = {}, even = {};
        for (std::size_t k = 0; k < half(); ++k) {
            odd.n[k] = as_float(m.m[2 * k + 1]);
            even.n[k] = as_float(m.m[2 * k + 2]);
        }
        odd = FloatText::odd_as_unorm16(odd, settings_.half);
        even = FloatText::even_as_unorm16(even, settings_.half);
        for (std::size_t k = 0; k < half(); ++k) {
            m.m[2 * k + 1] = static_cast<double>(odd.n[k]);
            m.m[2 * k + 2] = static_cast<double>(even.n[k]);
        }
    }

    MboitSettings settings_;
};

class TrigonometricFunction : public TransmittanceFunction {
public:
    explicit TrigonometricFunction(const MboitSettings& settings) : settings_(settings) {}

    std::size_t sums() const override { return 2 * m() + 1; }
    Sums addends(float place, float depth) const override
    {
        const auto b = DoubleText::trigonometric_moments(
            DoubleText::half_angle(static_cast<double>(place) * zone_.half_depth), settings_.half);
        const auto d = static_cast<double>(depth);
        Sums some = {d};
        for (std::size_t j = 1; j <= m(); ++j) {
            some.push_back(d * b.cosine[j]);
            some.push_back(d * b.sine[j]);
        }
        return some;
    }
    State prepare(const Sums& sums) const override
    {
        DoubleText::TrigonometricMoments b = {};
        b.cosine[0] = 1;
        for (std::size_t j = 1; j <= m(); ++j) {
            b.cosine[j] = in_format(sums[2 * j - 1] / depth_divisor(sums));
            b.sine[j] = in_format(sums[2 * j] / depth_divisor(sums));
        }
        const auto line = DoubleText::line_moments(
            DoubleText::biased_trigonometric(b, settings_.half, settings_.bias), settings_.half);
        const auto r = DoubleText::recurrence_of(line.power, settings_.half, 1e-6 * settings_.bias);
        const auto rule = DoubleText::gauss_rule(r, settings_.half);
        State state;
        for (std::size_t k = 0; k < m(); ++k) state.push_back(as_float(rule.point[k]));
        for (std::size_t k = 0; k < m(); ++k) state.push_back(as_float(rule.strength[k]));
        for (std::size_t k = 0; k < m(); ++k) state.push_back(as_float(r.a[k]));
        for (std::size_t k = 0; k < m(); ++k) state.push_back(as_float(std::sqrt(r.b[k + 1])));
        state.push_back(as_float(line.mass));
        state.push_back(as_float(sums[0]));
        return state;
    }
    float transmittance(const State& state, float place) const override
    {
        FloatText::CircleForm form = {};
        std::copy_n(&state[0], m(), form.line.point);
        std::copy_n(&state[m()], m(), form.line.strength);
        std::copy_n(&state[2 * m()], m(), form.a);
        std::copy_n(&state[3 * m()], m(), form.root + 1);
        form.mass = state[4 * m()];
        const FloatText::WrappingZone zone{as_float(zone_.half_depth), as_float(zone_.rest),
                                           as_float(zone_.edge),       as_float(zone_.cosine),
                                           as_float(zone_.sine),       as_float(zone_.begins)};
        const float part =
            FloatText::circle_fraction(form, settings_.half, zone, place, settings_.overestimation);
        return FloatText::exp_of(0.0f - state[4 * m() + 1] * part);
    }

private:
    std::size_t m() const { return static_cast<std::size_t>(settings_.half); }
    double in_format(double x) const
    {
        if (!settings_.rounded) return x;
        const float number = FloatText::unorm16(0.5f * as_float(x) + 0.5f);
        return static_cast<double>((number - 0.5f) * 2.0f);
    }

    MboitSettings settings_;
    WrappingZone zone_ = wrapping_zone();
};

// Null: the method is none of these.
inline std::unique_ptr<TransmittanceFunction> transmittance_function(const ChosenMethod& method)
{
    const std::string id = method.row->id;
    if (id == "moment") return std::make_unique<MomentFunction>(moment_settings(method));
    if (id == "mboit" && method.value("basis") == "power") {
        return std::make_unique<PowerFunction>(mboit_settings(method));
    }
    if (id == "mboit") return std::make_unique<TrigonometricFunction>(mboit_settings(method));
    if (id == "fourier") {
        return std::make_unique<FourierFunction>(method.number("terms"),
                                                 method.value("window") == "lanczos");
    }
    if (id == "wavelet") return std::make_unique<WaveletFunction>(method.number("rank"));
    return nullptr;
}

}  // namespace sheer::test
