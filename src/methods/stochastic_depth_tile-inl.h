// Depth-based stochastic transparency: shaders/sheer/stochastic_depth.glsl at every sample.
//
// With more passes of samples than one, both passes of the text take turns, and the sums go on. A
// sample keeps 12 bytes; sums are 16 more, of a pixel where that will do.
#if defined(SHEER_STOCHASTIC_DEPTH_TILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_STOCHASTIC_DEPTH_TILE_INL_H
#undef SHEER_STOCHASTIC_DEPTH_TILE_INL_H
#else
#define SHEER_STOCHASTIC_DEPTH_TILE_INL_H
#endif

#include <limits>

#include "lanes/lone.h"
#include "methods/farthest-inl.h"
#include "methods/stochastic_settings.h"
#include "methods/total_alpha-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct StochasticDepthText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/stochastic_depth.glsl"
};

// Masks: StochasticMasks, TrackedMasks<S>.
template <int S, class Masks>
class StochasticDepthTile {
    using L = Lanes<S>;
    using Text = StochasticDepthText<L>;
    using real3 = typename Text::real3;
    using real = typename L::real;
    using whole = typename L::whole;
    using Depth = typename Text::StochasticDepth;
    using Sum = typename Text::StochasticDepthSum;
    using LoneText = StochasticDepthText<Lone<float>>;

public:
    explicit StochasticDepthTile(const StoreShape& shape)
        : set_(*shape.samples),
          settings_(stochastic_settings(*shape.method)),
          masks_(shape),
          depths_(set_.count),
          total_alpha_(set_.count)
    {
        if (shape.filter_mixes_pixels) sums_ = SampleValues<4>(set_.count);
    }

    void clear(const TilePlace& place)
    {
        masks_.clear(place);
        std::fill_n(sums_.values.data(), sums_.values.size(), 0.0f);
        std::fill(std::begin(sums_of_pixels_), std::end(sums_of_pixels_),
                  LoneText::stochastic_depth_no_sum());
        total_alpha_.clear();
        pass_ = 0;
        begin_depths(0);
    }

    void insert(const FragmentStream& f, int pass)
    {
        const bool finds_depths = pass % 2 == 0;
        if (pass != pass_ && finds_depths) begin_depths(pass / 2);
        pass_ = pass;
        // The same for all passes of samples.
        if (pass == 1) total_alpha_.insert(f);
        with_sample_count<S>(set_.count, [&](auto samples) HWY_ATTR {
            if (finds_depths) {
                masks_.template for_each_run<samples>(
                    f, {depths_.values.data(), 2},
                    [&](const FragmentRun& run, std::size_t k)
                        HWY_ATTR { return insert_depths<samples>(f, run, k); });
            } else {
                per_pixel() ? add_shown<samples, true>(f) : add_shown<samples, false>(f);
            }
        });
    }

    void merge(const StochasticDepthTile& other)
    {
        for_each_vector<S>(set_.count, [&](std::size_t pixel, std::size_t s) HWY_ATTR {
            const Depth theirs = load_depth(other.depths_.channel(pixel, 0) + s, count());
            float* at = depths_.channel(pixel, 0) + s;
            save_depth(Text::stochastic_depth_insert(load_depth(at, count()),
                                                     theirs.depth == theirs.depth, theirs),
                       at, count());
        });
        for (std::size_t i = 0; i < sums_.values.size(); ++i) {
            sums_.values[i] += other.sums_.values[i];
        }
        for (std::size_t i = 0; i < kTilePixels; ++i) {
            auto& sum = sums_of_pixels_[i];
            sum.color = sum.color + other.sums_of_pixels_[i].color;
            sum.weight += other.sums_of_pixels_[i].weight;
        }
        total_alpha_.merge(other.total_alpha_);
    }

    void resolve(SampleColors& backdrop) const
    {
        const real part(1.0f / static_cast<float>(settings_.passes));
        for_each_vector<S>(set_.count, [&](std::size_t pixel, std::size_t s) HWY_ATTR {
            const Sum sum = sum_of(pixel, s);
            if (settings_.corrects) {
                return total_alpha_.dim(backdrop, pixel, s, sum.color, sum.weight);
            }
            resolve_samples<Text>(backdrop, pixel, s,
                                  [&](real3 behind, real& transmittance) HWY_ATTR {
                                      transmittance = total_alpha_.load(pixel, s);
                                      return Text::over(part * sum.color, transmittance, behind);
                                  });
        });
    }

    // Of samples whose nearest mask is not before it.
    float transmittance_at(std::size_t pixel, float depth) const
    {
        const Depth there{real(depth), whole(0u)};
        return mean_over_samples<L>(count(), [&](std::size_t s) HWY_ATTR {
            const Depth kept = load_depth(depths_.channel(pixel, 0) + s, count());
            return L::zero_unless(Text::stochastic_depth_shows(kept, L::mask_of_bits(~0u), there),
                                  real(1.0f));
        });
    }

private:
    std::size_t count() const { return sample_count<S>(set_.count); }
    bool per_pixel() const { return sums_.values.size() == 0; }

    void begin_depths(int pass_of_samples)
    {
        masks_.begin_pass(pass_of_samples);
        const Depth nothing =
            Text::stochastic_depth_clear(real(std::numeric_limits<float>::infinity()));
        for_each_vector<S>(set_.count, [&](std::size_t pixel, std::size_t s) HWY_ATTR {
            save_depth(nothing, depths_.channel(pixel, 0) + s, count());
        });
    }
    static HWY_INLINE Depth load_depth(const float* at, std::size_t samples)
    {
        return {real::load(at), whole::bits_of(real::load(at + samples))};
    }
    static HWY_INLINE void save_depth(const Depth& s, float* at, std::size_t samples)
    {
        s.depth.store(at);
        s.id.as_real().store(at + samples);
    }
    static HWY_INLINE Sum load_sum(const float* at, std::size_t samples)
    {
        return {load_color<Text>(at, samples), real::load(at + 3 * samples)};
    }
    HWY_INLINE Sum sum_of(std::size_t pixel, std::size_t s) const
    {
        if (!per_pixel()) return load_sum(sums_.channel(pixel, 0) + s, count());
        const auto& sum = sums_of_pixels_[pixel];
        const real mean(1.0f / static_cast<float>(set_.count));
        return {mean * real3{real(sum.color.x), real(sum.color.y), real(sum.color.z)},
                mean * real(sum.weight)};
    }

    // A run's fragments at the samples, a vector of them a block.
    template <int Samples>
    struct DepthsOfRun {
        static constexpr std::size_t kBlocks = (Samples + L::kCount - 1) / L::kCount;
        DepthPlane plane;  // a copy, which what is stored cannot alias
        whole id;
        real offsets[kBlocks];

        HWY_INLINE DepthsOfRun(const FragmentRun& run, const SampleSet& set)
            : plane(run.depth), id(run.primitive)
        {
            for (std::size_t b = 0; b < kBlocks; ++b) {
                offsets[b] = sample_depth_offset<L>(plane, set, b * L::kCount);
            }
        }
        HWY_INLINE Depth at(std::size_t block, float center) const
        {
            return {sample_depth<L>(plane, offsets[block], center), id};
        }
    };

    // Inserts a run's candidates, of which k is the first. Returns the next run's first.
    template <int Samples>
    HWY_INLINE std::size_t insert_depths(const FragmentStream& f, const FragmentRun& run,
                                         std::size_t k)
    {
        const DepthsOfRun<Samples> of_run(run, set_);
        const std::size_t end = run.first + run.count;
        const float* centers = f.depth.data();
        const std::uint32_t* pixels = f.pixel.data();
        float *kept = depths_.values.data(), *far = masks_.farthest.data();
        return two_at_once(masks_, k, end, [&](std::size_t first, auto count) HWY_ATTR {
            std::size_t i[count], pixel[count];
            for (std::size_t c = 0; c < count; ++c) {
                i[c] = masks_.number(first + c);
                pixel[c] = pixels[i[c]];
            }
            real most[count];
            for (std::size_t b = 0; b < of_run.kBlocks; ++b) {
                const std::size_t s = b * L::kCount;
                Depth nearest[count];
                const auto at = [&](std::size_t c)
                                    HWY_ATTR { return kept + (2 * pixel[c] * Samples + s); };
                for (std::size_t c = 0; c < count; ++c) {
                    nearest[c] = Text::stochastic_depth_insert(
                        load_depth(at(c), Samples), L::mask_of_bits(masks_.word(first + c, s)),
                        of_run.at(b, centers[i[c]]));
                    most[c] = b == 0 ? nearest[c].depth : L::max(most[c], nearest[c].depth);
                }
                for (std::size_t c = 0; c < count; ++c) save_depth(nearest[c], at(c), Samples);
            }
            for (std::size_t c = 0; c < count; ++c) far[pixel[c]] = most[c].greatest();
        });
    }

    // Second pass: most fragments lie behind all that their pixel kept.
    template <int Samples, bool PerPixel>
    HWY_INLINE void add_shown(const FragmentStream& f)
    {
        for (int r = 0; r < f.run_count; ++r) {
            std::size_t nearer = 0;
            masks_.farthest.for_each_nearer(
                f, f.runs[r],
                [&](const Farthest::Block::Packing& packing, std::size_t i, Farthest::whole,
                    Farthest::Real) HWY_ATTR {
                    packing.store(Farthest::numbers(i), nearer_ + nearer);
                    nearer += packing.count();
                });
            if (nearer > 0) add_run<Samples, PerPixel>(f, f.runs[r], nearer);
        }
    }
    template <int Samples, bool PerPixel>
    HWY_INLINE void add_run(const FragmentStream& f, const FragmentRun& run, std::size_t nearer)
    {
        const DepthsOfRun<Samples> of_run(run, set_);
        const float *centers = f.depth.data(), *opacities = f.opacity.data();
        const float *red = f.red.data(), *green = f.green.data(), *blue = f.blue.data();
        const std::uint32_t *pixels = f.pixel.data(), *low = f.samples.data();
        const std::uint32_t* high = f.samples_high.data();
        const float* kept = depths_.values.data();
        for (std::size_t k = 0; k < nearer; ++k) {
            const std::size_t i = nearer_[k], pixel = pixels[i];
            int shown_at = 0;
            for (std::size_t b = 0; b < of_run.kBlocks; ++b) {
                const std::size_t s = b * L::kCount;
                const auto covered = L::mask_of_bits((s < 32 ? low[i] : high[i]) >> (s & 31));
                const auto shown = Text::stochastic_depth_shows(
                    load_depth(kept + (2 * pixel * Samples + s), Samples), covered,
                    of_run.at(b, centers[i]));
                if constexpr (PerPixel) {
                    shown_at += shown.count();
                } else {
                    const Sum sum =
                        Text::stochastic_depth_add(load_sum(sums_.channel(pixel, 0) + s, Samples),
                                                   L::zero_unless(shown, real(opacities[i])),
                                                   {real(red[i]), real(green[i]), real(blue[i])});
                    save_color<Text>(sum.color, sums_.channel(pixel, 0) + s, Samples);
                    sum.weight.store(sums_.channel(pixel, 3) + s);
                }
            }
            if constexpr (PerPixel) {
                sums_of_pixels_[pixel] = LoneText::stochastic_depth_add(
                    sums_of_pixels_[pixel], static_cast<float>(shown_at) * opacities[i],
                    {red[i], green[i], blue[i]});
            }
        }
    }

    const SampleSet& set_;
    StochasticSettings settings_;
    Masks masks_;
    int pass_ = 0;            // even: depths; odd: sums
    SampleValues<2> depths_;  // and ids
    SampleValues<4> sums_;    // none where sums are those of pixels
    LoneText::StochasticDepthSum sums_of_pixels_[kTilePixels];
    TotalAlpha<S> total_alpha_;
    std::uint32_t nearer_[kTilePixels + 16];  // fragments of a run, in the stream
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_STOCHASTIC_DEPTH_TILE_INL_H
