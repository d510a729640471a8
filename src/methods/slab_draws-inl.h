// What is drawn at random for a run's fragments, at each of their samples: masks of slab_bits.glsl,
// or the limits of slab.glsl.
//
// Fragments behind as many layers as their pixel may have are left out first. Of the others each
// lane draws for one at one sample.
#if defined(SHEER_SLAB_DRAWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SLAB_DRAWS_INL_H
#undef SHEER_SLAB_DRAWS_INL_H
#else
#define SHEER_SLAB_DRAWS_INL_H
#endif

#include <bit>

#include "methods/farthest-inl.h"
#include "methods/samples-inl.h"
#include "methods/slab_settings.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct SlabText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/bits.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/stochastic_depth.glsl"
#include "sheer/slab_bits.glsl"
#include "sheer/slab.glsl"
};

// Words: of a mask; 0: limits.
template <int Words>
class SlabDraws {
    using Block = Lanes<16>;  // of fragments, or of fragments' samples
    using whole = Block::whole;
    using real = Block::real;
    using Text = SlabText<Block>;

public:
    Farthest farthest;

    SlabDraws(const SlabSettings& settings, int samples)
        : settings_(settings),
          samples_(static_cast<std::size_t>(samples)),
          sample_shift_(std::countr_zero(samples_))
    {
    }

    void clear(const TilePlace& place)
    {
        place_ = place;
        farthest.clear();
    }

    // Calls insert(i, k) for each of the run's fragments that may be kept; i is its number in the
    // stream, and k that for `word`, `limit`.
    template <class Insert>
    HWY_INLINE void for_each(const FragmentStream& f, const FragmentRun& run, Insert&& insert)
    {
        std::size_t count = 0;
        farthest.for_each_nearer(
            f, run,
            [&](const Block::Packing& packing, std::size_t i, whole pixels, Block::real) HWY_ATTR {
                packing.store(Farthest::numbers(i), number_ + count);
                packing.store(pixels, pixel_ + count);
                packing.store(whole::bits_of(real::load(f.opacity.data() + i)), opacity_ + count);
                count += packing.count();
            });
        const std::size_t most = kMostDraws / samples_;
        for (std::size_t first = 0; first < count; first += most) {
            const std::size_t some = std::min(most, count - first);
            make_seeds(run, first, some);
            draw(first, some);
            for (std::size_t k = 0; k < some; ++k) insert(number_[first + k], k);
        }
    }

    // At sample s and those after it.
    const std::uint32_t* word(std::size_t k, std::size_t s, std::size_t which) const
    {
        return words_[which] + k * samples_ + s;
    }
    const float* limit(std::size_t k, std::size_t s) const { return limits_ + k * samples_ + s; }

    // Of the pixel, at samples s, s + 1, ...
    template <class L>
    HWY_INLINE typename L::real xi_of_pixel(std::size_t pixel, std::size_t s) const
    {
        using OfSamples = SlabText<L>;
        using Whole = typename L::whole;
        const auto x = static_cast<std::int32_t>(pixel % kTileSize) + place_.x;
        const auto y = static_cast<std::int32_t>(pixel / kTileSize) + place_.y;
        // Above all fragments' names.
        Whole seed = OfSamples::fragment_seed(
            Whole(x), Whole(y), OfSamples::identity_seed(Whole(0x7fffffffu), Whole(place_.key)));
        return OfSamples::slab_xi(seed, L::iota() + Whole(static_cast<std::int32_t>(s)),
                                  Whole(apart()));
    }

private:
    static constexpr std::size_t kMostDraws = 1024;  // at a time
    static constexpr std::size_t kSlack = 16;        // a vector
    static constexpr int kTileBits = 5;
    static_assert(1 << kTileBits == kTileSize && kMostDraws >= kMaxSamples);

    std::int32_t apart() const { return (1 << 24) >> sample_shift_; }

    void make_seeds(const FragmentRun& run, std::size_t first, std::size_t count)
    {
        const whole identity = Text::identity_seed(whole(run.primitive), whole(place_.key));
        const whole x0(place_.x), y0(place_.y);
        for (std::size_t k = 0; k < count; k += Block::kCount) {
            const whole pixel = whole::load(pixel_ + first + k);
            const whole x = x0 + (pixel & whole(kTileSize - 1)), y = y0 + (pixel >> kTileBits);
            Text::fragment_seed(x, y, identity).store(seed_ + k);
        }
    }

    void draw(std::size_t first, std::size_t count)
    {
        if (Words == 0 && (settings_.is_endless() || settings_.in_depth)) {
            for (std::size_t i = 0; i < count * samples_; i += Block::kCount) {
                Text::slab_no_limit().store(limits_ + i);
            }
            return;
        }
        const std::size_t all = count * samples_;
        const whole end(static_cast<std::int32_t>(all)), in_pixel(samples_mask());
        for (std::size_t i = 0; i < all; i += Block::kCount) {
            const whole numbers = Farthest::numbers(i);
            const auto there = numbers < end;
            const whole k = Block::zero_unless(there, numbers >> sample_shift_);
            const whole seed = Block::gather(seed_, k);
            const real opacity = Block::gather(opacity_ + first, k).as_real();
            draw_vector(i, seed, numbers & in_pixel, opacity);
        }
    }
    std::int32_t samples_mask() const { return static_cast<std::int32_t>(samples_) - 1; }

    HWY_INLINE void draw_vector(std::size_t i, whole seed, whole sample, real opacity)
    {
        const int b = settings_.bits;
        const whole far(apart());
        if constexpr (Words > 0) {
            const auto bits = Text::slab_random_mask(seed, sample, far, opacity, b);
            const whole words[4] = {bits.a, bits.b, bits.c, bits.d};
            for (std::size_t w = 0; w < Words; ++w) words[w].store(words_[w] + i);
        } else {
            const real limit =
                Text::slab_random_limit(seed, sample, far, settings_.stratified, opacity, b);
            limit.store(limits_ + i);
        }
    }

    SlabSettings settings_;
    std::size_t samples_;
    int sample_shift_;
    TilePlace place_ = {};
    std::uint32_t number_[kTilePixels + kSlack], pixel_[kTilePixels + kSlack];
    std::uint32_t opacity_[kTilePixels + kSlack], seed_[kTilePixels + kSlack];
    std::uint32_t words_[Words > 0 ? Words : 1][kMostDraws + kSlack];
    float limits_[Words > 0 ? 1 : kMostDraws + kSlack];
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SLAB_DRAWS_INL_H
