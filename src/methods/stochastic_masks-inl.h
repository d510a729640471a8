// Which fragments take which samples: shaders/sheer/stochastic_masks.glsl over a tile's stream.
//
// Fragments that lie behind all that their pixel keeps are left out first, for they would win
// nothing. The others are packed, from as many triangles as fill some vectors, and their masks made
// a fragment a lane.
#if defined(SHEER_STOCHASTIC_MASKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_STOCHASTIC_MASKS_INL_H
#undef SHEER_STOCHASTIC_MASKS_INL_H
#else
#define SHEER_STOCHASTIC_MASKS_INL_H
#endif

#include <bit>
#include <memory>

#include "lanes/lone.h"
#include "methods/farthest-inl.h"
#include "methods/mask_table.h"
#include "methods/samples-inl.h"
#include "methods/stochastic_settings.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct MaskText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
};

class StochasticMasks {
    using Block = Lanes<16>;  // of fragments
    using whole = Block::whole;
    using Text = MaskText<Block>;
    using LoneText = MaskText<Lone<float>>;

public:
    static constexpr bool kWait = true;  // with settings.depth_before: for taken_of
    MaskSettings settings;
    Farthest farthest;

    explicit StochasticMasks(const StoreShape& shape)
        : settings(mask_settings(*shape.method, shape.samples->count))
    {
        if (settings.masks == MaskKind::table) table_ = mask_table(settings.mask_samples());
    }

    void clear(const TilePlace& place) { place_ = place; }
    // Of the samples; nothing is kept yet.
    void begin_pass(int pass)
    {
        farthest.clear();
        first_ = settings.joint ? pass * settings.samples : 0;
        // Independent passes are seeded apart.
        key_ = settings.joint ? place_.key
                              : place_.key + static_cast<std::uint32_t>(pass) * kPassesApart;
    }

    // Calls insert(run, k) for the runs that have fragments that may win a sample, of which k is
    // the first; it answers with the next run's first.
    template <int Samples, class Insert>
    HWY_INLINE void for_each_run(const FragmentStream& f, KeptDepths, Insert&& insert)
    {
        const std::size_t run_count = static_cast<std::size_t>(f.run_count);
        for (std::size_t r = 0; r < run_count;) {
            std::size_t count = 0, used = 0;
            for (; r < run_count && count < kEnough; ++r) {
                const std::size_t before = count;
                count = collect<Samples>(f, f.runs[r], count);
                runs_[used] = static_cast<std::uint32_t>(r);
                used += count > before;
            }
            count = make_masks<Samples>(count);
            candidates_.number[count] = ~0u;
            std::size_t k = 0;
            for (std::size_t u = 0; u < used; ++u) k = insert(f.runs[runs_[u]], k);
        }
    }
    // Of candidate k: its number in the stream, and the samples s to s + 31 that it takes.
    std::size_t number(std::size_t k) const { return candidates_.number[k]; }
    std::uint32_t word(std::size_t k, std::size_t s) const
    {
        return (s < 32 ? candidates_.samples[k] : candidates_.samples_high[k]) >> (s & 31);
    }

    // The samples that one fragment takes of those that are open to it.
    std::uint64_t taken_of(std::uint64_t open, std::uint32_t pixel, const FragmentRun& run,
                           float depth, float opacity) const
    {
        const std::uint32_t named =
            settings.seed_by == SeedBy::depth ? std::bit_cast<std::uint32_t>(depth) : name_of(run);
        const std::uint32_t identity = LoneText::identity_seed(named, key_);
        const std::uint32_t x = static_cast<std::uint32_t>(place_.x) + (pixel & (kTileSize - 1));
        const std::uint32_t y = static_cast<std::uint32_t>(place_.y) + (pixel >> kTileBits);
        std::uint32_t seed = LoneText::fragment_seed(x, y, identity);
        const float xi = settings.dithered ? LoneText::dithered_xi(x, y, identity, seed)
                                           : LoneText::next_random_real(seed);
        const LoneText::SampleBits bits = LoneText::stratified_mask_of_open(
            seed, xi, opacity,
            {static_cast<std::uint32_t>(open), static_cast<std::uint32_t>(open >> 32)},
            static_cast<std::uint32_t>(std::popcount(open)), settings.samples);
        return bits.low | static_cast<std::uint64_t>(bits.high) << 32;
    }

private:
    static constexpr int kTileBits = 5;
    static_assert(1 << kTileBits == kTileSize);

    // Fragments that may win a sample are collected from runs until they are this many: vectors are
    // full then, and `farthest` is still fresh.
    static constexpr std::size_t kEnough = 128;
    static constexpr std::size_t kMost = kEnough + kTilePixels + 16;
    // What masks are made of; one after the other, as the stream has them.
    struct Candidates {
        std::uint32_t number[kMost];  // in the stream
        std::uint32_t pixel[kMost], opacity[kMost], identity[kMost];
        std::uint32_t samples[kMost], samples_high[kMost];
    };

    std::uint32_t name_of(const FragmentRun& run) const
    {
        if (settings.seed_by == SeedBy::primitive) return run.primitive;
        if (settings.seed_by == SeedBy::object_alone) return run.object;
        return 2 * run.object + (run.back_facing ? 1u : 0u);
    }

    // Those of a run's fragments that may win a sample become candidates. Returns how many there
    // are then.
    template <int Samples>
    HWY_INLINE std::size_t collect(const FragmentStream& f, const FragmentRun& run,
                                   std::size_t count)
    {
        Candidates& c = candidates_;
        const bool by_depth = settings.seed_by == SeedBy::depth;
        const whole identity(by_depth ? 0 : LoneText::identity_seed(name_of(run), key_));
        farthest.for_each_nearer(
            f, run,
            [&](const Block::Packing& packing, std::size_t i, whole pixels,
                Block::real depths) HWY_ATTR {
                packing.store(Farthest::numbers(i), c.number + count);
                packing.store(pixels, c.pixel + count);
                packing.store(
                    by_depth ? Text::identity_seed(whole::bits_of(depths), whole(key_)) : identity,
                    c.identity + count);
                packing.store(whole::bits_of(Block::real::load(f.opacity.data() + i)),
                              c.opacity + count);
                packing.store(whole::load(f.samples.data() + i), c.samples + count);
                if constexpr (Samples > 32) {
                    packing.store(whole::load(f.samples_high.data() + i), c.samples_high + count);
                }
                count += packing.count();
            });
        return count;
    }

    // Leaves the candidates that have samples, of which their masks are part. Returns their number.
    template <int Samples>
    HWY_INLINE std::size_t make_masks(std::size_t count)
    {
        Candidates& c = candidates_;
        const whole x0(place_.x), y0(place_.y), none(0);
        const whole end(static_cast<std::int32_t>(count));
        const int most = most_chosen<Samples>(count);
        std::size_t left = 0;
        for (std::size_t i = 0; i < count; i += Block::kCount) {
            const whole pixel = whole::load(c.pixel + i);
            const whole x = x0 + (pixel & whole(kTileSize - 1)), y = y0 + (pixel >> kTileBits);
            const whole identity = whole::load(c.identity + i);
            const whole indices = Block::iota() + whole(static_cast<std::int32_t>(i));
            // What lies past the last may be any number.
            const auto there = indices < end;
            const auto opacity = Block::zero_unless(there, whole::load(c.opacity + i)).as_real();
            const auto bits = mask_of<Samples>(x, y, identity, opacity, most);
            const whole low = bits.low & whole::load(c.samples + i);
            whole any = low, high = none;
            if constexpr (Samples > 32) {
                high = bits.high & whole::load(c.samples_high + i);
                any = any | high;
            }
            const typename Block::Packing packing(there && !(any == none));
            packing.store(whole::load(c.number + i), c.number + left);
            packing.store(low, c.samples + left);
            if constexpr (Samples > 32) packing.store(high, c.samples_high + left);
            left += packing.count();
        }
        return left;
    }

    // Of the candidates: what a mask chooses of Samples at most, the samples that are taken or
    // those that are left out. Few are where opacities are near 0 or 1.
    template <int Samples>
    HWY_INLINE int most_chosen(std::size_t count) const
    {
        if constexpr (Samples <= 8) return Samples / 2;
        using real = Block::real;
        const whole end(static_cast<std::int32_t>(count));
        const real all(static_cast<float>(Samples)), one(1.0f);
        real most(0.0f);
        for (std::size_t i = 0; i < count; i += Block::kCount) {
            const auto there = Block::iota() + whole(static_cast<std::int32_t>(i)) < end;
            const real opacity =
                Block::zero_unless(there, whole::load(candidates_.opacity + i)).as_real();
            const real least = Block::floor(opacity * all);
            most = Block::max(most, Block::min(least + one, all - least));
        }
        return std::min(static_cast<int>(most.greatest()), Samples / 2);
    }

    template <int Samples>
    HWY_INLINE Text::SampleBits mask_of(whole x, whole y, whole identity, Block::real opacity,
                                        int most) const
    {
        whole seed = Text::fragment_seed(x, y, identity);
        const int all = settings.mask_samples();
        // Constants unroll.
        const auto bits = all == Samples ? mask_of_all(x, y, identity, seed, opacity, most, Samples)
                                         : mask_of_all(x, y, identity, seed, opacity, all / 2, all);
        return first_ == 0 ? bits : Text::sample_part(bits, first_, settings.samples);
    }

    HWY_INLINE Text::SampleBits mask_of_all(whole x, whole y, whole identity, whole seed,
                                            Block::real opacity, int most, int samples) const
    {
        if (settings.masks == MaskKind::naive) return Text::naive_mask(seed, opacity, samples);
        if (settings.masks == MaskKind::table) {
            const whole index = Text::mask_table_index(seed, opacity);
            return {Block::gather(table_->low.data(), index),
                    samples > 32 ? Block::gather(table_->high.data(), index) : whole(0)};
        }
        const Block::real xi = settings.dithered ? Text::dithered_xi(x, y, identity, seed)
                                                 : Text::next_random_real(seed);
        return Text::stratified_mask_of_most(seed, xi, opacity, most, samples);
    }

    TilePlace place_ = {};
    std::uint32_t key_ = 0;
    int first_ = 0;  // of the pass's samples among those of the mask
    std::shared_ptr<const MaskTable> table_;
    alignas(64) Candidates candidates_;
    std::uint32_t runs_[kEnough];  // those that the candidates come from
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_STOCHASTIC_MASKS_INL_H
