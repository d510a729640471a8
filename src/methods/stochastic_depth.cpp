// Depth-based stochastic transparency: shaders/sheer/stochastic_depth.glsl at every sample.
//
// With more passes of samples than one, both passes of the text take turns, and the sums go on. 28
// bytes a sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/stochastic_depth.cpp"
#include "lanes/targets.h"

#include <limits>

#include <hwy/foreach_target.h>

#include "methods/stochastic_masks-inl.h"
#include "methods/total_alpha-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct StochasticDepthText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/alpha_correction.glsl"
#include "sheer/stochastic_depth.glsl"
};

template <int S>
struct StochasticDepthMethod {
    using L = Lanes<S>;
    using Text = StochasticDepthText<L>;
    using Store = typename Text::StochasticDepthStore;
    using real = typename L::real;
    using whole = typename L::whole;
    static constexpr int kChannels = 7;

    static HWY_INLINE real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    static HWY_INLINE Store clear() { return Text::stochastic_depth_clear(beyond_any()); }
    static HWY_INLINE Store merge(Store a, Store b) { return Text::stochastic_depth_merge(a, b); }
    static HWY_INLINE Store load(const float* at, std::size_t samples)
    {
        return {real::load(at), whole::bits_of(real::load(at + samples)),
                load_color<Text>(at + 2 * samples, samples), real::load(at + 5 * samples),
                real::load(at + 6 * samples)};
    }
    static HWY_INLINE void save_depth(const Store& s, float* at, std::size_t samples)
    {
        s.depth.store(at);
        s.id.as_real().store(at + samples);
    }
    static HWY_INLINE void save_sums(const Store& s, float* at, std::size_t samples)
    {
        save_color<Text>(s.color, at + 2 * samples, samples);
        s.weight.store(at + 5 * samples);
        s.transmittance.store(at + 6 * samples);
    }
    static HWY_INLINE void save(const Store& s, float* at, std::size_t samples)
    {
        save_depth(s, at, samples);
        save_sums(s, at, samples);
    }
};

template <int S>
struct StochasticDepthTile : SampleStore<S, StochasticDepthMethod<S>> {
    using Base = SampleStore<S, StochasticDepthMethod<S>>;
    using typename Base::L;
    using typename Base::real;
    using typename Base::real3;
    using typename Base::Text;
    using Method = StochasticDepthMethod<S>;

    const SampleSet& set;
    StochasticMasks masks;
    bool corrects;
    int pass = 0;  // even: depths; odd: sums

    explicit StochasticDepthTile(const StoreShape& shape)
        : Base(shape),
          set(*shape.samples),
          masks(shape),
          corrects(shape.method->value("correction") == "on")
    {
    }

    void clear(const TilePlace& place)
    {
        Base::clear(place);
        masks.clear(place);
        masks.begin_pass(0);
        pass = 0;
    }

    void insert(const FragmentStream& f, int of_pass)
    {
        if (of_pass != pass && of_pass % 2 == 0) {
            masks.begin_pass(of_pass / 2);
            this->for_each([&](std::size_t pixel, std::size_t s) HWY_ATTR {
                Method::save_depth(Method::clear(), at(pixel, s), this->count());
            });
        }
        pass = of_pass;
        if constexpr (S < 16) {
            insert_all<S>(f);
        } else {
            switch (set.count) {
                case 16: return insert_all<16>(f);
                case 32: return insert_all<32>(f);
                default: return insert_all<64>(f);
            }
        }
    }

    template <int Samples>
    void insert_all(const FragmentStream& f)
    {
        if (pass % 2 == 0) {
            masks.for_each_run<Samples>(f, [&](const FragmentRun& run, std::size_t k) HWY_ATTR {
                return insert_depths<Samples>(f, run, k);
            });
            return;
        }
        for (int r = 0; r < f.run_count; ++r) {
            // Total alpha is the same for all passes of samples.
            pass == 1 ? add_run<Samples, true>(f, f.runs[r])
                      : add_run<Samples, false>(f, f.runs[r]);
        }
    }

    template <int Samples>
    static constexpr std::size_t kBlocks = (Samples + L::kCount - 1) / L::kCount;

    template <int Samples>
    struct Offsets {
        real of_block[kBlocks<Samples>];

        HWY_INLINE Offsets(const DepthPlane& plane, const SampleSet& set)
        {
            for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
                of_block[b] = sample_depth_offset<L>(plane, set, b * L::kCount);
            }
        }
    };

    template <int Samples>
    HWY_INLINE std::size_t insert_depths(const FragmentStream& f, const FragmentRun& run,
                                         std::size_t k)
    {
        // Copies, which what is stored below cannot alias.
        const DepthPlane plane = run.depth;
        const Offsets<Samples> offsets(plane, set);
        const typename L::whole id(run.primitive);
        const std::size_t end = run.first + run.count;
        const float* depths = f.depth.data();
        const std::uint32_t* pixels = f.pixel.data();
        float *stores = this->values(), *far = masks.farthest.data();
        for (; masks.number(k) < end; ++k) {
            const std::size_t i = masks.number(k), pixel = pixels[i];
            real most;
            for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
                const std::size_t s = b * L::kCount;
                const real depth = sample_depth<L>(plane, offsets.of_block[b], depths[i]);
                float* place = stores + (Method::kChannels * pixel * Samples + s);
                typename Text::StochasticDepthStore store = Method::clear();
                store.depth = real::load(place);
                store.id = L::whole::bits_of(real::load(place + Samples));
                store = Text::stochastic_depth_insert(store, L::mask_of_bits(masks.word(k, s)),
                                                      depth, id);
                Method::save_depth(store, place, Samples);
                most = b == 0 ? store.depth : L::max(most, store.depth);
            }
            far[pixel] = most.greatest();
        }
        return k;
    }

    template <int Samples, bool WithTotalAlpha>
    HWY_INLINE void add_run(const FragmentStream& f, const FragmentRun& run)
    {
        const DepthPlane plane = run.depth;
        const Offsets<Samples> offsets(plane, set);
        const typename L::whole id(run.primitive);
        const float *depths = f.depth.data(), *opacities = f.opacity.data();
        const float *red = f.red.data(), *green = f.green.data(), *blue = f.blue.data();
        const std::uint32_t *pixels = f.pixel.data(), *low = f.samples.data();
        const std::uint32_t* high = f.samples_high.data();
        float* stores = this->values();
        const std::size_t end = run.first + run.count;
        for (std::size_t i = run.first; i < end; ++i) {
            const real3 color = {real(red[i]), real(green[i]), real(blue[i])};
            const real opacity(opacities[i]);
            float* of_pixel = stores + Method::kChannels * pixels[i] * Samples;
            for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
                const std::size_t s = b * L::kCount;
                const auto covered = L::mask_of_bits((s < 32 ? low[i] : high[i]) >> (s & 31));
                const real depth = sample_depth<L>(plane, offsets.of_block[b], depths[i]);
                auto store = Text::stochastic_depth_add(Method::load(of_pixel + s, Samples),
                                                        covered, depth, id, color, opacity);
                if constexpr (WithTotalAlpha) {
                    store.transmittance =
                        Text::total_alpha_insert(store.transmittance, covered, opacity);
                }
                Method::save_sums(store, of_pixel + s, Samples);
            }
        }
    }

    HWY_INLINE float* at(std::size_t pixel, std::size_t s)
    {
        return this->values() + Method::kChannels * pixel * this->count() + s;
    }

    void resolve(SampleColors& backdrop) const
    {
        const real part(1.0f / static_cast<float>(masks.settings.passes));
        this->for_each([&](std::size_t pixel, std::size_t s) HWY_ATTR {
            const auto store = this->load(pixel, s);
            if (corrects) {
                return dim_backdrop<Text>(backdrop, pixel, s, store.transmittance, store.color,
                                          store.weight);
            }
            resolve_samples<Text>(backdrop, pixel, s,
                                  [&](real3 behind, real& transmittance) HWY_ATTR {
                                      transmittance = store.transmittance;
                                      return Text::over(part * store.color, transmittance, behind);
                                  });
        });
    }
};

StoreVerbs stochastic_depth_store(int samples)
{
    return verbs_for_samples<StochasticDepthTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(stochastic_depth_store);

StoreVerbs stochastic_depth_verbs(TargetSet targets, int samples)
{
    return SHEER_DISPATCH(stochastic_depth_store, targets)(samples);
}

}  // namespace sheer
#endif
