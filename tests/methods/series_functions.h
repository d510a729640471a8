// The functions of Fourier series and of wavelets, one plain number at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "methods/transmittance_function.h"

namespace sheer::test {

class FourierFunction : public TransmittanceFunction {
public:
    FourierFunction(int terms, bool damped) : terms_(terms), damped_(damped) {}

    std::size_t sums() const override { return 2 * static_cast<std::size_t>(terms_) + 1; }
    Sums addends(float place, float depth) const override
    {
        const auto angles = FloatText::fourier_angles(place, terms_);
        const auto d = static_cast<double>(depth);
        Sums some = {d};
        for (int k = 1; k <= terms_; ++k) {
            some.push_back(d * static_cast<double>(angles.cosine[k]));
            some.push_back(d * static_cast<double>(angles.sine[k]));
        }
        return some;
    }
    State prepare(const Sums& sums) const override
    {
        FloatText::FourierSeries series = read({sums.begin(), sums.end()});
        series = FloatText::fourier_series(series, terms_, damped_);
        State state = {series.depth};
        for (int k = 1; k <= terms_; ++k) {
            state.push_back(series.cosine[k]);
            state.push_back(series.sine[k]);
        }
        return state;
    }
    float transmittance(const State& state, float place) const override
    {
        return FloatText::fourier_transmittance(read(state), place, terms_);
    }

private:
    FloatText::FourierSeries read(const State& numbers) const
    {
        FloatText::FourierSeries series = {};
        series.depth = numbers[0];
        for (std::size_t k = 1; 2 * k < numbers.size(); ++k) {
            series.cosine[k] = numbers[2 * k - 1];
            series.sine[k] = numbers[2 * k];
        }
        return series;
    }

    int terms_;
    bool damped_;
};

class WaveletFunction : public TransmittanceFunction {
public:
    explicit WaveletFunction(int rank) : rank_(rank) {}

    std::size_t sums() const override { return (std::size_t{2} << rank_) + 1; }
    Sums addends(float place, float depth) const override
    {
        const float d = FloatText::wavelet_place(place, cells());
        const std::uint32_t cell = FloatText::wavelet_cell(d, cells());
        const auto through = static_cast<double>(depth);
        Sums some(sums());
        some.front() = through;
        some.back() = through * (1 - static_cast<double>(d));
        for (int up = 1; up <= rank_ + 1; ++up) {
            some[coefficient(cell, up)] =
                through * DoubleText::wavelet_addend(static_cast<double>(d), cell, up,
                                                     std::ldexp(1.0, power(up)),
                                                     std::sqrt(std::ldexp(1.0, power(up))));
        }
        return some;
    }
    State prepare(const Sums& sums) const override
    {
        State state;
        for (std::uint32_t cell = 0; cell + 1 < sums.size(); ++cell) {
            double mean = sums.back();
            for (int up = 1; up <= rank_ + 1; ++up) {
                const double step =
                    std::sqrt(std::ldexp(1.0, power(up))) * sums[coefficient(cell, up)];
                mean = (cell >> (up - 1) & 1) == 0 ? mean - step : mean + step;
            }
            state.push_back(as_float(mean));
        }
        return state;
    }
    float transmittance(const State& state, float place) const override
    {
        const float d = FloatText::wavelet_place(place, cells());
        const std::uint32_t cell = FloatText::wavelet_cell(d, cells());
        const float here = state[cell];
        const float before = place >= 1 ? here : cell > 0 ? state[cell - 1] : 0;
        return FloatText::wavelet_transmittance(d, cell, cells(), before, here);
    }

private:
    float cells() const { return std::ldexp(2.0f, rank_); }
    int power(int up) const { return rank_ + 1 - up; }
    // In the tree, of which the root is the second sum.
    std::size_t coefficient(std::uint32_t cell, int up) const
    {
        return (std::size_t{1} << power(up)) + (cell >> up);
    }

    int rank_;
};

}  // namespace sheer::test
