// A method that approximates transmittance (shaders/sheer/transmittance.glsl), with a function of
// depth at every sample of a tile. Lanes are samples.
//
// A sample takes 8 bytes for each sum (4 sums at least), 4 for each float kept, 4 for the
// transmittance of all, and 20 for what is opaque.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/transmittance_samples.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/translucent-inl.h"
#include "methods/transmittance_stores-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S>
class TransmittanceSamples final : public TransmittanceStore {
    using L = Lanes<S>;
    using W = WideLanes<(S < 8 ? S : 8)>;
    using Wide = WideLanes<kPrepared>;
    using Floats = Lanes<kPrepared>;
    using Text = TransmittanceText<L>;
    using real3 = typename Text::real3;
    using real = typename L::real;
    // Samples of a pixel that are prepared together, and pixels.
    static constexpr std::size_t kRun = S < 8 ? S : 8, kRuns = kPrepared / kRun;
    static constexpr std::size_t kVectors = S / W::kCount;
    static constexpr std::size_t kValues = 256;  // samples of fragments at a time
    static constexpr std::size_t kAround = 16;   // room for a vector

public:
    TransmittanceSamples(const StoreShape& shape, OwnFunction function)
        : set_(*shape.samples),
          function_(std::move(function)),
          moment_passes_(function_->counts().passes),
          numbers_(std::max(function_->counts().sums, std::size_t{4})),
          kept_numbers_(function_->counts().kept),
          fragments_(shape),
          sums_(kTilePixels * numbers_ * count()),
          kept_(kTilePixels * (kept_numbers_ + 1) * count())
    {
    }

    void clear(const TilePlace&) override
    {
        fragments_.clear();
        std::fill_n(sums_.data(), sums_.size(), std::int64_t{0});
        pass_ = 0;
    }

    void insert(const FragmentStream& f, int pass) override
    {
        finish_passes(pass);
        if (pass == 0) return fragments_.look(f);
        fragments_.see(f);
        if (pass > moment_passes_) return add_colors(f);
        if (pass == 1) return add_depths(f);
        add_seen_depths(f);
    }

    void merge(const TransmittanceStore& other) override
    {
        const auto& same = static_cast<const TransmittanceSamples&>(other);
        fragments_.merge(same.fragments_);
        add_all(same.sums_, sums_);
    }

    void resolve(SampleColors& backdrop) override
    {
        finish_passes(moment_passes_ + 1);
        const ExactGrid weights(-kColorBits), colors = fragments_.color_grid();
        for_each_touched(L::kCount, [&](std::size_t pixel, std::size_t s) HWY_ATTR {
            const std::int64_t* sums = sums_of(pixel, s);
            const real3 color{exact_sum_as_float<L, W>(sums, colors),
                              exact_sum_as_float<L, W>(sums + count(), colors),
                              exact_sum_as_float<L, W>(sums + 2 * count(), colors)};
            const real weight = exact_sum_as_float<L, W>(sums + 3 * count(), weights);
            const real through = real::load(kept_of(pixel, s) + kept_numbers_ * count());
            resolve_samples<Text>(backdrop, pixel, s,
                                  [&](real3 behind, real& transmittance) HWY_ATTR {
                                      transmittance = through;
                                      behind = fragments_.behind(behind, pixel, s, transmittance);
                                      return Text::visible_resolve(color, weight, through, behind);
                                  });
        });
    }

    float transmittance_at(std::size_t pixel, float depth) override
    {
        finish_passes(moment_passes_ + 1);
        alignas(64) float lights[kMaxSamples + kAround];
        const auto at = static_cast<std::uint32_t>(pixel);
        const float place = fragments_.place(depth);
        function_->find_transmittances(kept(), &at, &place, 1, lights);
        return mean_over_samples<L>(count(), [&](std::size_t s) HWY_ATTR {
            return fragments_.shown(real::load(lights + s), pixel, s, depth);
        });
    }

private:
    std::size_t count() const { return sample_count<S>(set_.count); }
    std::int64_t* sums_of(std::size_t pixel, std::size_t s)
    {
        return sums_.data() + pixel * numbers_ * count() + s;
    }
    // The last number is what all let through.
    float* kept_of(std::size_t pixel, std::size_t s)
    {
        return kept_.data() + pixel * (kept_numbers_ + 1) * count() + s;
    }
    KeptNumbers kept() const
    {
        return {kept_.data(), (kept_numbers_ + 1) * count(), std::countr_zero(count()), count()};
    }
    // Calls visit(pixel, s) for each vector of samples of a pixel that has fragments.
    template <class Visit>
    HWY_INLINE void for_each_touched(std::size_t lanes, Visit&& visit)
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (!fragments_.touched(pixel)) continue;
            for (std::size_t s = 0; s < count(); s += lanes) visit(pixel, s);
        }
    }

    // Samples s, s + 1, ... of a pixel.
    struct Run {
        std::size_t pixel, s;
    };
    struct Runs {
        Run run[kRuns];
        std::size_t filled = 0;
    };
    HWY_NOINLINE void finish_passes(int pass)
    {
        for (; pass_ < pass; ++pass_) {
            if (pass_ > 0) finish_pass();
        }
    }
    void finish_pass()
    {
        Runs runs;
        for_each_touched(kRun, [&](std::size_t pixel, std::size_t s) {
            runs.run[runs.filled++] = {pixel, s};
            if (runs.filled == kRuns) finish_runs(runs);
        });
        if (runs.filled > 0) finish_runs(runs);
    }
    // Makes of the sums of up to kPrepared samples what is kept, and clears the runs.
    HWY_NOINLINE void finish_runs(Runs& runs)
    {
        alignas(64) PreparedSums sums = {};
        alignas(64) float results[kMostKept][kPrepared];
        for (std::size_t r = 0; r < runs.filled; ++r) take_sums(runs.run[r], kRun * r, sums);
        if constexpr (kRuns == 1) {
            function_->prepare(sums, kept_of(runs.run[0].pixel, runs.run[0].s), count(),
                               pass_ == 1);
        } else {
            if (pass_ > 1) copy_kept<false>(runs, results);
            function_->prepare(sums, results[0], kPrepared, pass_ == 1);
            copy_kept<true>(runs, results);
        }
        if (pass_ == 1) keep_all(runs, sums[0]);
        runs.filled = 0;
    }
    // Of each sample what all its fragments let through.
    void keep_all(const Runs& runs, const double* depths)
    {
        alignas(64) float through[kPrepared];
        for (std::size_t i = 0; i < kPrepared; i += Wide::kCount) {
            Wide::real::load(depths + i).store(through + i);
        }
        for (std::size_t i = 0; i < kPrepared; i += Floats::kCount) {
            const auto depth = Floats::real::load(through + i);
            TransmittanceText<Floats>::exp_of(Floats::real(0.0f) - depth).store(through + i);
        }
        for (std::size_t r = 0; r < runs.filled; ++r) {
            std::copy_n(through + kRun * r, kRun,
                        kept_of(runs.run[r].pixel, runs.run[r].s) + kept_numbers_ * count());
        }
    }
    // And leaves 0.
    void take_sums(const Run& run, std::size_t to, PreparedSums& sums)
    {
        const ExactGrid grid(-kDepthBits);
        std::int64_t* at = sums_of(run.pixel, run.s);
        for (std::size_t k = 0; k < function_->counts().sums; ++k) {
            for (std::size_t i = 0; i < kRun; i += W::kCount) {
                exact_sum<W>(at + k * count() + i, grid).store(&sums[k][to + i]);
            }
        }
        for (std::size_t k = 0; k < numbers_; ++k) std::fill_n(at + k * count(), kRun, 0);
    }
    template <bool IsBack>
    void copy_kept(const Runs& runs, float (&numbers)[kMostKept][kPrepared])
    {
        for (std::size_t r = 0; r < runs.filled; ++r) {
            float* at = kept_of(runs.run[r].pixel, runs.run[r].s);
            for (std::size_t k = 0; k < kept_numbers_; ++k) {
                float* here = &numbers[k][kRun * r];
                if (IsBack) {
                    std::copy_n(here, kRun, at + k * count());
                } else {
                    std::copy_n(at + k * count(), kRun, here);
                }
            }
        }
    }

    // What each fragment adds is the same for all its samples.
    void add_depths(const FragmentStream& f)
    {
        using Block = Lanes<16>;
        alignas(64) float depths[kChunk];
        const auto size = static_cast<std::size_t>(f.size);
        for (std::size_t first = 0; first < size; first += kChunk) {
            const std::size_t some = std::min(kChunk, size - first);
            for (std::size_t i = 0; i < some; i += Block::kCount) {
                const float* opacity = f.opacity.data() + first + i;
                TransmittanceText<Block>::optical_depth(Block::real::load(opacity))
                    .store(depths + i);
            }
            const AddedUnits units =
                function_->find_units(fragments_.places() + first, depths, some);
            for (std::size_t s = 0; s < count(); s += S) {
                if (units.sums == nullptr) {
                    add_units<false>(f, first, some, units, s);
                } else {
                    add_units<true>(f, first, some, units, s);
                }
            }
        }
    }
    // At samples s, s + 1, ..., S of them.
    template <bool Sparse>
    HWY_INLINE void add_units(const FragmentStream& f, std::size_t first, std::size_t some,
                              const AddedUnits& units, std::size_t s)
    {
        const std::size_t touched = function_->counts().touched;
        for (std::size_t i = 0; i < some; ++i) {
            typename W::mask shown[kVectors];
            for (std::size_t v = 0; v < kVectors; ++v) {
                shown[v] = W::mask_of_bits(fragments_.samples(f, first + i, s + v * W::kCount));
            }
            std::int64_t* sums = sums_of(f.pixel[first + i], s);
            std::size_t k = 0;
            for (; k + 4 <= touched; k += 4) add_some<4, Sparse>(shown, units, k, i, sums);
            for (; k < touched; ++k) add_some<1, Sparse>(shown, units, k, i, sums);
        }
    }
    // Numbers k, k + 1, ... of fragment i.
    template <int Some, bool Sparse>
    HWY_INLINE void add_some(const typename W::mask (&shown)[kVectors], const AddedUnits& units,
                             std::size_t k, std::size_t i, std::int64_t* sums) const
    {
        for (std::size_t n = k; n < k + Some; ++n) {
            const std::size_t sum = Sparse ? units.sums[n * kChunk + i] : n;
            const typename W::whole addend(units.units[n * kChunk + i]);
            std::int64_t* at = sums + sum * count();
            for (std::size_t v = 0; v < kVectors; ++v, at += W::kCount) {
                (W::whole::load(at) + W::zero_unless(shown[v], addend)).store(at);
            }
        }
    }

    // The second time the opacities are those that are seen.
    void add_seen_depths(const FragmentStream& f)
    {
        const std::size_t samples = count(), most = kChunk / samples;
        alignas(64) float depths[kChunk + kAround], places[kChunk];
        const auto size = static_cast<std::size_t>(f.size);
        for (std::size_t first = 0; first < size; first += most) {
            const std::size_t some = std::min(most, size - first);
            find_transmittances(f, first, some, depths);
            for (std::size_t i = 0; i < some; ++i) {
                std::fill_n(places + i * samples, samples, fragments_.places()[first + i]);
                for (std::size_t s = 0; s < samples; s += L::kCount) {
                    float* depth = depths + i * samples + s;
                    const auto shown = L::mask_of_bits(fragments_.samples(f, first + i, s));
                    const real seen = real(f.opacity[first + i]) * real::load(depth);
                    Text::optical_depth(L::zero_unless(shown, seen)).store(depth);
                }
            }
            const AddedUnits units = function_->find_units(places, depths, some * samples);
            for (std::size_t i = 0; i < some; ++i) {
                add_rows(units, i * samples, sums_of(f.pixel[first + i], 0));
            }
        }
    }
    // Of the samples of a pixel.
    HWY_INLINE void add_rows(const AddedUnits& units, std::size_t first, std::int64_t* sums)
    {
        for (std::size_t k = 0; k < function_->counts().sums; ++k) {
            for (std::size_t s = 0; s < count(); s += W::kCount) {
                std::int64_t* at = sums + k * count() + s;
                const auto addend = W::whole::load(units.units + k * kChunk + first + s);
                (W::whole::load(at) + addend).store(at);
            }
        }
    }

    void add_colors(const FragmentStream& f)
    {
        const std::size_t samples = count(), most = kValues / samples;
        const ExactGrid weights(-kColorBits), colors = fragments_.color_grid();
        alignas(64) float through[kValues + kAround];
        const auto size = static_cast<std::size_t>(f.size);
        for (std::size_t first = 0; first < size; first += most) {
            const std::size_t some = std::min(most, size - first);
            find_transmittances(f, first, some, through);
            for (std::size_t j = 0; j < some; ++j) {
                const std::size_t i = first + j;
                std::int64_t* sums = sums_of(f.pixel[i], 0);
                for (std::size_t s = 0; s < samples; s += L::kCount) {
                    const real seen = real::load(through + j * samples + s);
                    const real weight =
                        L::zero_unless(L::mask_of_bits(fragments_.samples(f, i, s)),
                                       Text::visible_alpha(seen, real(f.opacity[i])));
                    const real3 color = weight * color_of<Text>(f, i);
                    add_exactly<L, W>(color.x, colors, sums + s);
                    add_exactly<L, W>(color.y, colors, sums + samples + s);
                    add_exactly<L, W>(color.z, colors, sums + 2 * samples + s);
                    add_exactly<L, W>(weight, weights, sums + 3 * samples + s);
                }
            }
        }
    }

    // At all samples of the fragments.
    void find_transmittances(const FragmentStream& f, std::size_t first, std::size_t some,
                             float* values) const
    {
        function_->find_transmittances(kept(), f.pixel.data() + first, fragments_.places() + first,
                                       some, values);
    }

    const SampleSet& set_;
    OwnFunction function_;
    int moment_passes_;
    int pass_ = 0;  // that was last: 0 of looking, then those of sums, then colours
    std::size_t numbers_, kept_numbers_;
    TranslucentFragments<S> fragments_;
    AlignedArray<std::int64_t> sums_;
    AlignedArray<float> kept_;
};

// One sample is a pixel (transmittance_pixels.cpp).
OwnStore make_transmittance_samples(const StoreShape& shape, OwnFunction function)
{
    switch (shape.samples->count) {
        case 2: return std::make_unique<TransmittanceSamples<2>>(shape, std::move(function));
        case 4: return std::make_unique<TransmittanceSamples<4>>(shape, std::move(function));
        case 8: return std::make_unique<TransmittanceSamples<8>>(shape, std::move(function));
        default: return std::make_unique<TransmittanceSamples<16>>(shape, std::move(function));
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
