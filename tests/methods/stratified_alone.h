// The text of stratified stochastic transparency for texts_alone.h, which has the rest.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "methods/method_alone.h"
#include "methods/stratified_settings.h"

namespace sheer::test {

// A pixel's samples know of one another: all are drawn before the first is asked for.
template <class L>
struct StratifiedAlone : MethodAlone<L> {
    using T = Texts<L>;
    using real = typename L::real;
    using Store = typename T::StochasticStore;

    const StratifiedSettings settings = stratified_settings(this->method);
    std::vector<Store> drawn = {};
    typename T::StratifiedSurface surface = {};
    std::uint32_t place = 0;

    static real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    static Store clear() { return T::stochastic_clear(beyond_any()); }
    void begin_pixel(std::uint32_t pixel)
    {
        const TilePlace& tile = this->lists.place;
        const std::uint32_t x = static_cast<std::uint32_t>(tile.x) + pixel % kTileSize;
        const std::uint32_t y = static_cast<std::uint32_t>(tile.y) + pixel / kTileSize;
        const std::uint32_t index = settings.dither == Dither::hilbert  ? T::hilbert_index(x, y)
                                    : settings.dither == Dither::morton ? T::morton_index(x, y)
                                                                        : 0;
        const auto numbers = systematic() ? 1 : static_cast<std::uint32_t>(this->lists.samples());
        place = T::reversed_bits(index * numbers);
        surface = T::stratified_clear(tile.key);
        drawn.assign(this->lists.samples(), clear());
        for (std::uint32_t i = this->lists.first[pixel]; i < this->lists.first[pixel + 1]; ++i) {
            draw(i);
        }
    }
    bool systematic() const { return settings.sequence == Sequence::systematic; }
    bool takes(real opacity, std::uint32_t number) const
    {
        if (systematic()) {
            return T::systematic_takes(opacity, T::reference_bits(0, place, surface.id) >> 8,
                                       number);
        }
        return T::stratified_takes(opacity,
                                   T::reference_bits(static_cast<int>(settings.sequence),
                                                     T::reversed_bits(number) + place, surface.id));
    }
    void draw(std::uint32_t i)
    {
        std::vector<Store> here;
        std::uint64_t open = 0;
        for (std::size_t s = 0; s < drawn.size(); ++s) {
            here.push_back({real(this->lists.depth_at(i, s)), this->lists.fragments[i].primitive,
                            this->color(i)});
            const bool nearer = T::stochastic_nearer(drawn[s], here[s]);
            if (nearer && this->lists.covers(i, s)) open |= 1ull << s;
        }
        if (open == 0) return;
        const std::uint32_t first =
            T::stratified_begin(surface, static_cast<std::uint32_t>(open),
                                static_cast<std::uint32_t>(open >> 32), settings.tracking);
        const std::vector<Store> before = drawn;
        for (std::uint32_t s = 0; s < drawn.size(); ++s) {
            if ((open >> s & 1) == 0) continue;
            std::uint32_t number = settings.compaction ? first : s;
            for (std::uint32_t t = 0; settings.compaction && t < drawn.size(); ++t) {
                const bool sooner =
                    settings.sort ? T::stratified_before(before[t].depth, t, before[s].depth, s)
                                  : t < s;
                if ((open >> t & 1) != 0 && sooner) ++number;
            }
            drawn[s] = T::stochastic_insert(drawn[s], takes(this->opacity(i), number), here[s]);
        }
    }
    Store insert(Store, std::size_t, std::size_t at) const { return drawn[at]; }
    static auto resolve(Store s, typename T::real3 behind)
    {
        return T::stochastic_resolve(s, beyond_any(), behind);
    }
    static real transmittance(Store s) { return T::stochastic_transmittance(s, beyond_any()); }
    // The id is whole and stays out of it.
    static auto keep(Store s) { return StratifiedAlone::kept(s.color, s.depth); }
};

}  // namespace sheer::test
