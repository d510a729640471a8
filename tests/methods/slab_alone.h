// The texts of stochastic layered alpha blending and of multi-layer coverage blending, which are
// one but for what becomes of a layer too many; for texts_alone.h, which has the rest.
#pragma once

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

#include "methods/fragment_lists.h"
#include "methods/mlcb_settings.h"

namespace sheer::test {

template <class L>
struct Texts;
template <class L>
struct MethodAlone;

template <class L>
struct SlabAlone : MethodAlone<L> {
    using T = Texts<L>;
    using real = typename L::real;
    using real3 = typename T::real3;
    using Layer = typename T::SlabLayer;
    using Layers = std::vector<Layer>;
    static constexpr int kPasses = 2;
    const bool joins = this->method.row->id == std::string_view("mlcb");
    const SlabSettings settings = joins ? mlcb_settings(this->method) : slab_settings(this->method);
    std::uint32_t pixel = 0;

    struct Store {
        SlabSettings settings;
        Layers layers;  // near to far
        bool chosen;    // of candidates
        typename T::StochasticDepthSum sum;
        real through;
    };

    static real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    void begin_pixel(std::uint32_t p) { pixel = p; }
    Store clear() const
    {
        return {settings, {}, !settings.in_depth, T::stochastic_depth_no_sum(), real(1.0f)};
    }

    std::uint32_t apart() const
    {
        return (1u << 24) / static_cast<std::uint32_t>(this->lists.samples());
    }
    std::uint32_t seed_of(std::uint32_t name) const
    {
        const TilePlace& place = this->lists.place;
        return T::fragment_seed(static_cast<std::uint32_t>(place.x) + pixel % kTileSize,
                                static_cast<std::uint32_t>(place.y) + pixel / kTileSize,
                                T::identity_seed(name, place.key));
    }
    // As much of it as tells where it is.
    Layer place(std::size_t i, std::size_t at) const
    {
        Layer f = T::slab_clear(beyond_any());
        f.depth = real(this->lists.depth_at(i, at));
        f.id = this->lists.fragments[i].primitive;
        return f;
    }
    Layer fragment(std::size_t i, std::size_t at) const
    {
        Layer f = place(i, at);
        const std::uint32_t seed = seed_of(f.id), s = static_cast<std::uint32_t>(at);
        const int b = settings.bits;
        const real opacity = this->opacity(i);
        f.color = this->color(i);
        if (settings.has_masks()) {
            f.bits = T::slab_random_mask(seed, s, apart(), opacity, b);
            return f;
        }
        f.opacity = opacity;
        f.limit = settings.is_endless() || settings.in_depth
                      ? T::slab_no_limit()
                      : T::slab_random_limit(seed, s, apart(), settings.stratified, opacity, b);
        return f;
    }

    static auto front_of(const Layers& layers, const Layer& f)
    {
        auto front = T::slab_no_front();
        for (const Layer& l : layers) front = T::slab_behind(front, T::slab_in_front(l, f), l);
        return front;
    }
    void keep_layer(Store& s, const Layer& f) const
    {
        const bool asks = settings.keep != SlabKeep::nearest && !settings.in_depth;
        const auto front = asks ? front_of(s.layers, f) : T::slab_no_front();
        if (!T::slab_shows(settings.has_masks(), front, f)) return;
        const auto at = std::find_if(s.layers.begin(), s.layers.end(),
                                     [&](const Layer& l) { return T::slab_in_front(f, l); });
        s.layers.insert(at, f);
        if (settings.keep == SlabKeep::purged && !settings.in_depth) purge(s.layers);
        const auto most =
            static_cast<std::size_t>(settings.in_depth ? kSlabCandidates : settings.layers);
        if (s.layers.size() <= most) return;
        const Layer fallen = s.layers.back();
        s.layers.pop_back();
        if (joins) s.layers.back() = T::mlcb_join(s.layers.back(), fallen);
    }
    void purge(Layers& layers) const
    {
        auto front = T::slab_no_front();
        std::erase_if(layers, [&](const Layer& l) {
            const bool seen = T::slab_shows(settings.has_masks(), front, l);
            front = T::slab_behind(front, seen, l);
            return !seen;
        });
    }
    void choose(Store& s, std::size_t at) const
    {
        s.chosen = true;
        std::uint32_t seed = seed_of(0x7fffffffu);
        real sum = T::slab_xi(seed, static_cast<std::uint32_t>(at), apart());
        auto front = T::slab_no_front();
        std::erase_if(s.layers, [&](const Layer& l) {
            const real alpha = real(1.0f) - front.transmittance;
            const bool kept = T::slab_passes(
                sum, T::slab_chance(settings.stratified, alpha, l.opacity, settings.bits));
            front = T::slab_behind(front, kept, l);
            return !kept;
        });
        const auto most = static_cast<std::size_t>(settings.layers);
        s.layers.resize(std::min(s.layers.size(), most), T::slab_clear(beyond_any()));
    }
    void add(Store& s, std::size_t i, std::size_t at) const
    {
        const Layer f = place(i, at);
        const bool full = s.layers.size() == static_cast<std::size_t>(settings.layers);
        const bool dropped = !settings.adds_tail && full && T::slab_in_front(s.layers.back(), f);
        const real seen =
            T::slab_visibility(settings.has_masks(), front_of(s.layers, f), settings.bits);
        s.sum = T::stochastic_depth_add(s.sum, dropped ? real(0.0f) : seen * this->opacity(i),
                                        this->color(i));
    }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        if (this->pass == 1 && !s.chosen) choose(s, at);
        if (!this->lists.covers(i, at)) return s;
        if (this->pass == 0) keep_layer(s, fragment(i, at));
        if (this->pass == 0) return s;
        s.through = T::total_alpha_insert(s.through, true, this->opacity(i));
        if (settings.depth_based) add(s, i, at);
        return s;
    }

    struct Shown {
        typename T::StochasticDepthSum sum;
        real through;
    };
    static Shown shown(const Store& s)
    {
        const SlabSettings& settings = s.settings;
        if (settings.depth_based) return {s.sum, s.through};
        auto front = T::slab_no_front();
        auto sum = T::stochastic_depth_no_sum();
        for (const Layer& l : s.layers) {
            const real part = T::slab_part(settings.has_masks(), front, l, settings.bits);
            sum = T::stochastic_depth_add(sum, part, l.color);
            front = T::slab_behind(front, true, l);
        }
        const real through = T::slab_visibility(settings.has_masks(), front, settings.bits);
        return {sum, settings.corrects ? s.through : through};
    }
    static real3 resolve(const Store& s, real3 behind)
    {
        const auto [sum, through] = shown(s);
        if (!s.settings.corrects) return T::over(sum.color, through, behind);
        return T::over(T::alpha_corrected(sum.color, sum.weight, real(1.0f) - through), through,
                       behind);
    }
    static real transmittance(const Store& s) { return shown(s).through; }
    static auto keep(const Store& s)
    {
        const auto [sum, through] = shown(s);
        return SlabAlone::kept(sum.color, sum.weight, through);
    }
};

}  // namespace sheer::test
