// A method that approximates transmittance (shaders/sheer/transmittance.glsl), with one function
// for each pixel of a tile; transmittance_samples-inl.h says what Function is. Lanes are fragments.
//
// Where pixels have several samples, a fragment's optical depth counts in proportion to those that
// it covers, so that the triangles of a surface make no seams; what all let through is exact at
// each sample, and colours are divided by their weights after the filter. A pixel takes 8 bytes for
// each sum (4 at least) and 4 for each float kept, and each of its samples 8 for what all let
// through and 20 for what is opaque.
#if defined(SHEER_TRANSMITTANCE_PIXELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_TRANSMITTANCE_PIXELS_INL_H
#undef SHEER_TRANSMITTANCE_PIXELS_INL_H
#else
#define SHEER_TRANSMITTANCE_PIXELS_INL_H
#endif

#include <bit>

#include "methods/transmittance_samples-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S, class Function>
class TransmittancePixels {
    using L = Lanes<S>;
    using W = WideLanes<(S < 8 ? S : 8)>;
    using Block = Lanes<16>;  // of fragments
    using Wide = WideLanes<8>;
    using Real = Block::real;
    using BlockText = TransmittanceText<Block>;
    using Text = TransmittanceText<L>;
    using real3 = typename Text::real3;
    using real = typename L::real;
    static constexpr std::size_t kOfFunction = Function::kSums, kState = Function::kState;
    static constexpr std::size_t kSums = kOfFunction > 4 ? kOfFunction : 4;

public:
    explicit TransmittancePixels(const StoreShape& shape)
        : set_(*shape.samples),
          divides_(shape.method->traits().divides),
          function_(*shape.method),
          moment_passes_(function_.passes()),
          fragments_(shape),
          sums_(kTilePixels * kSums),
          state_(kTilePixels * kState),
          depths_(kTilePixels * count())
    {
    }

    void clear(const TilePlace&)
    {
        fragments_.clear();
        std::fill_n(sums_.data(), sums_.size(), std::int64_t{0});
        std::fill_n(depths_.data(), depths_.size(), std::int64_t{0});
        pass_ = 0;
    }

    void insert(const FragmentStream& f, int pass)
    {
        for (; pass_ < pass; ++pass_) finish_pass();
        if (pass == 0) return fragments_.look(f);
        fragments_.see(f);
        const bool is_last = pass > moment_passes_;
        const auto size = static_cast<std::size_t>(f.size);
        for (std::size_t first = 0; first < size; first += kChunk) {
            const std::size_t some = std::min(kChunk, size - first);
            find_parts(f, first, some);
            is_last ? add_colors(f, first, some) : add_depths(f, first, some, pass == 1);
        }
    }

    // After the same pass, or before any of the other's.
    void merge(const TransmittancePixels& other)
    {
        fragments_.merge(other.fragments_);
        add_all(other.sums_, sums_);
        add_all(other.depths_, depths_);
    }

    void resolve(SampleColors& backdrop)
    {
        for (; pass_ <= moment_passes_; ++pass_) finish_pass();
        const ExactGrid weights(-kColorBits), colors = fragments_.color_grid();
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (!fragments_.touched(pixel)) {
                // What the last tile left there.
                if (divides_) std::fill_n(backdrop.fraction.channel(pixel, 0), 5 * count(), 0.0f);
                continue;
            }
            const std::int64_t* sums = sums_.data() + pixel * kSums;
            const auto sum = [&](std::size_t c, const ExactGrid& grid) {
                return real(static_cast<float>(static_cast<double>(sums[c]) * grid.unit));
            };
            const real3 color{sum(0, colors), sum(1, colors), sum(2, colors)};
            const real weight = sum(3, weights);
            for (std::size_t s = 0; s < count(); s += L::kCount) {
                resolve(backdrop, pixel, s, color, weight);
            }
        }
    }

    float transmittance_at(std::size_t pixel, float depth)
    {
        for (; pass_ <= moment_passes_; ++pass_) finish_pass();
        const State<Block> state{state_.data(), Block::whole(static_cast<std::uint32_t>(pixel))};
        const float light =
            function_.template transmittance<Block>(state, Real(fragments_.place(depth)))
                .greatest();
        return mean_over_samples<L>(count(), [&](std::size_t s) HWY_ATTR {
            return fragments_.shown(real(light), pixel, s, depth);
        });
    }

private:
    std::size_t count() const { return sample_count<S>(set_.count); }

    HWY_INLINE void resolve(SampleColors& backdrop, std::size_t pixel, std::size_t s, real3 color,
                            real weight) const
    {
        const real depth =
            exact_sum_as_float<L, W>(depths_.data() + pixel * count() + s, ExactGrid(-kDepthBits));
        const real through = Text::exp_of(real(0.0f) - depth);
        resolve_samples<Text>(backdrop, pixel, s, [&](real3 behind, real& transmittance) HWY_ATTR {
            transmittance = through;
            behind = fragments_.behind(behind, pixel, s, transmittance);
            if (divides_) return through * behind;
            return Text::visible_resolve(color, weight, through, behind);
        });
        if (!divides_) return;
        float* at = backdrop.fraction.channel(pixel, 0) + s;
        save_color<Text>(color, at, count());
        weight.store(at + 3 * count());
        (real(1.0f) - through).store(at + 4 * count());
    }

    void finish_pass()
    {
        if (pass_ == 0) return;
        const ExactGrid grid(-kDepthBits);
        for (std::size_t pixel = 0; pixel < kTilePixels; pixel += Wide::kCount) {
            alignas(64) std::int64_t units[kOfFunction][Wide::kCount];
            bool any = false;
            for (std::size_t i = 0; i < Wide::kCount; ++i) {
                std::int64_t* at = sums_.data() + (pixel + i) * kSums;
                any = any || fragments_.touched(pixel + i);
                for (std::size_t k = 0; k < kOfFunction; ++k) units[k][i] = at[k];
                if (S == 1 && pass_ == 1) depths_[pixel + i] = at[0];
                std::fill_n(at, kSums, std::int64_t{0});
            }
            if (!any) continue;
            typename Wide::real sums[kOfFunction];
            for (std::size_t k = 0; k < kOfFunction; ++k) sums[k] = exact_sum<Wide>(units[k], grid);
            float* state = state_.data() + pixel;
            if constexpr (requires {
                              function_.template prepare_again<Wide>(sums, state, kTilePixels);
                          }) {
                if (pass_ > 1) {
                    function_.template prepare_again<Wide>(sums, state, kTilePixels);
                    continue;
                }
            }
            function_.template prepare<Wide>(sums, state, kTilePixels);
        }
    }

    // What part of its pixel's samples each fragment counts at.
    HWY_INLINE void find_parts(const FragmentStream& f, std::size_t first, std::size_t some)
    {
        const float part = 1.0f / static_cast<float>(count());
        for (std::size_t i = 0; i < some; ++i) {
            int samples = 0;
            for (std::size_t s = 0; s < count(); s += 32) {
                const std::uint32_t bits = fragments_.samples(f, first + i, s);
                samples += std::popcount(count() < 32 ? bits & ((1u << count()) - 1u) : bits);
            }
            parts_[i] = static_cast<float>(samples) * part;
        }
    }

    // Or, the second time, of the opacities that are seen.
    HWY_INLINE void add_depths(const FragmentStream& f, std::size_t first, std::size_t some,
                               bool is_first)
    {
        alignas(64) float depths[kChunk];
        for (std::size_t i = 0; i < some; i += Block::kCount) {
            const Real opacity = Real::load(f.opacity.data() + first + i);
            const Real seen = is_first ? opacity : opacity * transmittances(f, first + i);
            const Real depth = BlockText::optical_depth(seen);
            depth.store(depths + i);
            if (is_first && S > 1) add_to_samples(f, first, i, some, depths);
            (depth * Real::load(parts_ + i)).store(depths + i);
        }
        FragmentUnits<Function, kChunk> units;
        units.set(function_, fragments_.places() + first, depths, some);
        for (std::size_t i = 0; i < some; ++i) {
            std::int64_t* at = sums_.data() + f.pixel[first + i] * kSums;
            for (std::size_t k = 0; k < units.kCount; ++k) {
                std::int64_t& sum = at[units.sum(k, i)];
                sum = add_wrapping(sum, units.units[k][i]);
            }
        }
    }

    HWY_INLINE void add_to_samples(const FragmentStream& f, std::size_t first, std::size_t i,
                                   std::size_t some, const float* depths)
    {
        const ExactGrid grid(-kDepthBits);
        alignas(64) std::int64_t units[Block::kCount];
        for (std::size_t j = 0; j < Block::kCount; j += Wide::kCount) {
            exact_units<Wide>(Wide::real::load(depths + i + j), grid).store(units + j);
        }
        for (std::size_t j = 0; j < Block::kCount && i + j < some; ++j) {
            const std::size_t fragment = first + i + j;
            std::int64_t* at = depths_.data() + f.pixel[fragment] * count();
            for (std::size_t s = 0; s < count(); s += W::kCount) {
                const auto shown = W::mask_of_bits(fragments_.samples(f, fragment, s));
                const auto addend = W::zero_unless(shown, typename W::whole(units[j]));
                (W::whole::load(at + s) + addend).store(at + s);
            }
        }
    }

    HWY_INLINE void add_colors(const FragmentStream& f, std::size_t first, std::size_t some)
    {
        const ExactGrid weights(-kColorBits), colors = fragments_.color_grid();
        alignas(64) std::int64_t units[4][kChunk];
        for (std::size_t i = 0; i < some; i += Block::kCount) {
            const Real opacity = Real::load(f.opacity.data() + first + i);
            const Real weight = BlockText::visible_alpha(transmittances(f, first + i), opacity) *
                                Real::load(parts_ + i);
            const auto add = [&](std::size_t c, Real x, const ExactGrid& grid) HWY_ATTR {
                alignas(64) float values[Block::kCount];
                x.store(values);
                for (std::size_t j = 0; j < Block::kCount; j += Wide::kCount) {
                    exact_units<Wide>(Wide::real::load(values + j), grid).store(units[c] + i + j);
                }
            };
            add(0, weight * Real::load(f.red.data() + first + i), colors);
            add(1, weight * Real::load(f.green.data() + first + i), colors);
            add(2, weight * Real::load(f.blue.data() + first + i), colors);
            add(3, weight, weights);
        }
        for (std::size_t i = 0; i < some; ++i) {
            std::int64_t* at = sums_.data() + f.pixel[first + i] * kSums;
            for (std::size_t k = 0; k < 4; ++k) at[k] = add_wrapping(at[k], units[k][i]);
        }
    }

    // What is kept for pixels, one a lane.
    template <class Vector>
    struct State {
        const float* from;
        typename Vector::whole pixels;

        HWY_INLINE typename Vector::real operator[](std::size_t k) const
        {
            return Vector::gather(from + k * kTilePixels, pixels);
        }
        HWY_INLINE typename Vector::real at(typename Vector::whole k) const
        {
            return Vector::gather(from, (k << 10) + pixels);
        }
    };
    static_assert(kTilePixels == 1 << 10);
    // Of fragments i, i + 1, ...
    HWY_INLINE Real transmittances(const FragmentStream& f, std::size_t i) const
    {
        // What lies past the stream's end may be any number.
        const auto pixels = Block::whole::load(f.pixel.data() + i) &
                            Block::whole(static_cast<std::uint32_t>(kTilePixels - 1));
        return function_.template transmittance<Block>(State<Block>{state_.data(), pixels},
                                                       Real::load(fragments_.places() + i));
    }

    const SampleSet& set_;
    bool divides_;
    Function function_;
    int moment_passes_;
    int pass_ = 0;  // that was last: 0 of looking, then those of sums, then colours
    TranslucentFragments<S> fragments_;
    AlignedArray<std::int64_t> sums_;
    AlignedArray<float> state_;
    AlignedArray<std::int64_t> depths_;  // of each sample
    alignas(64) float parts_[kChunk] = {};
};

// The store of a function: a fragment a lane where a pixel has one sample.
template <class Function>
struct StoreOf {
    template <int S>
    using Samples = TransmittanceSamples<S, Function>;

    static StoreVerbs make(int samples)
    {
        if (samples == 1) return verbs_of<TransmittancePixels<1, Function>>();
        switch (samples) {
            case 2: return verbs_of<Samples<2>>();
            case 4: return verbs_of<Samples<4>>();
            case 8: return verbs_of<Samples<8>>();
            default: return verbs_of<Samples<16>>();
        }
    }
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_TRANSMITTANCE_PIXELS_INL_H
