// Which fragments take which samples, stratified over the pixels, pieces and layers of surfaces:
// shaders/sheer/stratified_stochastic.glsl over a tile's stream.
//
// Fragments arrive one after the other, a pixel's samples in the lanes. The reference values are
// made in the order of their numbers; whoever has a number looks its outcome up.
//
// For a pixel its surface and place on the curve, 16 bytes, and its farthest depth. Parts that are
// to be merged need different keys (TilePlace): with one key they would take the same samples.
// Nothing is stratified across them.
#if defined(SHEER_TRACKED_MASKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_TRACKED_MASKS_INL_H
#undef SHEER_TRACKED_MASKS_INL_H
#else
#define SHEER_TRACKED_MASKS_INL_H
#endif

#include <bit>

#include "lanes/lone.h"
#include "methods/farthest-inl.h"
#include "methods/samples-inl.h"
#include "methods/stochastic_settings.h"
#include "methods/stratified_settings.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct TrackedText {
#include "lanes/text_words.h"
#include "sheer/bits.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/stratified_stochastic.glsl"
};

// S lanes; 16 where there are more samples.
template <int S>
class TrackedMasks {
    using L = Lanes<S>;
    using Text = TrackedText<L>;
    using real = typename L::real;
    using whole = typename L::whole;
    using LoneText = TrackedText<Lone<float>>;
    using Block = Farthest::Block;  // of pixels and fragments

public:
    static constexpr bool kWait = false;  // for_each_run does for every setting
    Farthest farthest;

    explicit TrackedMasks(const StoreShape& shape)
        : TrackedMasks(*shape.samples, stratified_settings(*shape.method),
                       stochastic_settings(*shape.method))
    {
    }
    // `set` outlives it.
    TrackedMasks(const SampleSet& set, const StratifiedSettings& settings,
                 const StochasticSettings& passes)
        : set_(set), settings_(settings), passes_(passes)
    {
        for (std::uint32_t n = 0; n < kMaxSamples; ++n) reversed_[n] = LoneText::reversed_bits(n);
        std::fill_n(is_later_.data(), 64, 0);
        std::fill_n(is_later_.data() + 64, 64, 1);
    }

    void clear(const TilePlace& place) { place_ = place; }
    // Of the samples; nothing is kept yet.
    void begin_pass(int pass)
    {
        farthest.clear();
        const SequencePart part = part_of(static_cast<std::uint32_t>(pass));
        for (std::uint32_t pixel = 0; pixel < kTilePixels; pixel += Block::kCount) {
            std::uint32_t places[16];
            places_of(pixel, part).store(places);
            for (std::uint32_t i = 0; i < Block::kCount; ++i) {
                pixels_[pixel + i] = {LoneText::stratified_clear(part.key), places[i]};
            }
        }
    }

    // Calls insert(run, k) for the runs that have fragments that take a sample, of which k is the
    // first.
    //
    // Step by step for all of a run's fragments: they are in different pixels, so that a processor
    // may work at several of them at once.
    template <int Samples, class Insert>
    HWY_INLINE void for_each_run(const FragmentStream& f, KeptDepths kept, Insert&& insert)
    {
        for_each_run<Samples>(f, f.opacity.data(), kept, insert);
    }
    // With other opacities than the stream's.
    template <int Samples, class Insert>
    HWY_INLINE void for_each_run(const FragmentStream& f, const float* opacity, KeptDepths kept,
                                 Insert&& insert)
    {
        for (int r = 0; r < f.run_count; ++r) {
            const FragmentRun& run = f.runs[r];
            std::size_t count = collect(f, run);
            count = find_open<Samples>(f, run, kept, count);
            for (std::size_t k = 0; k < count; ++k) draw<Samples>(f, opacity, k);
            count = take<Samples>(f, kept, count);
            candidates_[count] = ~0u;
            if (count > 0) insert(run, 0);
        }
    }
    // Of candidate k: its number in the stream, and the samples s to s + 31 that it takes.
    std::size_t number(std::size_t k) const { return candidates_[k]; }
    std::uint32_t word(std::size_t k, std::size_t s) const
    {
        return static_cast<std::uint32_t>(taken_[k] >> s);
    }

private:
    static constexpr int kTileBits = 5;
    static_assert(1 << kTileBits == kTileSize);
    // Of a pixel at most: those of more pixels than a picture of 2048 x 2048 has are all different.
    static constexpr std::uint32_t kMostNumbers = 1024;
    // Up to so many samples doing for all of them costs less than asking which of them need it.
    static constexpr int kFew = 8;
    template <int Samples>
    static constexpr std::size_t kBlocks = (Samples + L::kCount - 1) / L::kCount;

    struct Pixel {
        LoneText::StratifiedSurface surface;
        std::uint32_t place;  // of its first number in the sequence, with its bits reversed
    };

    // Of a pixel's numbers, which are as many for each of the parts.
    struct SequencePart {
        std::uint32_t key, number, count;
    };
    SequencePart part_of(std::uint32_t pass) const
    {
        if (!passes_.joint) return {place_.key + pass * kPassesApart, 0, 1};
        const std::uint32_t passes = std::bit_ceil(static_cast<std::uint32_t>(passes_.passes));
        if (place_.frame.count <= 1) return {place_.key, pass, passes};
        const std::uint32_t most = std::max(kMostNumbers / (passes * numbers()), 1u);
        const auto frame = static_cast<std::uint32_t>(place_.frame.number);
        const auto frames = std::bit_ceil(static_cast<std::uint32_t>(place_.frame.count));
        return {place_.frame.key + frame / most * kPassesApart, pass + frame % most * passes,
                passes * std::min(frames, most)};
    }
    // Of a pixel's surface in one part of its sequence.
    std::uint32_t numbers() const
    {
        return is_systematic() ? 1 : static_cast<std::uint32_t>(set_.count);
    }
    bool is_systematic() const { return settings_.sequence == Sequence::systematic; }

    HWY_INLINE Block::whole places_of(std::uint32_t pixel, const SequencePart& part) const
    {
        using Curves = TrackedText<Block>;
        using Whole = Block::whole;
        const Whole pixels = Block::iota() + Whole(pixel);
        const Whole x = Whole(place_.x) + (pixels & Whole(kTileSize - 1));
        const Whole y = Whole(place_.y) + (pixels >> kTileBits);
        const Whole index = settings_.dither == Dither::hilbert  ? Curves::hilbert_index(x, y)
                            : settings_.dither == Dither::morton ? Curves::morton_index(x, y)
                                                                 : Whole(0);
        return Curves::reversed_bits(index * Whole(numbers() * part.count) +
                                     Whole(numbers() * part.number));
    }

    // Those of a run's fragments that may not be behind all that their pixels keep. Returns how
    // many there are.
    HWY_INLINE std::size_t collect(const FragmentStream& f, const FragmentRun& run)
    {
        std::size_t count = 0;
        farthest.for_each_nearer(
            f, run,
            [&](const Block::Packing& packing, std::size_t i, Block::whole, Block::real) HWY_ATTR {
                packing.store(Farthest::numbers(i), candidates_.data() + count);
                count += packing.count();
            });
        return count;
    }

    // Leaves the candidates that have open samples: those that they cover and where they are nearer
    // than what is kept. Returns their number.
    template <int Samples>
    HWY_INLINE std::size_t find_open(const FragmentStream& f, const FragmentRun& run,
                                     KeptDepths kept, std::size_t count)
    {
        real offset[kBlocks<Samples>];
        for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
            offset[b] = sample_depth_offset<L>(run.depth, set_, b * L::kCount);
        }
        std::size_t left = 0;
        typename Text::StochasticStore fragment, store;
        fragment.id = whole(run.primitive);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = candidates_[k];
            const float* at = kept.of_pixel(f.pixel[i], Samples);
            std::uint64_t nearer = 0;
            for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
                const std::size_t s = b * L::kCount;
                store.depth = real::load(at + s);
                store.id = whole::bits_of(real::load(at + Samples + s));
                fragment.depth = sample_depth<L>(run.depth, offset[b], f.depth[i]);
                const auto of_block = Text::stochastic_nearer(store, fragment);
                nearer |= static_cast<std::uint64_t>(of_block.bits()) << s;
            }
            candidates_[left] = static_cast<std::uint32_t>(i);
            open_[left] = nearer & (Samples > 32 ? f.sample_bits(i) : f.samples[i]);
            left += open_[left] != 0;
        }
        return left;
    }

    // Which of the numbers that candidate k's open samples get take them: bit by bit, from the
    // first on.
    template <int Samples>
    HWY_INLINE void draw(const FragmentStream& f, const float* opacity, std::size_t k)
    {
        const std::size_t i = candidates_[k];
        const std::uint64_t open = open_[k];
        Pixel& pixel = pixels_[f.pixel[i]];
        const std::uint32_t first = LoneText::stratified_begin(
            pixel.surface, static_cast<std::uint32_t>(open),
            Samples > 32 ? static_cast<std::uint32_t>(open >> 32) : 0, settings_.tracking);
        const auto count = static_cast<std::uint32_t>(std::popcount(open));
        if (!settings_.compaction) {
            taken_[k] = outcomes<Samples>(pixel, opacity[i], 0, Samples);
            return;
        }
        taken_[k] = outcomes<Samples>(pixel, opacity[i], first, first + count) >> first &
                    ((2ull << (count - 1)) - 1);
    }

    // Leaves the candidates that take samples; their numbers become samples. Returns how many there
    // are.
    template <int Samples>
    HWY_INLINE std::size_t take(const FragmentStream& f, KeptDepths kept, std::size_t count)
    {
        std::size_t left = 0;
        for (std::size_t k = 0; k < count; ++k) {
            if (taken_[k] == 0) continue;
            const std::size_t i = candidates_[k];
            std::uint64_t taken = 0;
            if (!settings_.compaction) {
                taken = taken_[k] & open_[k];
            } else if (settings_.sort && Samples > 1) {
                taken = by_depth<Samples>(taken_[k], open_[k], kept.of_pixel(f.pixel[i], Samples));
            } else {
                taken = in_turn(taken_[k], open_[k]);
            }
            candidates_[left] = static_cast<std::uint32_t>(i);
            taken_[left++] = taken;
        }
        return left;
    }

    // Whether numbers `first` to `end` - 1, and perhaps others, take their samples: bit by bit.
    template <int Samples>
    HWY_INLINE std::uint64_t outcomes(const Pixel& pixel, float opacity, std::uint32_t first,
                                      std::uint32_t end) const
    {
        std::uint64_t bits = 0;
        constexpr std::uint32_t kCount = L::kCount;
        first = Samples <= kCount ? 0 : first / kCount * kCount;
        if (Samples <= kCount) end = Samples;  // one vector
        if (is_systematic()) {
            const whole start(LoneText::reference_bits(0, pixel.place, pixel.surface.id) >> 8);
            for (std::uint32_t n = first; n < end; n += kCount) {
                const auto takes =
                    Text::systematic_takes(real(opacity), start, L::iota() + whole(n));
                bits |= static_cast<std::uint64_t>(takes.bits()) << n;
            }
            return bits;
        }
        for (std::size_t n = first; n < end; n += kCount) {
            const whole numbers = whole::load(reversed_.data() + n) + whole(pixel.place);
            const whole reference = Text::reference_bits(static_cast<int>(settings_.sequence),
                                                         numbers, whole(pixel.surface.id));
            const auto takes = Text::stratified_takes(real(opacity), reference);
            bits |= static_cast<std::uint64_t>(takes.bits()) << n;
        }
        return bits;
    }

    // Bit i of `numbers` for the i-th sample of `among`.
    static std::uint64_t in_turn(std::uint64_t numbers, std::uint64_t among)
    {
        std::uint64_t taken = 0;
        for (; among != 0; among &= among - 1, numbers >>= 1) {
            if ((numbers & 1) != 0) taken |= among & (0 - among);
        }
        return taken;
    }

    // Bit i of `numbers` for the sample of `among` before which, as stratified_before has it, are i
    // others. They are counted, which costs less than sorting.
    template <int Samples>
    HWY_INLINE std::uint64_t by_depth(std::uint64_t numbers, std::uint64_t among,
                                      const float* stored) const
    {
        constexpr int kBeyond = 0x7fffffff;
        alignas(64) std::int32_t keys[kBlocks<Samples> * L::kCount];
        whole key[kBlocks<Samples>], left[kBlocks<Samples>];
        for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
            const std::size_t s = b * L::kCount;
            const auto is_open = L::mask_of_bits(static_cast<std::uint32_t>(among >> s));
            key[b] = L::select(is_open, ordered(real::load(stored + s)), whole(kBeyond));
            key[b].store(keys + s);
            left[b] = whole(31);
        }
        const auto count_one = [&](std::size_t t) HWY_ATTR {
            const whole of_t(keys[t]);
            for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
                // Of equal depths the smaller sample is sooner.
                const whole least = of_t - whole::load(is_later_.data() + 63 - t + b * L::kCount);
                left[b] = left[b] + L::zero_unless(least < key[b], whole(-1));
            }
        };
        if constexpr (Samples <= kFew) {
            for (std::size_t t = 0; t < Samples; ++t) count_one(t);
        } else {
            for (std::uint64_t rest = among; rest != 0; rest &= rest - 1) {
                count_one(static_cast<std::size_t>(std::countr_zero(rest)));
            }
        }
        std::uint64_t taken = 0;
        const whole low(static_cast<std::uint32_t>(numbers));
        const whole high(static_cast<std::uint32_t>(numbers >> 32));
        for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
            whole bit;
            if constexpr (Samples > 32) {
                const whole word = L::select(left[b] < whole(0), high, low);
                bit = word << (left[b] & whole(31));
            } else {
                bit = low << left[b];
            }
            taken |= static_cast<std::uint64_t>(bit.sign_bits()) << (b * L::kCount);
        }
        return taken & among;
    }
    // Whole numbers in the order of depths.
    static HWY_INLINE whole ordered(real depth)
    {
        const whole bits = whole::bits_of(depth + real(0.0f));  // -0 becomes 0
        return bits ^ L::zero_unless(bits < whole(0), whole(0x7fffffff));
    }

    const SampleSet& set_;
    StratifiedSettings settings_;
    StochasticSettings passes_;
    TilePlace place_ = {};
    AlignedArray<Pixel> pixels_{kTilePixels};
    AlignedArray<std::uint32_t> reversed_{kMaxSamples};     // numbers
    AlignedArray<std::int32_t> is_later_{2 * kMaxSamples};  // 0 up to element 63, then 1
    // Of a run: fragments that may win samples, their open samples, and which they take: at first
    // numbers, then samples.
    AlignedArray<std::uint32_t> candidates_{kTilePixels + 16};
    AlignedArray<std::uint64_t> open_{kTilePixels + 1}, taken_{kTilePixels + 1};
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_TRACKED_MASKS_INL_H
