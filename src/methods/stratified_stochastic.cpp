// Stratified stochastic transparency: shaders/sheer/stratified_stochastic.glsl over the samples of
// shaders/sheer/stochastic.glsl.
//
// Fragments arrive one after the other, a pixel's samples in the lanes. The reference values are
// made in the order of their numbers; whoever has a number looks its outcome up.
//
// 20 bytes a sample; for a pixel its surface and place on the curve, 16 bytes, and its farthest
// depth. Parts that are to be merged need different keys (TilePlace): with one key they would take
// the same samples. Nothing is stratified across them.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/stratified_stochastic.cpp"
#include "lanes/targets.h"

#include <bit>
#include <cmath>
#include <limits>

#include <hwy/foreach_target.h>

#include "lanes/lone.h"
#include "methods/nearest_samples-inl.h"
#include "methods/stratified_settings.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct StratifiedText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/random.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/stratified_stochastic.glsl"
};

template <int S>
struct StratifiedTile : SampleStore<S, NearestSamples<S, StratifiedText>> {
    using Base = SampleStore<S, NearestSamples<S, StratifiedText>>;
    using typename Base::L;
    using typename Base::real;
    using typename Base::Text;
    using whole = typename L::whole;
    using Store = typename Text::StochasticStore;
    using Method = NearestSamples<S, StratifiedText>;
    using LoneText = StratifiedText<Lone<float>>;
    using Block = Lanes<16>;  // of pixels and fragments

    struct Pixel {
        LoneText::StratifiedSurface surface;
        std::uint32_t place;  // reversed: its index on the curve times S
    };

    const SampleSet& set;
    StratifiedSettings settings;
    AlignedArray<Pixel> pixels{kTilePixels};
    AlignedArray<float> farthest{kTilePixels};  // of each pixel: the most depth that a sample keeps
    AlignedArray<std::uint32_t> reversed{kMaxSamples};     // numbers
    AlignedArray<std::int32_t> is_later{2 * kMaxSamples};  // 0 up to element 63, then 1
    // Of a run: fragments that may win samples, their open samples, and who takes them.
    AlignedArray<std::uint32_t> candidates{kTilePixels + 16};
    AlignedArray<std::uint64_t> open_samples{kTilePixels + 1}, taken_numbers{kTilePixels};

    explicit StratifiedTile(const StoreShape& shape)
        : Base(shape), set(*shape.samples), settings(stratified_settings(*shape.method))
    {
        for (std::uint32_t n = 0; n < kMaxSamples; ++n) reversed[n] = LoneText::reversed_bits(n);
        std::fill_n(is_later.data(), 64, 0);
        std::fill_n(is_later.data() + 64, 64, 1);
    }

    void clear(const TilePlace& place)
    {
        std::fill_n(farthest.data(), kTilePixels, std::numeric_limits<float>::infinity());
        for (std::uint32_t pixel = 0; pixel < kTilePixels; pixel += Block::kCount) {
            std::uint32_t places[16];
            places_of(place, pixel).store(places);
            for (std::uint32_t i = 0; i < Block::kCount; ++i) {
                pixels[pixel + i] = {LoneText::stratified_clear(place.key), places[i]};
            }
        }
        // Colours are looked at only where a depth was kept.
        const Store nothing = Method::clear();
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            float* depth = this->values() + Method::kChannels * pixel * this->count();
            for (std::size_t s = 0; s < this->count(); s += L::kCount) {
                nothing.depth.store(depth + s);
                nothing.id.as_real().store(depth + this->count() + s);
            }
        }
    }
    HWY_INLINE Block::whole places_of(const TilePlace& place, std::uint32_t pixel) const
    {
        using Curves = StratifiedText<Block>;
        using Whole = Block::whole;
        const Whole numbers = Block::iota() + Whole(pixel);
        const Whole x = Whole(place.x) + (numbers & Whole(kTileSize - 1));
        const Whole y = Whole(place.y) + (numbers >> kTileBits);
        const Whole index = settings.dither == Dither::hilbert  ? Curves::hilbert_index(x, y)
                            : settings.dither == Dither::morton ? Curves::morton_index(x, y)
                                                                : Whole(0);
        return Curves::reversed_bits(index * Whole(set.count));
    }

    void insert(const FragmentStream& f, int)
    {
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

    // Up to so many samples doing for all of them costs less than asking which of them need it.
    static constexpr int kFew = 8;

    template <int Samples>
    static constexpr std::size_t kBlocks = (Samples + L::kCount - 1) / L::kCount;

    // Step by step for all of a run's fragments: they are in different pixels, so that a processor
    // may work at several of them at once.
    template <int Samples>
    void insert_all(const FragmentStream& f)
    {
        for (int r = 0; r < f.run_count; ++r) {
            const FragmentRun& run = f.runs[r];
            real offset[kBlocks<Samples>];
            for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
                offset[b] = sample_depth_offset<L>(run.depth, set, b * L::kCount);
            }
            std::size_t count = collect(f, run);
            count = find_open<Samples>(f, run, offset, count);
            for (std::size_t k = 0; k < count; ++k) draw<Samples>(f, k);
            for (std::size_t k = 0; k < count; ++k) place<Samples>(f, run, offset, k);
        }
    }

    // Those of a run's fragments that may not be behind all that their pixels keep. Returns how
    // many there are.
    HWY_INLINE std::size_t collect(const FragmentStream& f, const FragmentRun& run)
    {
        using Real = Block::real;
        using Whole = Block::whole;
        const DepthPlane& plane = run.depth;
        const Real least(plane.least), most(plane.most);
        const Real reach(0.5f * (std::abs(plane.dx) + std::abs(plane.dy)) + plane.slack);
        const std::size_t last = run.first + run.count;
        const Whole end(static_cast<std::int32_t>(last));
        std::size_t count = 0;
        for (std::size_t i = run.first; i < last; i += Block::kCount) {
            // What lies past the stream's end may be any number.
            const Whole pixel = Whole::load(f.pixel.data() + i) & Whole(kTilePixels - 1);
            const Real at_center = Real::load(f.depth.data() + i);
            const Real nearest = Block::min(Block::max(at_center - reach, least), most);
            const Whole numbers = Block::iota() + Whole(static_cast<std::int32_t>(i));
            // Written so that a depth that is no number may win.
            const auto keep = !(nearest > Block::gather(farthest.data(), pixel)) && numbers < end;
            if (!keep.any()) continue;
            const typename Block::Packing packing(keep);
            packing.store(numbers, candidates.data() + count);
            count += packing.count();
        }
        return count;
    }

    // Leaves the candidates that have open samples: those that they cover and where they are nearer
    // than what is kept. Returns their number.
    template <int Samples>
    HWY_INLINE std::size_t find_open(const FragmentStream& f, const FragmentRun& run,
                                     const real* offset, std::size_t count)
    {
        std::size_t left = 0;
        Store fragment;
        fragment.id = whole(run.primitive);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = candidates[k];
            const float* at = this->values() + Method::kChannels * f.pixel[i] * Samples;
            std::uint64_t nearer = 0;
            for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
                const std::size_t s = b * L::kCount;
                Store store;
                store.depth = real::load(at + s);
                store.id = whole::bits_of(real::load(at + Samples + s));
                fragment.depth = sample_depth<L>(run.depth, offset[b], f.depth[i]);
                const auto of_block = Text::stochastic_nearer(store, fragment);
                nearer |= static_cast<std::uint64_t>(of_block.bits()) << s;
            }
            candidates[left] = static_cast<std::uint32_t>(i);
            open_samples[left] = nearer & (Samples > 32 ? f.sample_bits(i) : f.samples[i]);
            left += open_samples[left] != 0;
        }
        return left;
    }

    // Which of the numbers that candidate k's open samples get take them: bit by bit, from the
    // first on.
    template <int Samples>
    HWY_INLINE void draw(const FragmentStream& f, std::size_t k)
    {
        const std::size_t i = candidates[k];
        Pixel& pixel = pixels[f.pixel[i]];
        const std::uint32_t first = LoneText::stratified_begin(
            pixel.surface, static_cast<std::uint32_t>(open_samples[k]),
            Samples > 32 ? static_cast<std::uint32_t>(open_samples[k] >> 32) : 0,
            settings.tracking);
        const auto count = static_cast<std::uint32_t>(std::popcount(open_samples[k]));
        const std::uint32_t end = settings.compaction ? first + count : Samples;
        taken_numbers[k] = outcomes<Samples>(pixel, f.opacity[i], end);
        if (settings.compaction)
            taken_numbers[k] = taken_numbers[k] >> first & ((2ull << (count - 1)) - 1);
    }

    template <int Samples>
    HWY_INLINE void place(const FragmentStream& f, const FragmentRun& run, const real* offset,
                          std::size_t k)
    {
        if (taken_numbers[k] == 0) return;
        const std::size_t i = candidates[k], pixel = f.pixel[i];
        float* at = this->values() + Method::kChannels * pixel * Samples;
        std::uint64_t taken = 0;
        if (!settings.compaction) {
            taken = taken_numbers[k] & open_samples[k];
        } else if (settings.sort && Samples > 1) {
            taken = by_depth<Samples>(taken_numbers[k], open_samples[k], at);
        } else {
            taken = in_turn(taken_numbers[k], open_samples[k]);
        }
        Store fragment;
        fragment.id = whole(run.primitive);
        fragment.color = color_of<Text>(f, i);
        real most;
        for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
            const std::size_t s = b * L::kCount;
            const auto stays = !L::mask_of_bits(static_cast<std::uint32_t>(taken >> s));
            fragment.depth = sample_depth<L>(run.depth, offset[b], f.depth[i]);
            Store store = Method::load(at + s, Samples);
            store.depth = L::select(stays, store.depth, fragment.depth);
            store.id = L::select(stays, store.id, fragment.id);
            store.color = Text::select(stays, store.color, fragment.color);
            Method::save(store, at + s, Samples);
            most = b == 0 ? store.depth : L::max(most, store.depth);
        }
        farthest[pixel] = most.greatest();
    }

    // Whether numbers 0 to `end` - 1, and perhaps some more, take their samples: bit by bit.
    template <int Samples>
    HWY_INLINE std::uint64_t outcomes(const Pixel& pixel, float opacity, std::uint32_t end) const
    {
        std::uint64_t bits = 0;
        if (Samples <= L::kCount) end = Samples;  // one vector
        for (std::size_t n = 0; n < end; n += L::kCount) {
            const whole numbers = whole::load(reversed.data() + n) + whole(pixel.place);
            const whole reference = Text::reference_bits(static_cast<int>(settings.sequence),
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
                const whole least = of_t - whole::load(is_later.data() + 63 - t + b * L::kCount);
                left[b] = left[b] - L::zero_unless(least < key[b], whole(1));
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

private:
    static constexpr int kTileBits = 5;
    static_assert(1 << kTileBits == kTileSize);
};

StoreVerbs stratified_store(int samples)
{
    return verbs_for_samples<StratifiedTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(stratified_store);

StoreVerbs stratified_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(stratified_store, targets)(samples);
}

}  // namespace sheer
#endif
