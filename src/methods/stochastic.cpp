// Stochastic transparency: shaders/sheer/stochastic.glsl at every sample.
//
// Of each triangle's fragments those are left out first that lie behind all that their pixel keeps,
// for they would win nothing. The others' masks are made a fragment a lane; then each goes to the
// samples of its mask, a sample a lane. 20 bytes a sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/stochastic.cpp"
#include "lanes/targets.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <hwy/foreach_target.h>

#include "lanes/lone.h"
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
    using typename Base::real;
    using typename Base::Text;
    using Method = StochasticMethod<S>;
    using Block = Lanes<16>;  // of fragments
    using BlockText = StochasticText<Block>;

    const SampleSet& set;
    bool stratified;
    SeedBy seed_by;
    TilePlace place = {};
    AlignedArray<float> farthest{kTilePixels};  // of each pixel: the most depth that a sample keeps
    // Of a run's fragments that have samples: their numbers in the stream, and the samples.
    static constexpr std::size_t kMost = kTilePixels + 16;
    static constexpr int kTileBits = 5;
    static_assert(1 << kTileBits == kTileSize);
    alignas(64) std::uint32_t number[kMost], low[kMost], high[kMost];

    explicit StochasticTile(const StoreShape& shape)
        : Base(shape),
          set(*shape.samples),
          stratified(shape.method->value("masks") == "stratified"),
          seed_by(seed_by_of(shape.method->value("seed-by")))
    {
    }

    static SeedBy seed_by_of(const std::string& text)
    {
        if (text == "depth") return SeedBy::depth;
        return text == "object" ? SeedBy::object : SeedBy::primitive;
    }

    void clear(const TilePlace& of_tile)
    {
        place = of_tile;
        // Colours are looked at only where a depth was kept.
        const auto nothing = Method::clear();
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            float* depth = this->values() + Method::kChannels * pixel * this->count();
            float* id = depth + this->count();
            for (std::size_t s = 0; s < this->count(); s += L::kCount) {
                nothing.depth.store(depth + s);
                nothing.id.as_real().store(id + s);
            }
        }
        std::fill_n(farthest.data(), kTilePixels, std::numeric_limits<float>::infinity());
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
    void insert_all(const FragmentStream& f)
    {
        for (std::size_t r = 0; r < static_cast<std::size_t>(f.run_count); ++r) {
            const FragmentRun& run = f.runs[r];
            const std::size_t count = make_masks<Samples>(f, run);
            insert_run<Samples>(f, run, count);
        }
    }

    // Returns how many of the run's fragments have samples and may win one.
    template <int Samples>
    HWY_INLINE std::size_t make_masks(const FragmentStream& f, const FragmentRun& run)
    {
        using whole = typename Block::whole;
        using Real = typename Block::real;
        const DepthPlane& plane = run.depth;
        const Real least(plane.least), most(plane.most);
        const Real reach(0.5f * (std::abs(plane.dx) + std::abs(plane.dy)) + plane.slack);
        const whole x0(place.x), y0(place.y), key(place.key);
        const std::uint32_t name = seed_by == SeedBy::object ? run.object : run.primitive;
        const whole of_run(StochasticText<Lone<float>>::identity_seed(name, place.key));
        const std::size_t last = run.first + run.count;
        const whole end(static_cast<std::int32_t>(last)), none(0);
        std::size_t count = 0;
        for (std::size_t i = run.first; i < last; i += Block::kCount) {
            // What lies past the stream's end may be any number.
            const whole pixel = whole::load(f.pixel.data() + i) & whole(kTilePixels - 1);
            const Real at_center = Real::load(f.depth.data() + i);
            const Real nearest = Block::min(Block::max(at_center - reach, least), most);
            // Written so that a depth that is no number may win.
            const auto may_win = !(nearest > Block::gather(farthest.data(), pixel));
            if (!may_win.any()) continue;
            const whole identity = seed_by == SeedBy::depth
                                       ? BlockText::identity_seed(whole::bits_of(at_center), key)
                                       : of_run;
            const whole seed = BlockText::fragment_seed(x0 + (pixel & whole(kTileSize - 1)),
                                                        y0 + (pixel >> kTileBits), identity);
            const Real opacity = Real::load(f.opacity.data() + i);
            const auto bits = stratified ? BlockText::stratified_mask(seed, opacity, Samples)
                                         : BlockText::naive_mask(seed, opacity, Samples);
            const whole low_bits = bits.low & whole::load(f.samples.data() + i);
            whole any = low_bits, high_bits = none;
            if constexpr (Samples > 32) {
                high_bits = bits.high & whole::load(f.samples_high.data() + i);
                any = any | high_bits;
            }
            const whole numbers = Block::iota() + whole(static_cast<std::int32_t>(i));
            const auto keep = may_win && numbers < end && !(any == none);
            numbers.store_packed(keep, number + count);
            low_bits.store_packed(keep, low + count);
            if constexpr (Samples > 32) high_bits.store_packed(keep, high + count);
            count += static_cast<std::size_t>(keep.count());
        }
        return count;
    }

    template <int Samples>
    HWY_INLINE void insert_run(const FragmentStream& f, const FragmentRun& run, std::size_t count)
    {
        constexpr std::size_t kBlocks = (Samples + L::kCount - 1) / L::kCount;
        // Copies, which what is stored below cannot alias.
        const DepthPlane plane = run.depth;
        const float *red = f.red.data(), *green = f.green.data(), *blue = f.blue.data();
        const float* depth = f.depth.data();
        const std::uint32_t* pixels = f.pixel.data();
        float *stores = this->values(), *far = farthest.data();
        real offset[kBlocks];
        for (std::size_t b = 0; b < kBlocks; ++b) {
            offset[b] = sample_depth_offset<L>(plane, set, b * L::kCount);
        }
        typename Text::StochasticStore fragment;
        fragment.id = typename L::whole(run.primitive);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = number[k], pixel = pixels[i];
            fragment.color = {real(red[i]), real(green[i]), real(blue[i])};
            real most(-std::numeric_limits<float>::infinity());
            for (std::size_t b = 0; b < kBlocks; ++b) {
                const std::size_t s = b * L::kCount;
                const std::uint32_t word = s < 32 ? low[k] : high[k];
                const auto taken = L::mask_of_bits(word >> (s & 31));
                fragment.depth = sample_depth<L>(plane, offset[b], depth[i]);
                float* at = stores + (Method::kChannels * pixel * Samples + s);
                const auto store =
                    Text::stochastic_insert(Method::load(at, Samples), taken, fragment);
                Method::save(store, at, Samples);
                most = L::max(most, store.depth);
            }
            far[pixel] = most.greatest();
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
