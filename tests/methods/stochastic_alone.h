// The texts of stochastic transparency, for texts_alone.h, which has the rest.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "methods/method_alone.h"

namespace sheer::test {

// The masks of a pixel's fragments.
template <class L>
struct MasksAlone : MethodAlone<L> {
    using T = Texts<L>;
    using real = typename L::real;
    const bool stratified = this->method.value("masks") == "stratified";
    const bool dithered = this->method.value("round") == "tile-dither";
    const bool corrects = this->method.value("correction") == "on";
    std::vector<typename T::SampleBits> masks = {};  // of the pixel's fragments
    std::uint32_t first = 0;

    static real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    void begin_pixel(std::uint32_t pixel)
    {
        const TilePlace& place = this->lists.place;
        const std::uint32_t x = static_cast<std::uint32_t>(place.x) + pixel % kTileSize;
        const std::uint32_t y = static_cast<std::uint32_t>(place.y) + pixel / kTileSize;
        masks.clear();
        first = this->lists.first[pixel];
        for (std::uint32_t i = first; i < this->lists.first[pixel + 1]; ++i) {
            const std::uint32_t identity =
                T::identity_seed(name_of(this->lists.fragments[i]), place.key);
            std::uint32_t own = T::fragment_seed(x, y, identity);
            const int samples = this->lists.set.count;
            if (!stratified) {
                masks.push_back(T::naive_mask(own, this->opacity(i), samples));
                continue;
            }
            const real xi =
                dithered ? T::dithered_xi(x, y, identity, own) : T::next_random_real(own);
            masks.push_back(T::stratified_mask(own, xi, this->opacity(i), samples));
        }
    }
    std::uint32_t name_of(const ListedFragment& f) const
    {
        const std::string& by = this->method.value("seed-by");
        if (by == "depth") return std::bit_cast<std::uint32_t>(f.center);
        if (by == "primitive") return f.primitive;
        return by == "object" ? 2 * f.object + f.back_facing : f.object;
    }
    bool takes(std::size_t i, std::size_t at) const
    {
        const auto& mask = masks[i - first];
        const bool taken = ((at < 32 ? mask.low : mask.high) >> at % 32 & 1) != 0;
        return taken && this->lists.covers(i, at);
    }
    real depth(std::size_t i, std::size_t at) const { return real(this->lists.depth_at(i, at)); }
    std::uint32_t id(std::size_t i) const { return this->lists.fragments[i].primitive; }
};

template <class L>
struct StochasticAlone : MasksAlone<L> {
    using T = Texts<L>;
    using real = typename L::real;
    using real3 = typename T::real3;
    struct Store {
        typename T::StochasticStore nearest;
        real transmittance;
        bool corrects;
    };

    Store clear() const
    {
        return {T::stochastic_clear(this->beyond_any()), real(1.0f), this->corrects};
    }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        s.nearest = T::stochastic_insert(s.nearest, this->takes(i, at),
                                         {this->depth(i, at), this->id(i), this->color(i)});
        s.transmittance =
            T::total_alpha_insert(s.transmittance, this->lists.covers(i, at), this->opacity(i));
        return s;
    }
    static real empty(Store s)
    {
        return T::stochastic_transmittance(s.nearest, StochasticAlone::beyond_any());
    }
    static real3 resolve(Store s, real3 behind)
    {
        const real beyond = StochasticAlone::beyond_any();
        if (!s.corrects) return T::stochastic_resolve(s.nearest, beyond, behind);
        const real none(0.0f), one(1.0f);
        const real3 shown = T::stochastic_resolve(s.nearest, beyond, {none, none, none});
        return T::over(T::alpha_corrected(shown, one - empty(s), one - s.transmittance),
                       s.transmittance, behind);
    }
    static real transmittance(Store s) { return s.corrects ? s.transmittance : empty(s); }
    // The id is whole and stays out of it.
    static auto keep(Store s)
    {
        return StochasticAlone::kept(s.nearest.color, s.nearest.depth, s.transmittance);
    }
};

template <class L>
struct StochasticDepthAlone : MasksAlone<L> {
    using T = Texts<L>;
    using real = typename L::real;
    using real3 = typename T::real3;
    static constexpr int kPasses = 2;
    struct Store {
        typename T::StochasticDepth nearest;
        typename T::StochasticDepthSum sum;
        real transmittance;
        bool corrects;
    };

    Store clear() const
    {
        return {T::stochastic_depth_clear(this->beyond_any()), T::stochastic_depth_no_sum(),
                real(1.0f), this->corrects};
    }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        const typename T::StochasticDepth fragment = {this->depth(i, at), this->id(i)};
        if (this->pass == 0) {
            s.nearest = T::stochastic_depth_insert(s.nearest, this->takes(i, at), fragment);
            return s;
        }
        const bool covered = this->lists.covers(i, at);
        const bool shown = T::stochastic_depth_shows(s.nearest, covered, fragment);
        s.sum =
            T::stochastic_depth_add(s.sum, shown ? this->opacity(i) : real(0.0f), this->color(i));
        s.transmittance = T::total_alpha_insert(s.transmittance, covered, this->opacity(i));
        return s;
    }
    static real3 resolve(Store s, real3 behind)
    {
        const real one(1.0f), through = s.transmittance;
        if (!s.corrects) return T::over(s.sum.color, through, behind);
        return T::over(T::alpha_corrected(s.sum.color, s.sum.weight, one - through), through,
                       behind);
    }
    static real transmittance(Store s) { return s.transmittance; }
    static auto keep(Store s)
    {
        return StochasticDepthAlone::kept(s.sum.color, s.sum.weight, s.transmittance);
    }
};

}  // namespace sheer::test
