// Stochastic transparency: shaders/sheer/stochastic.glsl at every sample.
//
// A stream's masks are made first, a fragment a lane; then each fragment goes to the samples of its
// mask, a sample a lane. 20 bytes a sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/stochastic.cpp"
#include "lanes/targets.h"

#include <bit>
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
struct StochasticTile : SampleStore<StochasticMethod<S>> {
    using Base = SampleStore<StochasticMethod<S>>;
    using typename Base::L;
    using typename Base::Text;
    using Block = Lanes<16>;  // of fragments
    using BlockText = StochasticText<Block>;

    const SampleSet& set;
    bool stratified;
    SeedBy seed_by;
    AlignedArray<std::uint32_t> pixel_seeds;
    // Of the stream's fragments: what their seeds name, and their random samples.
    AlignedArray<std::uint32_t> identity, low, high;

    explicit StochasticTile(const StoreShape& shape)
        : Base(shape),
          set(*shape.samples),
          stratified(shape.method->value("masks") == "stratified"),
          seed_by(seed_by_of(shape.method->value("seed-by"))),
          pixel_seeds(kTilePixels),
          identity(shape.stream_capacity + FragmentStream::kSlack),
          low(shape.stream_capacity + FragmentStream::kSlack),
          high(shape.stream_capacity + FragmentStream::kSlack)
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
    }

    void insert(const FragmentStream& f, int)
    {
        name_fragments(f);
        make_masks(f);
        for (std::size_t r = 0; r < static_cast<std::size_t>(f.run_count); ++r) {
            const FragmentRun& run = f.runs[r];
            for (std::size_t i = run.first; i < run.first + run.count; ++i) {
                const std::uint64_t taken = low[i] | std::uint64_t{high[i]} << 32;
                if (taken != 0) insert_fragment(f, run, i, taken);
            }
        }
    }

    HWY_INLINE void insert_fragment(const FragmentStream& f, const FragmentRun& run, std::size_t i,
                                    std::uint64_t taken)
    {
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
        if (seed_by == SeedBy::depth) {
            for (std::size_t i = 0; i < static_cast<std::size_t>(f.size); ++i) {
                identity[i] = std::bit_cast<std::uint32_t>(f.depth[i]);
            }
            return;
        }
        for (std::size_t r = 0; r < static_cast<std::size_t>(f.run_count); ++r) {
            const FragmentRun& run = f.runs[r];
            const std::uint32_t name = seed_by == SeedBy::object ? run.object : run.primitive;
            std::fill_n(identity.data() + run.first, run.count, name);
        }
    }

    void make_masks(const FragmentStream& f)
    {
        if constexpr (S < 16) {
            make_masks_of<S>(f);
        } else {
            switch (set.count) {
                case 16: return make_masks_of<16>(f);
                case 32: return make_masks_of<32>(f);
                default: return make_masks_of<64>(f);
            }
        }
    }

    template <int Samples>
    void make_masks_of(const FragmentStream& f)
    {
        using whole = typename Block::whole;
        for (std::size_t i = 0; i < static_cast<std::size_t>(f.size); i += Block::kCount) {
            // What lies past the stream's end may be any number.
            const whole place = whole::load(f.pixel.data() + i) & whole(kTilePixels - 1);
            const whole pixel = Block::gather(pixel_seeds.data(), place);
            const whole seed = BlockText::fragment_seed(pixel, whole::load(identity.data() + i));
            const auto opacity = Block::real::load(f.opacity.data() + i);
            const auto bits = stratified ? BlockText::stratified_mask(seed, opacity, Samples)
                                         : BlockText::naive_mask(seed, opacity, Samples);
            (bits.low & whole::load(f.samples.data() + i)).store(low.data() + i);
            if constexpr (Samples > 32) {
                (bits.high & whole::load(f.samples_high.data() + i)).store(high.data() + i);
            }
        }
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
