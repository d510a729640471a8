// Stochastic transparency: shaders/sheer/stochastic.glsl at every sample.
//
// Fragments that lie behind all that their pixel keeps are left out first, for they would win
// nothing. The others are packed, from as many triangles as fill some vectors, and their masks made
// a fragment a lane; then each goes to the samples of its mask, a sample a lane. 20 bytes a sample.
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
    static constexpr int kTileBits = 5;
    static_assert(1 << kTileBits == kTileSize);

    // Fragments that may win a sample are collected from runs until they are this many: vectors are
    // full then, and `farthest` is still fresh.
    static constexpr std::size_t kEnough = 128;
    static constexpr std::size_t kMost = kEnough + kTilePixels + 16;
    // What their masks are made of; one after the other, as the stream has them.
    struct Candidates {
        std::uint32_t number[kMost];  // in the stream
        std::uint32_t pixel[kMost], opacity[kMost], identity[kMost];
        std::uint32_t samples[kMost], samples_high[kMost];
    };
    alignas(64) Candidates candidates;
    std::uint32_t runs[kEnough];  // those that the candidates come from

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
        const std::size_t run_count = static_cast<std::size_t>(f.run_count);
        for (std::size_t r = 0; r < run_count;) {
            std::size_t count = 0, used = 0;
            for (; r < run_count && count < kEnough; ++r) {
                const std::size_t before = count;
                count = collect<Samples>(f, f.runs[r], count);
                runs[used] = static_cast<std::uint32_t>(r);
                used += count > before;
            }
            count = make_masks<Samples>(count);
            candidates.number[count] = ~0u;
            std::size_t k = 0;
            for (std::size_t u = 0; u < used; ++u) k = insert_run<Samples>(f, f.runs[runs[u]], k);
        }
    }

    // Those of a run's fragments that may win a sample become candidates. Returns how many there
    // are then.
    template <int Samples>
    HWY_INLINE std::size_t collect(const FragmentStream& f, const FragmentRun& run,
                                   std::size_t count)
    {
        using whole = typename Block::whole;
        using Real = typename Block::real;
        Candidates& c = candidates;
        const DepthPlane& plane = run.depth;
        const Real least(plane.least), most(plane.most);
        const Real reach(0.5f * (std::abs(plane.dx) + std::abs(plane.dy)) + plane.slack);
        const whole name(seed_by == SeedBy::object ? run.object : run.primitive);
        const bool by_depth = seed_by == SeedBy::depth;
        const std::size_t last = run.first + run.count;
        const whole end(static_cast<std::int32_t>(last));
        const float* far = farthest.data();
        for (std::size_t i = run.first; i < last; i += Block::kCount) {
            // What lies past the stream's end may be any number.
            const whole pixel = whole::load(f.pixel.data() + i) & whole(kTilePixels - 1);
            const Real at_center = Real::load(f.depth.data() + i);
            const Real nearest = Block::min(Block::max(at_center - reach, least), most);
            const whole numbers = Block::iota() + whole(static_cast<std::int32_t>(i));
            // Written so that a depth that is no number may win.
            const auto keep = !(nearest > Block::gather(far, pixel)) && numbers < end;
            if (!keep.any()) continue;
            const typename Block::Packing packing(keep);
            packing.store(numbers, c.number + count);
            packing.store(pixel, c.pixel + count);
            packing.store(by_depth ? whole::bits_of(at_center) : name, c.identity + count);
            packing.store(whole::bits_of(Real::load(f.opacity.data() + i)), c.opacity + count);
            packing.store(whole::load(f.samples.data() + i), c.samples + count);
            if constexpr (Samples > 32) {
                packing.store(whole::load(f.samples_high.data() + i), c.samples_high + count);
            }
            count += packing.count();
        }
        return count;
    }

    // Leaves the candidates that have samples, of which their masks are part. Returns their number.
    template <int Samples>
    HWY_INLINE std::size_t make_masks(std::size_t count)
    {
        using whole = typename Block::whole;
        Candidates& c = candidates;
        const whole x0(place.x), y0(place.y), key(place.key), none(0);
        const whole end(static_cast<std::int32_t>(count));
        std::size_t left = 0;
        for (std::size_t i = 0; i < count; i += Block::kCount) {
            const whole pixel = whole::load(c.pixel + i);
            const whole identity = BlockText::identity_seed(whole::load(c.identity + i), key);
            const whole seed = BlockText::fragment_seed(x0 + (pixel & whole(kTileSize - 1)),
                                                        y0 + (pixel >> kTileBits), identity);
            const auto opacity = whole::load(c.opacity + i).as_real();
            const auto bits = stratified ? BlockText::stratified_mask(seed, opacity, Samples)
                                         : BlockText::naive_mask(seed, opacity, Samples);
            const whole low = bits.low & whole::load(c.samples + i);
            whole any = low, high = none;
            if constexpr (Samples > 32) {
                high = bits.high & whole::load(c.samples_high + i);
                any = any | high;
            }
            const whole indices = Block::iota() + whole(static_cast<std::int32_t>(i));
            const typename Block::Packing packing(indices < end && !(any == none));
            packing.store(whole::load(c.number + i), c.number + left);
            packing.store(low, c.samples + left);
            if constexpr (Samples > 32) packing.store(high, c.samples_high + left);
            left += packing.count();
        }
        return left;
    }

    // Inserts a run's candidates, of which k is the first. Returns the next run's first.
    template <int Samples>
    HWY_INLINE std::size_t insert_run(const FragmentStream& f, const FragmentRun& run,
                                      std::size_t k)
    {
        constexpr std::size_t kBlocks = (Samples + L::kCount - 1) / L::kCount;
        // Copies, which what is stored below cannot alias.
        const DepthPlane plane = run.depth;
        const std::size_t end = run.first + run.count;
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
        for (; candidates.number[k] < end; ++k) {
            const std::size_t i = candidates.number[k], pixel = pixels[i];
            fragment.color = {real(red[i]), real(green[i]), real(blue[i])};
            real most;
            for (std::size_t b = 0; b < kBlocks; ++b) {
                const std::size_t s = b * L::kCount;
                const std::uint32_t word =
                    s < 32 ? candidates.samples[k] : candidates.samples_high[k];
                const auto taken = L::mask_of_bits(word >> (s & 31));
                fragment.depth = sample_depth<L>(plane, offset[b], depth[i]);
                float* at = stores + (Method::kChannels * pixel * Samples + s);
                const auto store =
                    Text::stochastic_insert(Method::load(at, Samples), taken, fragment);
                Method::save(store, at, Samples);
                most = b == 0 ? store.depth : L::max(most, store.depth);
            }
            far[pixel] = most.greatest();
        }
        return k;
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
