// A few layers at every sample of a tile: shaders/sheer/layers.glsl, for stores that differ in what
// they do with a layer too many.
#if defined(SHEER_LAYERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_LAYERS_INL_H
#undef SHEER_LAYERS_INL_H
#else
#define SHEER_LAYERS_INL_H
#endif

#include <limits>

#include "methods/samples-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Calls visit(pixel, s, layer) with every fragment at each vector of its pixel's samples. Text has
// the words of layers.glsl, L the lanes for S.
template <int S, class Text, class Visit>
HWY_INLINE void for_each_layer(const FragmentStream& f, const SampleSet& set, Visit&& visit)
{
    using L = Lanes<S>;
    using real = typename L::real;
    using whole = typename L::whole;
    constexpr std::size_t kMostBlocks = (S < 16 ? S : kMaxSamples) / L::kCount;
    const std::size_t samples = sample_count<S>(set.count);
    const auto clear = Text::layer_clear(real(std::numeric_limits<float>::infinity()));
    for (int r = 0; r < f.run_count; ++r) {
        const FragmentRun& run = f.runs[r];
        const DepthPlane plane = run.depth;  // a copy, which what is stored cannot alias
        const whole id(run.primitive);
        real offsets[kMostBlocks];
        for (std::size_t s = 0; s < samples; s += L::kCount) {
            offsets[s / L::kCount] = sample_depth_offset<L>(plane, set, s);
        }
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            const std::size_t pixel = f.pixel[i];
            for (std::size_t s = 0; s < samples; s += L::kCount) {
                const real depth = sample_depth<L>(plane, offsets[s / L::kCount], f.depth[i]);
                visit(pixel, s,
                      Text::layer_of(sample_mask<L>(f, i, s), clear, depth, id,
                                     color_of<Text>(f, i), real(f.opacity[i])));
            }
        }
    }
}

// How a layer lies in memory: a precise depth is two floats, any other one.
template <class Text>
inline constexpr std::size_t kDepthChannels = sizeof(typename Text::depth_real) /
                                              sizeof(typename Text::real);
template <class Text>
inline constexpr std::size_t kLayerChannels = kDepthChannels<Text> + 5;

template <class Text>
HWY_INLINE typename Text::whole load_layer_id(const float* at, std::size_t samples)
{
    return Text::whole::bits_of(Text::real::load(at + kDepthChannels<Text> * samples));
}
template <class Text>
HWY_INLINE typename Text::Layer load_layer(const float* at, std::size_t samples)
{
    using real = typename Text::real;
    typename Text::Layer l;
    if constexpr (kDepthChannels<Text> == 1) {
        l.depth = real::load(at);
    } else {
        l.depth = {real::load(at), real::load(at + samples)};
    }
    constexpr std::size_t kId = kDepthChannels<Text>;
    l.id = load_layer_id<Text>(at, samples);
    l.color = load_color<Text>(at + (kId + 1) * samples, samples);
    l.opacity = real::load(at + (kId + 4) * samples);
    return l;
}
template <class Text>
HWY_INLINE void save_layer(const typename Text::Layer& l, float* at, std::size_t samples)
{
    if constexpr (kDepthChannels<Text> == 1) {
        l.depth.store(at);
    } else {
        l.depth.upper.store(at);
        l.depth.lower.store(at + samples);
    }
    constexpr std::size_t kId = kDepthChannels<Text>;
    l.id.as_real().store(at + kId * samples);
    save_color<Text>(l.color, at + (kId + 1) * samples, samples);
    l.opacity.store(at + (kId + 4) * samples);
}

// TextOf<L> has the words of layers.glsl. Layers come near to far; a pixel's first layers(pixel)
// have been written to, the others are clear.
template <int S, template <class> class TextOf>
class LayerStore {
public:
    using L = Lanes<S>;
    using Text = TextOf<L>;
    using Layer = typename Text::Layer;
    using real3 = typename Text::real3;
    using real = typename L::real;
    using whole = typename L::whole;
    using mask = typename L::mask;

    LayerStore(const StoreShape& shape, int most)
        : set_(*shape.samples),
          most_(static_cast<std::size_t>(most)),
          values_(kTilePixels * most_ * kLayerChannels<Text> * count())
    {
    }

    static HWY_INLINE real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    std::size_t count() const { return sample_count<S>(set_.count); }
    std::size_t most() const { return most_; }
    std::size_t layers(std::size_t pixel) const { return layers_[pixel]; }

    void clear() { std::fill_n(layers_, kTilePixels, 0u); }

    HWY_INLINE Layer load(std::size_t pixel, std::size_t layer, std::size_t s) const
    {
        return load_layer<Text>(values_.data() + index(pixel, layer) + s, count());
    }
    HWY_INLINE void save(const Layer& l, std::size_t pixel, std::size_t layer, std::size_t s)
    {
        save_layer<Text>(l, values_.data() + index(pixel, layer) + s, count());
    }

    // Puts fragments in their places. Where that is a layer too many, calls falls(pixel, s, layer)
    // with what is left behind the last, which is clear at samples that nothing fell from.
    template <class Falls>
    HWY_INLINE void insert(const FragmentStream& f, Falls&& falls)
    {
        for_each_layer<S, Text>(f, set_,
                                [&](std::size_t pixel, std::size_t s, const Layer& layer) HWY_ATTR {
                                    put(layer, pixel, s, falls);
                                    if (s + L::kCount >= count()) added(pixel);
                                });
    }

    // The same with the other's layers, near to far.
    template <class Falls>
    HWY_INLINE void merge(const LayerStore& other, Falls&& falls)
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            for (std::size_t layer = 0; layer < other.layers(pixel); ++layer) {
                for (std::size_t s = 0; s < count(); s += L::kCount) {
                    put(other.load(pixel, layer, s), pixel, s, falls);
                }
                added(pixel);
            }
        }
    }

    // All of them, one over the other.
    HWY_INLINE Layer all(std::size_t pixel, std::size_t s) const
    {
        Layer sum = Text::layer_clear(beyond_any());
        for (std::size_t layer = 0; layer < layers(pixel); ++layer) {
            sum = Text::layer_over(sum, load(pixel, layer, s));
        }
        return sum;
    }

    // Calls visit(pixel, s) for each vector of samples of a pixel that has layers.
    template <class Visit>
    HWY_INLINE void for_each(Visit&& visit) const
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (layers(pixel) == 0) continue;
            for (std::size_t s = 0; s < count(); s += L::kCount) visit(pixel, s);
        }
    }

private:
    // Layer by layer: most fragments touch the last of their pixel alone.
    std::size_t index(std::size_t pixel, std::size_t layer) const
    {
        return (layer * kTilePixels + pixel) * kLayerChannels<Text> * count();
    }
    HWY_INLINE void added(std::size_t pixel) { layers_[pixel] += layers_[pixel] < most_ ? 1 : 0; }

    template <class Falls>
    HWY_INLINE void put(const Layer& f, std::size_t pixel, std::size_t s, Falls&& falls)
    {
        const std::size_t number = layers(pixel);
        const Layer fallen = place(f, pixel, s);
        if (number < most_) {
            save(fallen, pixel, number, s);
        } else {
            falls(pixel, s, fallen);
        }
    }

    // layer_exchange with each of the pixel's layers, from the far end, as most fragments pass by
    // few of them. Returns what is left behind the last.
    HWY_INLINE Layer place(const Layer& f, std::size_t pixel, std::size_t s)
    {
        std::size_t layer = layers(pixel);
        if (layer == 0) return f;
        Layer here = load(pixel, --layer, s);
        mask in_front = Text::layer_in_front(f, here);
        if (!in_front.any()) return f;
        const Layer fallen = Text::layer_select(in_front, here, f);
        for (; layer > 0; --layer) {
            const Layer next = load(pixel, layer - 1, s);
            const mask in_front_of_next = Text::layer_in_front(f, next);
            if (!in_front_of_next.any()) break;
            here = Text::layer_select(in_front, f, here);
            save(Text::layer_select(in_front_of_next, next, here), pixel, layer, s);
            here = next;
            in_front = in_front_of_next;
        }
        save(Text::layer_select(in_front, f, here), pixel, layer, s);
        return fallen;
    }

    const SampleSet& set_;
    std::size_t most_;
    AlignedArray<float> values_;
    std::uint32_t layers_[kTilePixels] = {};
};

// Makes B of each sample that has layers: resolve(pixel, s, backdrop, transmittance).
template <class Layers, class Resolve>
HWY_INLINE void resolve_layers(const Layers& layers, SampleColors& backdrop, Resolve&& resolve)
{
    using Text = typename Layers::Text;
    layers.for_each([&](std::size_t pixel, std::size_t s) HWY_ATTR {
        resolve_samples<Text>(backdrop, pixel, s,
                              [&](typename Text::real3 behind, typename Text::real& transmittance)
                                  HWY_ATTR { return resolve(pixel, s, behind, transmittance); });
    });
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_LAYERS_INL_H
