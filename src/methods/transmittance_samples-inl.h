// A method that approximates transmittance (shaders/sheer/transmittance.glsl), at every sample of a
// tile. Lanes are samples.
//
// Function says what is added up for a fragment, what is kept of the sums, and what that says:
//   kSums, of which the first is that of the optical depths; kState
//   addends<W>(place, depth, addends)           the kSums numbers of fragments
//   prepare<W>(sums, state, stride)             kState floats, `stride` from one to the next
//   transmittance<L>(state, place)              state[k]: what was kept; state.at(k): if k is whole
//   prepare_again<W>(sums, state, stride)       of a second pass over the sums, if there is one
// W are lanes of doubles. Where a fragment adds to few of the sums (SparseFunction) there is
//   kTouched                                    and instead of kSums numbers
//   addends_of_one(place, depth, addends, sums) as many, and where they belong
// A sample takes 8 bytes for each sum (4 sums at least), 4 for each float kept, 4 for the
// transmittance of all, and 20 for what is opaque.
#if defined(SHEER_TRANSMITTANCE_SAMPLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_TRANSMITTANCE_SAMPLES_INL_H
#undef SHEER_TRANSMITTANCE_SAMPLES_INL_H
#else
#define SHEER_TRANSMITTANCE_SAMPLES_INL_H
#endif

#include "methods/pixel_functions-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S, class Function>
class TransmittanceSamples {
    using L = Lanes<S>;
    using W = WideLanes<(S < 8 ? S : 8)>;
    using Text = TransmittanceText<L>;
    using real3 = typename Text::real3;
    using real = typename L::real;
    static constexpr std::size_t kSums = Function::kSums > 4 ? Function::kSums : 4;
    static constexpr std::size_t kState = Function::kState;

public:
    explicit TransmittanceSamples(const StoreShape& shape)
        : set_(*shape.samples),
          function_(*shape.method),
          moment_passes_(function_.passes()),
          fragments_(shape),
          sums_(kTilePixels * kSums * count()),
          state_(kTilePixels * (kState + 1) * count())
    {
    }

    void clear(const TilePlace&)
    {
        fragments_.clear();
        std::fill_n(sums_.data(), sums_.size(), std::int64_t{0});
        pass_ = 0;
    }

    void insert(const FragmentStream& f, int pass)
    {
        for (; pass_ < pass; ++pass_) finish_pass();
        if (pass == 0) return fragments_.look(f);
        fragments_.see(f);
        with_sample_count<S>(set_.count, [&](auto samples) HWY_ATTR {
            if (pass == 1) {
                add_depths<samples>(f);
            } else if (pass > moment_passes_) {
                add_colors<samples>(f);
            } else if constexpr (PreparesAgain<Function, W>) {
                add_seen_depths<samples>(f);
            }
        });
    }

    // After the same pass, or before any of the other's.
    void merge(const TransmittanceSamples& other)
    {
        fragments_.merge(other.fragments_);
        add_all(other.sums_, sums_);
    }

    void resolve(SampleColors& backdrop)
    {
        for (; pass_ <= moment_passes_; ++pass_) finish_pass();
        const ExactGrid weights(-kColorBits), colors = fragments_.color_grid();
        for_each_touched<L>([&](std::size_t pixel, std::size_t s) HWY_ATTR {
            const std::int64_t* sums = sums_of(pixel, s);
            const real3 color{exact_sum_as_float<L, W>(sums, colors),
                              exact_sum_as_float<L, W>(sums + count(), colors),
                              exact_sum_as_float<L, W>(sums + 2 * count(), colors)};
            const real weight = exact_sum_as_float<L, W>(sums + 3 * count(), weights);
            const real through = real::load(state_of(pixel, s) + kState * count());
            resolve_samples<Text>(backdrop, pixel, s,
                                  [&](real3 behind, real& transmittance) HWY_ATTR {
                                      transmittance = through;
                                      behind = fragments_.behind(behind, pixel, s, transmittance);
                                      return Text::visible_resolve(color, weight, through, behind);
                                  });
        });
    }

    float transmittance_at(std::size_t pixel, float depth)
    {
        for (; pass_ <= moment_passes_; ++pass_) finish_pass();
        alignas(64) float lights[kMaxSamples];
        find_transmittances(pixel, fragments_.place(depth), lights);
        return mean_over_samples<L>(count(), [&](std::size_t s) HWY_ATTR {
            return fragments_.shown(real::load(lights + s), pixel, s, depth);
        });
    }

private:
    std::size_t count() const { return sample_count<S>(set_.count); }
    std::int64_t* sums_of(std::size_t pixel, std::size_t s)
    {
        return sums_.data() + pixel * kSums * count() + s;
    }
    float* state_of(std::size_t pixel, std::size_t s)
    {
        return state_.data() + pixel * (kState + 1) * count() + s;
    }
    // Calls visit(pixel, s) for each vector of samples of a pixel that has fragments.
    template <class Vector, class Visit>
    HWY_INLINE void for_each_touched(Visit&& visit)
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (!fragments_.touched(pixel)) continue;
            for (std::size_t s = 0; s < count(); s += Vector::kCount) visit(pixel, s);
        }
    }

    void finish_pass()
    {
        if (pass_ == 0) return;
        using Floats = Lanes<W::kCount>;
        const ExactGrid grid(-kDepthBits);
        const bool first = pass_ == 1;
        for_each_touched<W>([&](std::size_t pixel, std::size_t s) HWY_ATTR {
            typename W::real sums[Function::kSums];
            std::int64_t* at = sums_of(pixel, s);
            for (std::size_t k = 0; k < Function::kSums; ++k) {
                sums[k] = exact_sum<W>(at + k * count(), grid);
            }
            for (std::size_t k = 0; k < kSums; ++k) {
                typename W::whole(std::int64_t{0}).store(at + k * count());
            }
            float* state = state_of(pixel, s);
            if constexpr (PreparesAgain<Function, W>) {
                if (!first) return function_.template prepare_again<W>(sums, state, count());
            }
            function_.template prepare<W>(sums, state, count());
            float* through = state + kState * count();
            sums[0].store(through);
            using Alike = TransmittanceText<Floats>;
            const auto depth = Floats::real::load(through);
            Alike::exp_of(typename Floats::real(0.0f) - depth).store(through);
        });
    }

    // What each fragment adds is the same for all its samples.
    template <int Samples>
    HWY_INLINE void add_depths(const FragmentStream& f)
    {
        using Block = Lanes<16>;
        alignas(64) float depths[kChunk];
        FragmentUnits<Function, kChunk> units;
        const auto size = static_cast<std::size_t>(f.size);
        for (std::size_t first = 0; first < size; first += kChunk) {
            const std::size_t some = std::min(kChunk, size - first);
            for (std::size_t i = 0; i < some; i += Block::kCount) {
                TransmittanceText<Block>::optical_depth(
                    Block::real::load(f.opacity.data() + first + i))
                    .store(depths + i);
            }
            units.set(function_, fragments_.places() + first, depths, some);
            for (std::size_t i = 0; i < some; ++i) add_units<Samples>(f, first + i, units, i);
        }
    }
    template <int Samples>
    HWY_INLINE void add_units(const FragmentStream& f, std::size_t i,
                              const FragmentUnits<Function, kChunk>& units, std::size_t in_chunk)
    {
        std::int64_t* sums = sums_.data() + f.pixel[i] * kSums * Samples;
        for (std::size_t s = 0; s < Samples; s += W::kCount) {
            const auto shown = W::mask_of_bits(fragments_.samples(f, i, s));
            for (std::size_t k = 0; k < units.kCount; ++k) {
                std::int64_t* at = sums + units.sum(k, in_chunk) * Samples + s;
                const typename W::whole addend(units.unit(k, in_chunk));
                (W::whole::load(at) + W::zero_unless(shown, addend)).store(at);
            }
        }
    }

    // The second time the opacities are those that are seen.
    template <int Samples>
    HWY_INLINE void add_seen_depths(const FragmentStream& f)
    {
        const ExactGrid grid(-kDepthBits);
        for (std::size_t i = 0; i < static_cast<std::size_t>(f.size); ++i) {
            std::int64_t* sums = sums_.data() + f.pixel[i] * kSums * Samples;
            const typename W::real place(static_cast<double>(fragments_.places()[i]));
            alignas(64) float values[kMaxSamples];
            find_transmittances(f.pixel[i], fragments_.places()[i], values);
            for (std::size_t s = 0; s < Samples; s += L::kCount) {
                const real seen = L::zero_unless(L::mask_of_bits(fragments_.samples(f, i, s)),
                                                 real(f.opacity[i]) * real::load(values + s));
                Text::optical_depth(seen).store(values + s);
            }
            for (std::size_t s = 0; s < Samples; s += W::kCount) {
                typename W::real addends[Function::kSums];
                function_.template addends<W>(place, W::real::load(values + s), addends);
                for (std::size_t k = 0; k < Function::kSums; ++k) {
                    std::int64_t* at = sums + k * Samples + s;
                    (W::whole::load(at) + exact_units<W>(addends[k], grid)).store(at);
                }
            }
        }
    }

    template <int Samples>
    HWY_INLINE void add_colors(const FragmentStream& f)
    {
        const ExactGrid weights(-kColorBits), colors = fragments_.color_grid();
        for (std::size_t i = 0; i < static_cast<std::size_t>(f.size); ++i) {
            std::int64_t* sums = sums_.data() + f.pixel[i] * kSums * Samples;
            alignas(64) float through[kMaxSamples];
            find_transmittances(f.pixel[i], fragments_.places()[i], through);
            for (std::size_t s = 0; s < Samples; s += L::kCount) {
                const real weight = L::zero_unless(
                    L::mask_of_bits(fragments_.samples(f, i, s)),
                    Text::visible_alpha(real::load(through + s), real(f.opacity[i])));
                const real3 color = weight * color_of<Text>(f, i);
                add_exactly<L, W>(color.x, colors, sums + s);
                add_exactly<L, W>(color.y, colors, sums + Samples + s);
                add_exactly<L, W>(color.z, colors, sums + 2 * Samples + s);
                add_exactly<L, W>(weight, weights, sums + 3 * Samples + s);
            }
        }
    }

    // What is kept for samples s, s + 1, ... of a pixel.
    struct State {
        const float* from;
        std::size_t count;

        HWY_INLINE real operator[](std::size_t k) const { return real::load(from + k * count); }
        // The same of all lanes.
        HWY_INLINE real at(typename L::whole k) const
        {
            return real::load(from + static_cast<std::size_t>(k.first()) * count);
        }
    };
    // At all samples of a pixel. The longest of a store's code, and there but once.
    HWY_NOINLINE void find_transmittances(std::size_t pixel, float place, float* values) const
    {
        const real at(place);
        const float* from = state_.data() + pixel * (kState + 1) * count();
        for (std::size_t s = 0; s < count(); s += L::kCount) {
            function_.template transmittance<L>(State{from + s, count()}, at).store(values + s);
        }
    }

    const SampleSet& set_;
    Function function_;
    int moment_passes_;
    int pass_ = 0;  // that was last: 0 of looking, then those of sums, then colours
    TranslucentFragments<S> fragments_;
    AlignedArray<std::int64_t> sums_;
    AlignedArray<float> state_;
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_TRANSMITTANCE_SAMPLES_INL_H
