// The layers of stochastic layered alpha blending at every sample of a tile:
// shaders/sheer/slab.glsl for a vector of samples at a time.
#if defined(SHEER_SLAB_LAYERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SLAB_LAYERS_INL_H
#undef SHEER_SLAB_LAYERS_INL_H
#else
#define SHEER_SLAB_LAYERS_INL_H
#endif

#include <limits>

#include "methods/slab_draws-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Words: of a layer's mask; 0: implicit coverage. Layers come near to far; a pixel's first
// layers(pixel) have been written to, of which the last may be clear at some samples. What is left
// behind the last of as many as there may be, clear at samples that nothing fell from, is given to
// falls(pixel, s, layer).
template <int S, int Words>
class SlabLayers {
public:
    using L = Lanes<S>;
    using Text = SlabText<L>;
    using Layer = typename Text::SlabLayer;
    using Front = typename Text::SlabFront;
    using real = typename L::real;
    using whole = typename L::whole;
    using mask = typename L::mask;
    static constexpr bool kExplicit = Words > 0;

    SlabLayers(const SlabSettings& settings, int samples, int most)
        : samples_(samples),
          most_(static_cast<std::size_t>(most)),
          purges_(settings.asks_again()),
          asks_(settings.asks()),
          colored_(!settings.depth_based),
          channels_(2 + (kExplicit ? Words : 2) + (colored_ ? 3u : 0u)),
          values_(kTilePixels * most_ * channels_ * count())
    {
    }

    static HWY_INLINE real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    static HWY_INLINE Layer nothing() { return Text::slab_clear(beyond_any()); }
    static HWY_INLINE mask there(const Layer& l) { return l.depth < beyond_any(); }
    HWY_INLINE std::size_t count() const { return sample_count<S>(samples_); }
    std::size_t most() const { return most_; }
    std::size_t layers(std::size_t pixel) const { return layers_[pixel]; }

    void clear() { std::fill_n(layers_, kTilePixels, 0u); }

    HWY_INLINE Layer load(std::size_t pixel, std::size_t layer, std::size_t s) const
    {
        Layer l = load_uncolored(pixel, layer, s);
        if (!colored_) return l;
        const float* at = values_.data() + index(pixel, layer) + s;
        l.color = load_color<Text>(at + (channels_ - 3) * count(), count());
        return l;
    }

    HWY_INLINE void save(const Layer& l, std::size_t pixel, std::size_t layer, std::size_t s)
    {
        float* at = values_.data() + index(pixel, layer) + s;
        l.depth.store(at);
        l.id.as_real().store(at + count());
        if constexpr (kExplicit) {
            const whole words[4] = {l.bits.a, l.bits.b, l.bits.c, l.bits.d};
            for (std::size_t w = 0; w < Words; ++w) {
                words[w].as_real().store(at + (2 + w) * count());
            }
        } else {
            l.limit.store(at + 2 * count());
            l.opacity.store(at + 3 * count());
        }
        if (colored_) save_color<Text>(l.color, at + (channels_ - 3) * count(), count());
    }

    // A fragment, clear where it does not cover the sample, takes its place if it is seen there, or
    // need not be.
    template <class Falls>
    HWY_INLINE void put(const Layer& f, std::size_t pixel, std::size_t s, Falls&& falls)
    {
        asks_ ? put_if_seen(f, pixel, s, falls) : put_anyway(f, pixel, s, falls);
    }

    // The other's layers, near to far. What both have is there once.
    template <class Falls>
    void merge(const SlabLayers& other, Falls&& falls)
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            for (std::size_t j = 0; j < other.layers(pixel); ++j) {
                for (std::size_t s = 0; s < count(); s += L::kCount) {
                    const Layer f = unless_known(other.load(pixel, j, s), pixel, s);
                    purges_ ? put_if_seen(f, pixel, s, falls) : put_anyway(f, pixel, s, falls);
                }
            }
        }
    }

    // Depth that the last of as many layers as there may be have at most; else infinity.
    HWY_INLINE float farthest(std::size_t pixel) const
    {
        if (layers(pixel) < most_) return std::numeric_limits<float>::infinity();
        real far = load_uncolored(pixel, most_ - 1, 0).depth;
        for (std::size_t s = L::kCount; s < count(); s += L::kCount) {
            far = L::max(far, load_uncolored(pixel, most_ - 1, s).depth);
        }
        return far.greatest();
    }

    // What hides a fragment.
    HWY_INLINE Front front_of(const Layer& f, std::size_t pixel, std::size_t s) const
    {
        Front front = Text::slab_no_front();
        for (std::size_t j = 0; j < layers(pixel); ++j) {
            const Layer l = load_uncolored(pixel, j, s);
            const mask in_front = Text::slab_in_front(l, f);
            if (!in_front.any()) break;
            front = Text::slab_behind(front, in_front, l);
        }
        return front;
    }
    // Whether it lies behind the last of `full` layers.
    HWY_INLINE mask is_behind_all(const Layer& f, std::size_t full, std::size_t pixel,
                                  std::size_t s) const
    {
        if (layers(pixel) < full) return real(1.0f) < real(0.0f);
        return Text::slab_in_front(load_uncolored(pixel, full - 1, s), f);
    }

    // Leaves those layers for which keeps(layer) says so, asked near to far, `most` at most.
    template <class Keeps>
    HWY_INLINE void thin_out(std::size_t pixel, std::size_t s, std::size_t most, Keeps&& keeps)
    {
        Layer x[kMost + 1];
        const std::size_t n = layers(pixel);
        for (std::size_t j = 0; j < n; ++j) {
            const Layer l = load(pixel, j, s);
            x[j] = Text::slab_select(keeps(l), l, nothing());
        }
        x[n] = nothing();
        close_gaps(x, 0, n);
        for (std::size_t j = 0; j < std::min(n, most); ++j) save(x[j], pixel, j, s);
    }
    void shorten(std::size_t pixel, std::size_t most)
    {
        layers_[pixel] = std::min(layers_[pixel], static_cast<std::uint32_t>(most));
    }

private:
    static constexpr std::size_t kMost = 32;

    // Layer by layer: most fragments touch the last of their pixel alone.
    HWY_INLINE std::size_t index(std::size_t pixel, std::size_t layer) const
    {
        return (layer * kTilePixels + pixel) * channels_ * count();
    }
    HWY_INLINE Layer load_uncolored(std::size_t pixel, std::size_t layer, std::size_t s) const
    {
        const float* at = values_.data() + index(pixel, layer) + s;
        Layer l = nothing();
        l.depth = real::load(at);
        l.id = load_whole(at, 1);
        if constexpr (kExplicit) {
            l.bits.a = load_whole(at, 2);
            if constexpr (Words > 1) l.bits.b = load_whole(at, 3);
            if constexpr (Words > 2) l.bits.c = load_whole(at, 4);
            if constexpr (Words > 2) l.bits.d = load_whole(at, 5);
        } else {
            l.limit = real::load(at + 2 * count());
            l.opacity = real::load(at + 3 * count());
        }
        return l;
    }
    HWY_INLINE whole load_whole(const float* at, std::size_t channel) const
    {
        return whole::bits_of(real::load(at + channel * count()));
    }
    // slab_select of what is kept.
    HWY_INLINE Layer select(mask m, const Layer& a, const Layer& b) const
    {
        Layer l = nothing();
        l.depth = L::select(m, a.depth, b.depth);
        l.id = L::select(m, a.id, b.id);
        if constexpr (kExplicit) {
            l.bits.a = L::select(m, a.bits.a, b.bits.a);
            if constexpr (Words > 1) l.bits.b = L::select(m, a.bits.b, b.bits.b);
            if constexpr (Words > 2) l.bits.c = L::select(m, a.bits.c, b.bits.c);
            if constexpr (Words > 2) l.bits.d = L::select(m, a.bits.d, b.bits.d);
        } else {
            l.limit = L::select(m, a.limit, b.limit);
            l.opacity = L::select(m, a.opacity, b.opacity);
        }
        if (colored_) l.color = Text::select(m, a.color, b.color);
        return l;
    }

    // How many of the first layers are in front of a fragment at all samples, and what they hide.
    struct Place {
        std::size_t layer;
        Front front;
    };

    template <class Falls>
    HWY_NOINLINE void put_if_seen(const Layer& f, std::size_t pixel, std::size_t s, Falls&& falls)
    {
        const std::size_t n = layers(pixel);
        Front front = Text::slab_no_front();
        Place place{n, front};
        bool leads = true;
        for (std::size_t j = 0; j < n; ++j) {
            const Layer l = load_uncolored(pixel, j, s);
            const mask in_front = Text::slab_in_front(l, f);
            if (leads && Text::slab_in_front(f, l).any()) {
                place = {j, front};
                leads = false;
            }
            if (!in_front.any()) break;
            front = Text::slab_behind(front, in_front, l);
        }
        if (leads) place.front = front;
        const mask seen = Text::slab_shows(kExplicit, front, f);
        if (seen.any()) put_at(place, select(seen, f, nothing()), pixel, s, falls);
    }
    // If it has a bit.
    template <class Falls>
    HWY_NOINLINE void put_anyway(const Layer& f, std::size_t pixel, std::size_t s, Falls&& falls)
    {
        const mask any = Text::slab_shows(kExplicit, Text::slab_no_front(), f);
        if (!any.any()) return;
        std::size_t at = layers(pixel);
        while (at > 0 && Text::slab_in_front(f, load_uncolored(pixel, at - 1, s)).any()) --at;
        const Place place{at, Text::slab_no_front()};
        put_at(place, select(any, f, nothing()), pixel, s, falls);
    }

    template <class Falls>
    HWY_INLINE void put_at(const Place& place, Layer f, std::size_t pixel, std::size_t s,
                           Falls&& falls)
    {
        const std::size_t n = layers(pixel);
        Front front = place.front;
        mask gone = there(nothing());
        for (std::size_t j = place.layer; j < n; ++j) {
            Layer kept = load(pixel, j, s);
            const mask in_front = Text::slab_in_front(f, kept);
            const Layer nearer = select(in_front, f, kept);
            f = select(in_front, kept, f);
            kept = nearer;
            if (purges_) purge(kept, front, gone);
            save(kept, pixel, j, s);
        }
        if (purges_) {
            purge(f, front, gone);
            if (gone.any()) close_gaps(f, pixel, place.layer, s);
        }
        if (!there(f).any()) return;
        if (n < most_) {
            append(f, pixel, s);
        } else {
            falls(pixel, s, f);
        }
    }
    HWY_INLINE void append(const Layer& f, std::size_t pixel, std::size_t s)
    {
        const std::size_t n = layers_[pixel]++;
        for (std::size_t other = 0; other < count(); other += L::kCount) {
            save(nothing(), pixel, n, other);
        }
        save(f, pixel, n, s);
    }

    // A layer goes if it is not seen any more.
    HWY_INLINE void purge(Layer& layer, Front& front, mask& gone) const
    {
        const mask seen = Text::slab_shows(kExplicit, front, layer);
        gone = gone || (there(layer) && !seen);
        layer = select(seen, layer, nothing());
        front = Text::slab_behind(front, seen, layer);
    }

    // From a layer on to the last, behind which there is one more. That is left there if there is
    // no gap for it.
    HWY_NOINLINE void close_gaps(Layer& last, std::size_t pixel, std::size_t first, std::size_t s)
    {
        Layer x[kMost + 1];
        const std::size_t n = layers(pixel);
        for (std::size_t j = first; j < n; ++j) x[j] = load(pixel, j, s);
        x[n] = last;
        close_gaps(x, first, n);
        for (std::size_t j = first; j < n; ++j) save(x[j], pixel, j, s);
        last = x[n];
    }
    // A layer for each gap at a time, which are few.
    static HWY_INLINE void close_gaps(Layer* x, std::size_t first, std::size_t n)
    {
        for (bool any = true; any;) {
            any = false;
            mask moves = there(nothing());
            for (std::size_t j = first; j < n; ++j) {
                const mask empty = !there(x[j]);
                any = any || (empty && there(x[j + 1])).any();
                moves = moves || empty;
                x[j] = Text::slab_select(moves, x[j + 1], x[j]);
            }
            x[n] = Text::slab_select(moves, nothing(), x[n]);
        }
    }

    // Clear where there is the same layer already.
    HWY_INLINE Layer unless_known(Layer f, std::size_t pixel, std::size_t s) const
    {
        for (std::size_t j = 0; j < layers(pixel); ++j) {
            const Layer l = load(pixel, j, s);
            const mask other = Text::slab_in_front(l, f) || Text::slab_in_front(f, l);
            f = select(other, f, nothing());
        }
        return f;
    }

    int samples_;
    std::size_t most_;
    bool purges_, asks_, colored_;
    std::size_t channels_;
    AlignedArray<float> values_;
    std::uint32_t layers_[kTilePixels] = {};
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SLAB_LAYERS_INL_H
