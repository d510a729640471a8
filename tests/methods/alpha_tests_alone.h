// The texts of alpha tests, for texts_alone.h, which has the rest.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "methods/fragment_lists.h"
#include "methods/hashed_settings.h"

namespace sheer::test {

template <class L>
struct Texts;
template <class L>
struct MethodAlone;

// The nearest fragment of those that keep the sample.
template <class L, class Keeps>
struct NearestAlone : MethodAlone<L> {
    using T = Texts<L>;
    using real = typename L::real;
    using real3 = typename T::real3;
    using Store = typename T::StochasticStore;

    std::uint32_t x = 0, y = 0;  // the pixel in the picture

    static real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    void begin_pixel(std::uint32_t pixel)
    {
        x = static_cast<std::uint32_t>(this->lists.place.x) + pixel % kTileSize;
        y = static_cast<std::uint32_t>(this->lists.place.y) + pixel / kTileSize;
    }
    static Store clear() { return T::stochastic_clear(beyond_any()); }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        const bool kept =
            static_cast<const Keeps*>(this)->keeps(i, at) && this->lists.covers(i, at);
        return T::stochastic_insert(s, kept,
                                    {real(this->lists.depth_at(i, at)),
                                     this->lists.fragments[i].primitive, this->color(i)});
    }
    static real3 resolve(Store s, real3 behind)
    {
        return T::stochastic_resolve(s, beyond_any(), behind);
    }
    static real transmittance(Store s) { return T::stochastic_transmittance(s, beyond_any()); }
    static auto keep(Store s) { return NearestAlone::kept(s.color, s.depth); }

    static bool has(const typename T::SampleBits& bits, std::size_t at)
    {
        return ((at < 32 ? bits.low : bits.high) >> at % 32 & 1) != 0;
    }
};

template <class L>
struct AlphaTestAlone : NearestAlone<L, AlphaTestAlone<L>> {
    const typename L::real cutoff{static_cast<float>(this->method.real("cutoff"))};

    bool keeps(std::size_t i, std::size_t) const
    {
        return Texts<L>::alpha_test(this->opacity(i), cutoff);
    }
};

template <class L>
struct TestThenBlendAlone : MethodAlone<L> {
    using T = Texts<L>;
    using real = typename L::real;
    using real3 = typename T::real3;
    using Store = typename T::TestThenBlendStore;
    static constexpr int kPasses = 2;
    const real cutoff{static_cast<float>(this->method.real("cutoff"))};

    static real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    static Store clear() { return T::test_then_blend_clear(beyond_any()); }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        const typename T::StochasticStore here = {
            real(this->lists.depth_at(i, at)), this->lists.fragments[i].primitive, this->color(i)};
        const bool covered = this->lists.covers(i, at);
        return this->pass == 0
                   ? T::test_then_blend_test(s, covered, here, this->opacity(i), cutoff)
                   : T::test_then_blend_blend(s, covered, here, this->opacity(i), cutoff);
    }
    static real3 resolve(Store s, real3 behind)
    {
        return T::test_then_blend_resolve(s, beyond_any(), behind);
    }
    static real transmittance(Store s) { return T::test_then_blend_transmittance(s, beyond_any()); }
    static auto keep(Store s)
    {
        return TestThenBlendAlone::kept(s.rest.color, s.rest.transmittance, s.opaque.depth);
    }
};

template <class L>
struct StochasticTestAlone : NearestAlone<L, StochasticTestAlone<L>> {
    using T = Texts<L>;
    const bool by_fragment = this->method.value("threshold") == "fragment";

    bool keeps(std::size_t i, std::size_t at) const
    {
        const std::uint32_t seed = T::fragment_seed(
            this->x, this->y,
            T::identity_seed(this->lists.fragments[i].primitive, this->lists.place.key));
        if (by_fragment) return T::alpha_test(this->opacity(i), T::random_threshold(seed));
        return this->has(T::naive_mask(seed, this->opacity(i), this->lists.set.count), at);
    }
};

// Thresholds of one fragment.
template <class L>
struct HashedAlone {
    using T = Texts<L>;
    using real = typename L::real;
    using real3 = typename T::real3;
    const HashedSettings settings;

    typename T::HashCells cells(const std::array<float, 9>& p) const
    {
        const auto three = [&](std::size_t c) {
            return real3{real(p[c]), real(p[c + 1]), real(p[c + 2])};
        };
        const real3 place = three(0), dx = three(3), dy = three(6);
        const real scale(settings.hash_scale);
        const bool same = settings.variant == HashVariant::isotropic;
        const real one = T::isotropic_scale(dx, dy, scale);
        const real3 each = same ? real3(one, one, one) : T::anisotropic_scales(dx, dy, scale);
        auto cells = !settings.octaves ? T::continuous_cells(place, each)
                     : same            ? T::isotropic_cells(place, one)
                                       : T::anisotropic_cells(place, each);
        if (!settings.third) cells.coarse.z = cells.fine.z = real(0.0f);
        return cells;
    }
    real threshold(const typename T::HashCells& cells) const
    {
        return settings.variant == HashVariant::eight_corners
                   ? T::threshold_of_corners(cells, settings.hash, settings.uniform)
                   : T::threshold_of_cells(cells, settings.hash, settings.uniform);
    }
};

template <class L>
struct HashedTestAlone : NearestAlone<L, HashedTestAlone<L>> {
    const HashedAlone<L> hashed{hashed_settings(this->method)};
    const float levels = fade_in_levels(this->method);

    bool keeps(std::size_t i, std::size_t) const
    {
        const ListedFragment& f = this->lists.fragments[i];
        auto threshold = hashed.threshold(hashed.cells(f.place));
        if (levels > 0) {
            const auto b = Texts<L>::fade_in(typename L::real(f.level), typename L::real(levels));
            threshold = Texts<L>::faded_threshold(threshold, b);
        }
        return Texts<L>::alpha_test(this->opacity(i), threshold);
    }
};

template <class L>
struct CoverageAlone : NearestAlone<L, CoverageAlone<L>> {
    using T = Texts<L>;
    const bool fixed = this->method.row->id == std::string("alpha-to-coverage");
    const HashedAlone<L> hashed{fixed ? HashedSettings{} : hashed_settings(this->method)};
    const bool apart = !fixed && this->method.value("decorrelate") == "on";
    const bool by_sample = !fixed && this->method.value("jitter") == "sample";

    bool keeps(std::size_t i, std::size_t at) const
    {
        const int samples = this->lists.set.count;
        if (fixed) {
            return this->has(
                T::coverage_mask(this->opacity(i), typename L::real(0.5f), false, 0u, 1u, samples),
                at);
        }
        const auto cells = hashed.cells(this->lists.fragments[i].place);
        const auto n = static_cast<std::uint32_t>(samples);
        const auto other = [&](std::uint32_t number) {
            return hashed.threshold(T::other_cells(cells, number));
        };
        return this->has(T::coverage_mask(this->opacity(i), hashed.threshold(cells), by_sample,
                                          apart ? T::coverage_offset(n, other(1)) : 0u,
                                          apart ? T::coverage_increment(n, other(2)) : 1u, samples),
                         at);
    }
};

template <class L>
struct ScreenDoorAlone : NearestAlone<L, ScreenDoorAlone<L>> {
    using T = Texts<L>;
    const std::string &square = this->method.value("square"),
                      &by = this->method.value("decorrelate");
    const bool jitter = this->method.value("jitter") == "on";

    bool keeps(std::size_t i, std::size_t) const
    {
        const ListedFragment& f = this->lists.fragments[i];
        const std::uint32_t name = by == "object" ? 2 * f.object + f.back_facing : f.primitive;
        return T::screen_door_keeps(this->opacity(i), this->x, this->y,
                                    square == "2"   ? 1
                                    : square == "4" ? 2
                                                    : 3,
                                    T::identity_seed(name, 0u), by != "off", jitter);
    }
};

}  // namespace sheer::test
