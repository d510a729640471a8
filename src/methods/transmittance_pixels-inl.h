// A method that approximates transmittance (shaders/sheer/transmittance.glsl), with one function
// for each pixel of a tile: pixel_functions-inl.h, and what each sample has of its own.
//
// Where pixels have several samples, a fragment's optical depth counts in proportion to those that
// it covers, so that the triangles of a surface make no seams; what all let through is exact at
// each sample, and colours are divided by their weights after the filter. A sample takes 8 bytes
// for what all let through and 20 for what is opaque.
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

// What the samples of a tile's pixels have, whatever the function.
template <int S>
class PixelSamples {
    using L = Lanes<S>;
    using W = WideLanes<(S < 8 ? S : 8)>;
    using Wide = WideLanes<8>;
    using Text = TransmittanceText<L>;
    using real3 = typename Text::real3;
    using real = typename L::real;

public:
    explicit PixelSamples(const StoreShape& shape)
        : fragments(shape),
          set_(*shape.samples),
          divides_(shape.method->traits().divides),
          depths_(kTilePixels * count())
    {
    }

    TranslucentFragments<S> fragments;

    void clear()
    {
        fragments.clear();
        std::fill_n(depths_.data(), depths_.size(), std::int64_t{0});
    }
    void merge(const PixelSamples& other)
    {
        fragments.merge(other.fragments);
        add_all(other.depths_, depths_);
    }
    // Of each sample what all let through, as optical depth.
    std::int64_t* depths() { return depths_.data(); }

    // Which part of its pixel's samples each fragment counts at; null if that is all.
    HWY_NOINLINE const float* parts(const FragmentStream& f, std::size_t first, std::size_t some)
    {
        if (S == 1 && !fragments.any_opaque()) return nullptr;
        const float part = 1.0f / static_cast<float>(count());
        for (std::size_t i = 0; i < some; ++i) {
            int samples = 0;
            for (std::size_t s = 0; s < count(); s += 32) {
                const std::uint32_t bits = fragments.samples(f, first + i, s);
                samples += std::popcount(count() < 32 ? bits & ((1u << count()) - 1u) : bits);
            }
            parts_[i] = static_cast<float>(samples) * part;
        }
        return parts_;
    }

    HWY_NOINLINE void add_depths(const FragmentChunk& c, const float* depths)
    {
        const ExactGrid grid(-kDepthBits);
        alignas(64) std::int64_t units[Wide::kCount];
        for (std::size_t i = 0; i < c.some; i += Wide::kCount) {
            exact_units<Wide>(Wide::real::load(depths + i), grid).store(units);
            for (std::size_t j = 0; j < Wide::kCount && i + j < c.some; ++j) {
                const std::size_t fragment = c.first + i + j;
                std::int64_t* at = depths_.data() + c.stream.pixel[fragment] * count();
                for (std::size_t s = 0; s < count(); s += W::kCount) {
                    const auto shown = W::mask_of_bits(fragments.samples(c.stream, fragment, s));
                    const auto addend = W::zero_unless(shown, typename W::whole(units[j]));
                    (W::whole::load(at + s) + addend).store(at + s);
                }
            }
        }
    }

    // sums(pixel): those of colours and their weight.
    template <class Sums>
    HWY_INLINE void resolve(SampleColors& backdrop, Sums&& sums) const
    {
        const ExactGrid weights(-kColorBits), colors = fragments.color_grid();
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (!fragments.touched(pixel)) {
                // What the last tile left there.
                if (divides_) std::fill_n(backdrop.fraction.channel(pixel, 0), 5 * count(), 0.0f);
                continue;
            }
            const std::int64_t* units = sums(pixel);
            const auto sum = [&](std::size_t c, const ExactGrid& grid) {
                return real(static_cast<float>(static_cast<double>(units[c]) * grid.unit));
            };
            const real3 color{sum(0, colors), sum(1, colors), sum(2, colors)};
            const real weight = sum(3, weights);
            for (std::size_t s = 0; s < count(); s += L::kCount) {
                resolve(backdrop, pixel, s, color, weight);
            }
        }
    }

    float mean_shown(float light, std::size_t pixel, float depth)
    {
        return mean_over_samples<L>(count(), [&](std::size_t s) HWY_ATTR {
            return fragments.shown(real(light), pixel, s, depth);
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
            behind = fragments.behind(behind, pixel, s, transmittance);
            if (divides_) return through * behind;
            return Text::visible_resolve(color, weight, through, behind);
        });
        if (!divides_) return;
        float* at = backdrop.fraction.channel(pixel, 0) + s;
        save_color<Text>(color, at, count());
        weight.store(at + 3 * count());
        (real(1.0f) - through).store(at + 4 * count());
    }

    const SampleSet& set_;
    bool divides_;
    AlignedArray<std::int64_t> depths_;
    alignas(64) float parts_[kChunk] = {};
};

template <int S, class Function>
class TransmittancePixels {
public:
    explicit TransmittancePixels(const StoreShape& shape)
        : functions_(*shape.method), moment_passes_(functions_.passes()), samples_(shape)
    {
    }

    void clear(const TilePlace&)
    {
        samples_.clear();
        functions_.clear();
        pass_ = 0;
    }

    void insert(const FragmentStream& f, int pass)
    {
        for (; pass_ < pass; ++pass_) finish_pass();
        if (pass == 0) return samples_.fragments.look(f);
        samples_.fragments.see(f);
        const bool is_last = pass > moment_passes_;
        const auto size = static_cast<std::size_t>(f.size);
        for (std::size_t first = 0; first < size; first += kChunk) {
            const std::size_t some = std::min(kChunk, size - first);
            const FragmentChunk chunk{f, first, some, samples_.fragments.places() + first,
                                      samples_.parts(f, first, some)};
            if (is_last) {
                functions_.add_colors(chunk, samples_.fragments.color_grid());
            } else {
                add_depths(chunk, pass == 1);
            }
        }
    }

    // After the same pass, or before any of the other's.
    void merge(const TransmittancePixels& other)
    {
        samples_.merge(other.samples_);
        functions_.merge(other.functions_);
    }

    void resolve(SampleColors& backdrop)
    {
        for (; pass_ <= moment_passes_; ++pass_) finish_pass();
        samples_.resolve(backdrop, [&](std::size_t pixel) { return functions_.sums(pixel); });
    }

    float transmittance_at(std::size_t pixel, float depth)
    {
        for (; pass_ <= moment_passes_; ++pass_) finish_pass();
        const float place = samples_.fragments.place(depth);
        return samples_.mean_shown(functions_.transmittance_at(pixel, place), pixel, depth);
    }

private:
    void finish_pass()
    {
        if (pass_ == 0) return;
        functions_.prepare(samples_.fragments.touched(), pass_ == 1,
                           S == 1 && pass_ == 1 ? samples_.depths() : nullptr);
    }

    void add_depths(const FragmentChunk& chunk, bool is_first)
    {
        alignas(64) float depths[kChunk];
        functions_.find_depths(chunk, is_first, depths);
        if (is_first && S > 1) samples_.add_depths(chunk, depths);
        functions_.add_depths(chunk, depths);
    }

    PixelFunctions<Function> functions_;
    int moment_passes_;
    int pass_ = 0;  // that was last: 0 of looking, then those of sums, then colours
    PixelSamples<S> samples_;
};

// The store of a function: a fragment a lane where a pixel has one sample, or is to have one
// function.
template <class Function>
struct StoreOf {
    template <int S>
    using Samples = TransmittanceSamples<S, Function>;
    template <int S>
    using Pixels = TransmittancePixels<S, Function>;

    static StoreVerbs make(int samples, bool of_pixels)
    {
        if (of_pixels || samples == 1) return verbs_for_samples<Pixels>(samples);
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
