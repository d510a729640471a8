// Stochastic transparency: shaders/sheer/stochastic.glsl at every sample.
//
// A stream's masks are made first, a fragment a lane; then each fragment goes to the samples of its
// mask, a sample a lane. Fragments behind all that their pixel keeps are left out before that: they
// would win nothing. 20 bytes a sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/stochastic.cpp"
#include "lanes/targets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <hwy/foreach_target.h>

#include "methods/samples-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct StochasticText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/over.glsl"
#include "sheer/stochastic.glsl"
};

template <int S>
struct StochasticMethod {
    using L = Lanes<S>;
    using Text = StochasticText<L>;
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

enum class SeedBy { depth, primitive, object };

template <int S>
struct StochasticTile : SampleStore<S, StochasticMethod<S>> {
    using Base = SampleStore<S, StochasticMethod<S>>;
    using typename Base::L;
    using typename Base::Text;
    using Block = Lanes<16>;  // of fragments
    using BlockText = StochasticText<Block>;

    // Fragments between two looks at what pixels keep.
    static constexpr std::size_t kAtOnce = 2048;

    const SampleSet& set;
    bool stratified;
    SeedBy seed_by;
    // Of the tile's pixels.
    AlignedArray<std::uint32_t> pixel_seeds;
    AlignedArray<float> farthest;  // the most depth that a sample keeps, or more
    // Of the stream's fragments.
    AlignedArray<std::uint32_t> run_of;     // their runs
    AlignedArray<std::uint32_t> identity;   // what their seeds name
    AlignedArray<float> nearest;            // the least depth that they have at a sample, or less
    AlignedArray<std::uint32_t> low, high;  // their random samples
    AlignedArray<std::uint32_t> kept;       // the numbers of those that have any

    explicit StochasticTile(const StoreShape& shape)
        : StochasticTile(shape, shape.stream_capacity + FragmentStream::kSlack)
    {
    }
    StochasticTile(const StoreShape& shape, int size)
        : Base(shape),
          set(*shape.samples),
          stratified(shape.method->value("masks") == "stratified"),
          seed_by(seed_by_of(shape.method->value("seed-by"))),
          pixel_seeds(kTilePixels),
          farthest(kTilePixels),
          run_of(size),
          identity(size),
          nearest(size),
          low(size),
          high(size),
          kept(size)
    {
    }

    static SeedBy seed_by_of(const std::string& text)
    {
        if (text == "depth") return SeedBy::depth;
        return text == "object" ? SeedBy::object : SeedBy::primitive;
    }

    void clear(const TilePlace& place)
    {
        Base::clear(place);
        using whole = typename Block::whole;
        const whole key(place.key), x(place.x), y(place.y);
        for (int i = 0; i < kTilePixels; i += Block::kCount) {
            const whole column = Block::iota() + x + whole(i % kTileSize);
            const whole row = y + whole(i / kTileSize);
            BlockText::pixel_seed(column, row, key).store(pixel_seeds.data() + i);
        }
        std::fill_n(farthest.data(), kTilePixels, std::numeric_limits<float>::infinity());
    }

    void insert(const FragmentStream& f, int)
    {
        name_fragments(f);
        const auto size = static_cast<std::size_t>(f.size);
        for (std::size_t first = 0; first < size; first += kAtOnce) {
            const std::size_t count = make_masks(f, first, std::min(first + kAtOnce, size));
            for (std::size_t k = 0; k < count; ++k) insert_fragment(f, kept[k]);
            find_farthest();
        }
    }

    void find_farthest()
    {
        using real = typename L::real;
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            real most = this->load(pixel, 0).depth;
            for (std::size_t s = L::kCount; s < this->count(); s += L::kCount) {
                most = L::max(most, this->load(pixel, s).depth);
            }
            farthest[pixel] = most.greatest();
        }
    }

    HWY_INLINE void insert_fragment(const FragmentStream& f, std::size_t i)
    {
        const FragmentRun& run = f.runs[run_of[i]];
        const std::uint64_t taken = low[i] | std::uint64_t{high[i]} << 32;
        typename Text::StochasticStore fragment;
        fragment.id = typename L::whole(run.primitive);
        fragment.color = color_of<Text>(f, i);
        for (std::size_t s = 0; s < this->count(); s += L::kCount) {
            const auto here = L::mask_of_bits(static_cast<std::uint32_t>(taken >> s));
            fragment.depth = sample_depth<L>(run.depth, set, f.depth[i], s);
            this->save(Text::stochastic_insert(this->load(f.pixel[i], s), here, fragment),
                       f.pixel[i], s);
        }
    }

    void name_fragments(const FragmentStream& f)
    {
        for (std::uint32_t r = 0; r < static_cast<std::uint32_t>(f.run_count); ++r) {
            const FragmentRun& run = f.runs[r];
            const std::uint32_t name = seed_by == SeedBy::object ? run.object : run.primitive;
            const float reach =
                0.5f * (std::abs(run.depth.dx) + std::abs(run.depth.dy)) + run.depth.slack;
            for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
                run_of[i] = r;
                identity[i] = name;
                nearest[i] = std::clamp(f.depth[i] - reach, run.depth.least, run.depth.most);
            }
        }
        if (seed_by != SeedBy::depth) return;
        for (std::size_t i = 0; i < static_cast<std::size_t>(f.size); ++i) {
            identity[i] = std::bit_cast<std::uint32_t>(f.depth[i]);
        }
    }

    // Of fragments [first, last); returns how many are kept.
    std::size_t make_masks(const FragmentStream& f, std::size_t first, std::size_t last)
    {
        if constexpr (S < 16) {
            return make_masks_of<S>(f, first, last);
        } else {
            switch (set.count) {
                case 16: return make_masks_of<16>(f, first, last);
                case 32: return make_masks_of<32>(f, first, last);
                default: return make_masks_of<64>(f, first, last);
            }
        }
    }

    template <int Samples>
    std::size_t make_masks_of(const FragmentStream& f, std::size_t first, std::size_t last)
    {
        using whole = typename Block::whole;
        using Real = typename Block::real;
        const whole end(static_cast<std::int32_t>(last)), none(0);
        std::size_t count = 0;
        for (std::size_t i = first; i < last; i += Block::kCount) {
            // What lies past the stream's end may be any number.
            const whole place = whole::load(f.pixel.data() + i) & whole(kTilePixels - 1);
            const Real behind = Block::gather(farthest.data(), place);
            // Written so that what is no number is kept.
            const auto seen = !(Real::load(nearest.data() + i) > behind);
            if (!seen.any()) continue;
            const whole pixel = Block::gather(pixel_seeds.data(), place);
            const whole seed = BlockText::fragment_seed(pixel, whole::load(identity.data() + i));
            const Real opacity = Real::load(f.opacity.data() + i);
            const auto bits = stratified ? BlockText::stratified_mask(seed, opacity, Samples)
                                         : BlockText::naive_mask(seed, opacity, Samples);
            whole any = bits.low & whole::load(f.samples.data() + i);
            any.store(low.data() + i);
            if constexpr (Samples > 32) {
                const whole more = bits.high & whole::load(f.samples_high.data() + i);
                more.store(high.data() + i);
                any = any | more;
            }
            const whole number = Block::iota() + whole(static_cast<std::int32_t>(i));
            const auto keep = seen && number < end && !(any == none);
            number.store_packed(keep, kept.data() + count);
            count += static_cast<std::size_t>(keep.count());
        }
        return count;
    }
};

StoreVerbs stochastic_store(int samples)
{
    return verbs_for_samples<StochasticTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(stochastic_store);

StoreVerbs stochastic_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(stochastic_store, targets)(samples);
}

}  // namespace sheer
#endif
