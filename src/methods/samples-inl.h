// What stores with lanes over a pixel's samples share.
#if defined(SHEER_SAMPLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SAMPLES_INL_H
#undef SHEER_SAMPLES_INL_H
#else
#define SHEER_SAMPLES_INL_H
#endif

#include <type_traits>

#include "lanes/lanes-inl.h"
#include "lanes/text.h"
#include "methods/method.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Samples s, s + 1, ... that fragment i covers.
template <class L, class Stream>
HWY_INLINE typename L::mask sample_mask(const Stream& f, std::size_t i, std::size_t s)
{
    const std::uint32_t word = s < 32 ? f.samples[i] : f.samples_high[i];
    return L::mask_of_bits(word >> (s & 31));
}

// Where a stream's numbers are: copies in registers, which what a store writes can't be taken for.
struct StreamColumns {
    const std::uint32_t *pixel, *samples, *samples_high;
    const float *red, *green, *blue, *opacity;

    explicit StreamColumns(const FragmentStream& f)
        : pixel(f.pixel.data()),
          samples(f.samples.data()),
          samples_high(f.samples_high.data()),
          red(f.red.data()),
          green(f.green.data()),
          blue(f.blue.data()),
          opacity(f.opacity.data())
    {
    }
};

// Three channels of the same samples.
template <class Text>
HWY_INLINE typename Text::real3 load_color(const float* at, std::size_t samples)
{
    using real = typename Text::real;
    return {real::load(at), real::load(at + samples), real::load(at + 2 * samples)};
}
template <class Text>
HWY_INLINE void save_color(typename Text::real3 color, float* at, std::size_t samples)
{
    color.x.store(at);
    color.y.store(at + samples);
    color.z.store(at + 2 * samples);
}

// Makes B of a sample, in front of which what a store keeps lets the part `transmittance` through.
template <class Text, class Resolve>
HWY_INLINE void resolve_samples(SampleColors& backdrop, std::size_t pixel, std::size_t s,
                                Resolve&& resolve)
{
    using real = typename Text::real;
    const auto samples = static_cast<std::size_t>(backdrop.samples);
    float* color = backdrop.channel(pixel, 0) + s;
    float* alpha = backdrop.channel(pixel, 3) + s;
    real transmittance;
    const auto result = resolve(load_color<Text>(color, samples), transmittance);
    save_color<Text>(result, color, samples);
    Text::over_alpha(transmittance, real::load(alpha)).store(alpha);
}

// S, which 16 stands for too where there are more.
template <int S>
HWY_INLINE std::size_t sample_count(int samples)
{
    return static_cast<std::size_t>(S < 16 ? S : samples);
}

// Calls visit(pixel, s) for each vector of samples of a tile.
template <int S, class Visit>
HWY_INLINE void for_each_vector(int samples, Visit&& visit)
{
    for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
        for (std::size_t s = 0; s < sample_count<S>(samples); s += Lanes<S>::kCount) {
            visit(pixel, s);
        }
    }
}

// Of value(s) at samples s, s + 1, ..., added up in their order.
template <class L, class Value>
HWY_INLINE float mean_over_samples(std::size_t count, Value&& value)
{
    double sum = 0;
    for (std::size_t s = 0; s < count; s += L::kCount) {
        alignas(64) float values[16];
        value(s).store(values);
        for (std::size_t i = 0; i < L::kCount; ++i) sum += static_cast<double>(values[i]);
    }
    return static_cast<float>(sum / static_cast<double>(count));
}

// Calls visit with the number of samples as a constant, which unrolls.
template <int S, class Visit>
HWY_INLINE void with_sample_count(int samples, Visit&& visit)
{
    if constexpr (S < 16) {
        visit(std::integral_constant<int, S>());
    } else {
        switch (samples) {
            case 16: return visit(std::integral_constant<int, 16>());
            case 32: return visit(std::integral_constant<int, 32>());
            default: return visit(std::integral_constant<int, 64>());
        }
    }
}

// A text's store at every sample of a tile. Method names the text's store and verbs and says how
// the store lies in kChannels floats a sample:
//   Text, Store, kChannels, clear(), merge(a, b), resolve(store, backdrop, transmittance),
//   load(at, samples), save(store, at, samples)
template <int S, class Method>
struct SampleStore {
    using Text = typename Method::Text;
    using L = typename Method::L;
    using real = typename L::real;
    using mask = typename L::mask;
    using real3 = typename Text::real3;

    SampleValues<Method::kChannels> kept;

    explicit SampleStore(int samples) : kept(samples) {}
    explicit SampleStore(const StoreShape& shape) : SampleStore(shape.samples->count) {}

    // Calls visit(pixel, s) for each vector of samples of the tile.
    template <class Visit>
    HWY_INLINE void for_each(Visit&& visit) const
    {
        for_each_vector<S>(kept.samples, visit);
    }
    HWY_INLINE std::size_t count() const { return sample_count<S>(kept.samples); }
    HWY_INLINE float* values() { return kept.values.data(); }
    HWY_INLINE const float* values() const { return kept.values.data(); }
    HWY_INLINE auto load(std::size_t pixel, std::size_t s) const
    {
        return Method::load(values() + Method::kChannels * pixel * count() + s, count());
    }
    HWY_INLINE void save(const typename Method::Store& store, std::size_t pixel, std::size_t s)
    {
        Method::save(store, values() + Method::kChannels * pixel * count() + s, count());
    }

    void clear(const TilePlace& = {})
    {
        for_each([&](std::size_t pixel, std::size_t s)
                     HWY_ATTR { save(Method::clear(), pixel, s); });
    }
    void merge(const SampleStore& other)
    {
        for_each([&](std::size_t pixel, std::size_t s) HWY_ATTR {
            save(Method::merge(load(pixel, s), other.load(pixel, s)), pixel, s);
        });
    }
    void resolve(SampleColors& backdrop) const
    {
        for_each([&](std::size_t pixel, std::size_t s) HWY_ATTR {
            const auto store = load(pixel, s);
            resolve_samples<Text>(backdrop, pixel, s,
                                  [&](real3 behind, real& transmittance) HWY_ATTR {
                                      return Method::resolve(store, behind, transmittance);
                                  });
        });
    }

    // Replaces the store at the samples of each fragment i's pixel by add(columns, i, store,
    // covered).
    // Two fragments at a time, which takes a fourth less: no two of a run share a pixel, and a load
    // need not wait for the store before it to show that it went elsewhere.
    template <class Add>
    HWY_INLINE void update(const FragmentStream& f, Add&& add)
    {
        with_sample_count<S>(kept.samples, [&](auto samples) HWY_ATTR {
            const StreamColumns columns(f);
            for (int r = 0; r < f.run_count; ++r) update_run<samples>(columns, f.runs[r], add);
        });
    }

private:
    template <int Samples, class Add>
    HWY_INLINE void update_run(const StreamColumns f, const FragmentRun& run, const Add add)
    {
        float* to = values();
        const std::size_t end = run.first + run.count;
        std::size_t i = run.first;
        for (; i + 2 <= end; i += 2) update_some<Samples, 2>(f, i, add, to);
        if (i < end) update_some<Samples, 1>(f, i, add, to);
    }
    // Fragments i, i + 1, ...
    template <int Samples, int Some, class Add>
    static HWY_INLINE void update_some(const StreamColumns& f, std::size_t i, const Add& add,
                                       float* to)
    {
        for (std::size_t s = 0; s < Samples; s += L::kCount) {
            float* at[Some];
            typename Method::Store stores[Some];
            for (std::size_t k = 0; k < Some; ++k) {
                at[k] = to + Method::kChannels * f.pixel[i + k] * Samples + s;
                stores[k] =
                    add(f, i + k, Method::load(at[k], Samples), sample_mask<L>(f, i + k, s));
            }
            for (std::size_t k = 0; k < Some; ++k) Method::save(stores[k], at[k], Samples);
        }
    }
};

template <class Text, class Stream>
HWY_INLINE typename Text::real3 color_of(const Stream& f, std::size_t i)
{
    using real = typename Text::real;
    return {real(f.red[i]), real(f.green[i]), real(f.blue[i])};
}

// The verbs of Store<S> with S = min(samples, 16) lanes; more samples are a loop in the store.
template <template <int> class Store>
StoreVerbs verbs_for_samples(int samples)
{
    switch (samples) {
        case 1: return verbs_of<Store<1>>();
        case 2: return verbs_of<Store<2>>();
        case 4: return verbs_of<Store<4>>();
        case 8: return verbs_of<Store<8>>();
        default: return verbs_of<Store<16>>();
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SAMPLES_INL_H
