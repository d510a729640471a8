// What the methods that approximate transmittance see of a tile's fragments: those with opacity
// below 1 and nothing opaque before them, at depths from -1 to 1
// (shaders/sheer/transmittance.glsl).
#if defined(SHEER_TRANSLUCENT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_TRANSLUCENT_INL_H
#undef SHEER_TRANSLUCENT_INL_H
#else
#define SHEER_TRANSLUCENT_INL_H
#endif

#include <algorithm>

#include "methods/depth_function.h"
#include "methods/depth_range.h"
#include "methods/exact_sums-inl.h"
#include "methods/nearest_samples-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct TransmittanceText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/exponential.glsl"
#include "sheer/transmittance.glsl"
};

// Where a run's fragments are between near and far, at their pixels' centres. There is room for
// FragmentStream::kSlack more.
HWY_INLINE void warp_depths(const DepthRange& range, const FragmentStream& f,
                            const FragmentRun& run, float* places)
{
    using Block = Lanes<16>;
    using Real = Block::real;
    for (std::size_t i = run.first; i < run.first + run.count; i += Block::kCount) {
        TransmittanceText<Block>::warped_depth(
            range.is_distance, depth_at_centers<Block>(run.depth, f.depth.data() + i),
            Real(range.from), Real(range.scale))
            .store(places + i);
    }
}

// Of each sample the nearest fragment with opacity 1; of the tile the brightest colour. A pass of
// its own finds them. 20 bytes a sample, and 1 a pixel.
template <int S>
class TranslucentFragments {
    using L = Lanes<S>;
    using Block = Lanes<16>;  // of fragments
    using Real = Block::real;
    using Nearest = NearestSamples<S, TransmittanceText>;
    using Text = TransmittanceText<L>;
    using real3 = typename Text::real3;
    using real = typename L::real;

public:
    explicit TranslucentFragments(const StoreShape& shape)
        : set_(*shape.samples),
          range_(depth_range(shape)),
          opaque_(set_.count),
          places_(shape.stream_capacity + FragmentStream::kSlack),
          low_(shape.stream_capacity + FragmentStream::kSlack),
          high_(shape.stream_capacity + FragmentStream::kSlack)
    {
    }

    void clear()
    {
        any_opaque_ = false;
        brightest_ = 0;
        std::fill_n(touched_, kTilePixels, static_cast<char>(0));
    }

    // The pass that comes before the others.
    void look(const FragmentStream& f)
    {
        const auto size = static_cast<std::size_t>(f.size);
        Real most(brightest_);
        bool opaque = false;
        for (std::size_t i = 0; i < size; i += Block::kCount) {
            const auto there = Block::iota() + Block::whole(static_cast<std::int32_t>(i)) <
                               Block::whole(static_cast<std::int32_t>(size));
            for (const auto* channel : {&f.red, &f.green, &f.blue}) {
                const Real color = Real::load(channel->data() + i);
                most = Block::max(most, Block::zero_unless(there, color));
            }
            const auto whole = Real::load(f.opacity.data() + i) >= Real(1.0f);
            opaque = opaque || (whole && there).any();
        }
        brightest_ = most.greatest();
        for (std::size_t i = 0; i < size; ++i) touched_[f.pixel[i]] = 1;
        if (!opaque) return;
        begin_opaque();
        for (int r = 0; r < f.run_count; ++r) add_opaque(f, f.runs[r]);
    }

    void merge(const TranslucentFragments& other)
    {
        brightest_ = std::max(brightest_, other.brightest_);
        for (std::size_t i = 0; i < kTilePixels; ++i) touched_[i] |= other.touched_[i];
        if (!other.any_opaque_) return;
        begin_opaque();
        opaque_.merge(other.opaque_);
    }

    // Before what follows is asked for the stream's fragments.
    void see(const FragmentStream& f)
    {
        for (int r = 0; r < f.run_count; ++r) {
            const FragmentRun& run = f.runs[r];
            warp_depths(range_, f, run, places_.data());
            if (any_opaque_) leave_out_hidden(f, run);
        }
    }
    const float* places() const { return places_.data(); }
    HWY_INLINE float place(float depth) const
    {
        using One = Lanes<1>;
        return TransmittanceText<One>::warped_depth(range_.is_distance, One::real(depth),
                                                    One::real(range_.from), One::real(range_.scale))
            .greatest();
    }
    // 0 of the light from a depth that is behind what is opaque.
    HWY_INLINE real shown(real light, std::size_t pixel, std::size_t s, float depth) const
    {
        if (!any_opaque_) return light;
        return L::zero_unless(!(opaque_.load(pixel, s).depth < real(depth)), light);
    }
    // Samples s, s + 1, ... at which fragment i counts, from bit 0 on.
    HWY_INLINE std::uint32_t samples(const FragmentStream& f, std::size_t i, std::size_t s) const
    {
        if (any_opaque_) return (s < 32 ? low_[i] : high_[i]) >> (s & 31);
        return (s < 32 ? f.samples[i] : f.samples_high[i]) >> (s & 31);
    }

    bool touched(std::size_t pixel) const { return touched_[pixel] != 0; }
    const char* touched() const { return touched_; }  // of each pixel, not 0 if it is
    bool any_opaque() const { return any_opaque_; }
    // No colour is above 2 to the exponent's power, but for those that no picture has.
    ExactGrid color_grid() const
    {
        int exponent = 0;
        std::frexp(std::min(brightest_, 1e37f), &exponent);
        return ExactGrid(std::max(exponent, -60) - kColorBits);
    }

    // The backdrop or what is opaque before it; `through`, of what lies before that, becomes 0
    // where it hides the backdrop.
    HWY_INLINE real3 behind(real3 backdrop, std::size_t pixel, std::size_t s, real& through) const
    {
        if (!any_opaque_) return backdrop;
        const auto nearest = opaque_.load(pixel, s);
        const real none = Text::stochastic_transmittance(nearest, Nearest::beyond_any());
        through = through * none;
        return Text::stochastic_resolve(nearest, Nearest::beyond_any(), backdrop);
    }

private:
    void begin_opaque()
    {
        if (!any_opaque_) opaque_.clear();
        any_opaque_ = true;
    }
    HWY_INLINE typename Text::StochasticStore fragment_at(const FragmentStream& f,
                                                          const FragmentRun& run, std::size_t i,
                                                          std::size_t s) const
    {
        return {sample_depth<L>(run.depth, set_, f.depth[i], s), typename L::whole(run.primitive),
                color_of<Text>(f, i)};
    }
    void add_opaque(const FragmentStream& f, const FragmentRun& run)
    {
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            if (f.opacity[i] < 1) continue;
            for (std::size_t s = 0; s < opaque_.count(); s += L::kCount) {
                const auto store =
                    Text::stochastic_insert(opaque_.load(f.pixel[i], s), sample_mask<L>(f, i, s),
                                            fragment_at(f, run, i, s));
                opaque_.save(store, f.pixel[i], s);
            }
        }
    }
    void leave_out_hidden(const FragmentStream& f, const FragmentRun& run)
    {
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            std::uint64_t shown = 0;
            for (std::size_t s = 0; s < opaque_.count() && f.opacity[i] < 1; s += L::kCount) {
                const auto before =
                    Text::stochastic_nearer(opaque_.load(f.pixel[i], s), fragment_at(f, run, i, s));
                shown |= std::uint64_t{(before & sample_mask<L>(f, i, s)).bits()} << s;
            }
            low_[i] = static_cast<std::uint32_t>(shown);
            high_[i] = static_cast<std::uint32_t>(shown >> 32);
        }
    }

    const SampleSet& set_;
    DepthRange range_;
    bool any_opaque_ = false;
    float brightest_ = 0;
    char touched_[kTilePixels] = {};
    SampleStore<S, Nearest> opaque_;
    AlignedArray<float> places_;              // of the stream's fragments
    AlignedArray<std::uint32_t> low_, high_;  // of those, where anything is opaque
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_TRANSLUCENT_INL_H
