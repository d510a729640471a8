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
#include "methods/samples-inl.h"
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

// A sample's values in memory, as `stochastic` has them.
template <int S>
struct StratifiedMethod {
    using L = Lanes<S>;
    using Text = StratifiedText<L>;
    using Store = typename Text::StochasticStore;
    using real3 = typename Text::real3;
    using real = typename L::real;
    using whole = typename L::whole;
    static constexpr int kChannels = 5;

    static HWY_INLINE real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    static HWY_INLINE Store clear() { return Text::stochastic_clear(beyond_any()); }
    static HWY_INLINE Store merge(Store a, Store b)
    {
        return Text::stochastic_insert(a, b.depth < beyond_any(), b);
    }
    static HWY_INLINE real3 resolve(Store s, real3 backdrop, real& transmittance)
    {
        transmittance = Text::stochastic_transmittance(s, beyond_any());
        return Text::stochastic_resolve(s, beyond_any(), backdrop);
    }
    static HWY_INLINE Store load(const float* at, std::size_t samples)
    {
        return {real::load(at), whole::bits_of(real::load(at + samples)),
                load_color<Text>(at + 2 * samples, samples)};
    }
    static HWY_INLINE void save(const Store& s, float* at, std::size_t samples)
    {
        s.depth.store(at);
        s.id.as_real().store(at + samples);
        save_color<Text>(s.color, at + 2 * samples, samples);
    }
};

template <int S>
struct StratifiedTile : SampleStore<S, StratifiedMethod<S>> {
    using Base = SampleStore<S, StratifiedMethod<S>>;
    using typename Base::L;
    using typename Base::real;
    using typename Base::Text;
    using whole = typename L::whole;
    using Store = typename Text::StochasticStore;
    using Method = StratifiedMethod<S>;
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
    AlignedArray<std::uint32_t> reversed{kMaxSamples};  // numbers
    AlignedArray<std::uint32_t> candidates{kTilePixels + 16};

    explicit StratifiedTile(const StoreShape& shape)
        : Base(shape), set(*shape.samples), settings(stratified_settings(*shape.method))
    {
        for (std::uint32_t n = 0; n < kMaxSamples; ++n) reversed[n] = LoneText::reversed_bits(n);
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
        using Text = StratifiedText<Block>;
        using whole = Block::whole;
        const whole numbers = Block::iota() + whole(pixel);
        const whole x = whole(place.x) + (numbers & whole(kTileSize - 1));
        const whole y = whole(place.y) + (numbers >> kTileBits);
        const whole index = settings.dither == Dither::hilbert  ? Text::hilbert_index(x, y)
                            : settings.dither == Dither::morton ? Text::morton_index(x, y)
                                                                : whole(0);
        return Text::reversed_bits(index * whole(set.count));
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

    template <int Samples>
    static constexpr std::size_t kBlocks = (Samples + L::kCount - 1) / L::kCount;

    template <int Samples>
    void insert_all(const FragmentStream& f)
    {
        for (int r = 0; r < f.run_count; ++r) {
            const FragmentRun& run = f.runs[r];
            real offset[kBlocks<Samples>];
            for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
                offset[b] = sample_depth_offset<L>(run.depth, set, b * L::kCount);
            }
            const std::size_t count = collect(f, run);
            for (std::size_t k = 0; k < count; ++k) {
                insert_one<Samples>(f, run, offset, candidates[k]);
            }
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

    template <int Samples>
    HWY_INLINE void insert_one(const FragmentStream& f, const FragmentRun& run, const real* offset,
                               std::size_t i)
    {
        const std::size_t pixel = f.pixel[i];
        float* at = this->values() + Method::kChannels * pixel * Samples;
        Store fragment;
        fragment.id = whole(run.primitive);
        real stored[kBlocks<Samples>], depth[kBlocks<Samples>];
        std::uint64_t open = 0;
        for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
            const std::size_t s = b * L::kCount;
            Store store;
            store.depth = stored[b] = real::load(at + s);
            store.id = whole::bits_of(real::load(at + Samples + s));
            fragment.depth = depth[b] = sample_depth<L>(run.depth, offset[b], f.depth[i]);
            const auto nearer = Text::stochastic_nearer(store, fragment);
            open |= static_cast<std::uint64_t>(nearer.bits()) << s;
        }
        open &= Samples > 32 ? f.sample_bits(i) : f.samples[i];
        if (open == 0) return;
        const std::uint64_t taken = taken_of<Samples>(pixels[pixel], open, f.opacity[i], stored);
        if (taken == 0) return;
        fragment.color = color_of<Text>(f, i);
        real most;
        for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
            const std::size_t s = b * L::kCount;
            const auto stays = !L::mask_of_bits(static_cast<std::uint32_t>(taken >> s));
            Store store = Method::load(at + s, Samples);
            store.depth = L::select(stays, stored[b], depth[b]);
            store.id = L::select(stays, store.id, fragment.id);
            store.color = Text::select(stays, store.color, fragment.color);
            Method::save(store, at + s, Samples);
            most = b == 0 ? store.depth : L::max(most, store.depth);
        }
        farthest[pixel] = most.greatest();
    }

    // Of the open samples, of which each keeps a depth.
    template <int Samples>
    HWY_INLINE std::uint64_t taken_of(Pixel& pixel, std::uint64_t open, float opacity,
                                      const real* stored) const
    {
        const std::uint32_t first = LoneText::stratified_begin(
            pixel.surface, static_cast<std::uint32_t>(open),
            Samples > 32 ? static_cast<std::uint32_t>(open >> 32) : 0, settings.tracking);
        if (!settings.compaction) return open & outcomes<Samples>(pixel, opacity, Samples);
        const auto count = static_cast<std::uint32_t>(std::popcount(open));
        const std::uint64_t all = ~0ull >> (64 - count);
        const std::uint64_t takes = outcomes<Samples>(pixel, opacity, first + count) >> first & all;
        if (takes == 0 || takes == all) return takes == 0 ? 0 : open;
        return settings.sort ? by_depth<Samples>(takes, open, stored) : in_turn(takes, open);
    }

    // Whether numbers 0 to `end` - 1, and perhaps some more, take their samples: bit by bit.
    template <int Samples>
    HWY_INLINE std::uint64_t outcomes(const Pixel& pixel, float opacity, std::uint32_t end) const
    {
        std::uint64_t bits = 0;
        for (std::size_t n = 0; n < end; n += L::kCount) {
            const whole numbers = whole::load(reversed.data() + n) + whole(pixel.place);
            const whole reference = Text::reference_bits(static_cast<int>(settings.sequence),
                                                         numbers, whole(pixel.surface.id));
            const auto takes = Text::stratified_takes(real(opacity), reference);
            bits |= static_cast<std::uint64_t>(takes.bits()) << n;
        }
        return bits;
    }

    // Bit i of `takes` for the i-th open sample.
    static std::uint64_t in_turn(std::uint64_t takes, std::uint64_t open)
    {
        std::uint64_t taken = 0;
        for (; open != 0; open &= open - 1, takes >>= 1) {
            if ((takes & 1) != 0) taken |= open & (0 - open);
        }
        return taken;
    }

    // Bit i of `takes` for the open sample before which, by depth, are i others. Counting them
    // costs less than sorting, for half of the fragments have few open samples.
    template <int Samples>
    HWY_INLINE std::uint64_t by_depth(std::uint64_t takes, std::uint64_t open,
                                      const real* stored) const
    {
        alignas(64) float depths[kBlocks<Samples> * L::kCount];
        whole before[kBlocks<Samples>];
        for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
            stored[b].store(depths + b * L::kCount);
            before[b] = whole(0);
        }
        for (std::uint64_t rest = open; rest != 0; rest &= rest - 1) {
            const int s = std::countr_zero(rest);
            const real depth(depths[s]);
            for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
                const whole samples = L::iota() + whole(static_cast<std::int32_t>(b * L::kCount));
                const auto sooner = Text::stratified_before(depth, whole(s), stored[b], samples);
                before[b] = before[b] + L::zero_unless(sooner, whole(1));
            }
        }
        std::uint64_t taken = 0;
        const whole low(static_cast<std::uint32_t>(takes));
        const whole high(static_cast<std::uint32_t>(takes >> 32));
        for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
            // Of samples that are not open `before` may be S.
            const whole word = Samples > 32 ? L::select(before[b] < whole(32), low, high) : low;
            const whole bit = word << (whole(31) - (before[b] & whole(31)));
            taken |= static_cast<std::uint64_t>(bit.sign_bits()) << (b * L::kCount);
        }
        return taken & open;
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
