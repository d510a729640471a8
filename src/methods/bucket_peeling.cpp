// Bucket depth peeling: shaders/sheer/bucket_peeling.glsl at every sample. 8 bytes a sample for the
// range and 28 for each bucket, twice as many with further peels; adaptive ones need 128 for the
// bins and 132 for counting them.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/bucket_peeling.cpp"
#include "lanes/targets.h"

#include <bit>

#include <hwy/foreach_target.h>

#include "methods/layers-inl.h"
#include "methods/precise_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct BucketPeelingText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/bits.glsl"
#include "sheer/layers.glsl"
#include "sheer/depth_peeling.glsl"
#include "sheer/bucket_peeling.glsl"
};

// Calls visit(number, lanes) for each number that some of the lanes have.
template <class L, class Visit>
HWY_INLINE void for_each_number(typename L::mask lanes, typename L::whole number, Visit&& visit)
{
    alignas(64) std::uint32_t numbers[16];
    number.store(numbers);
    for (std::uint32_t left = lanes.bits(); left != 0;) {
        const std::uint32_t n = numbers[std::countr_zero(left)];
        const auto those = lanes & (number == typename L::whole(n));
        visit(n, those);
        left &= ~those.bits();
    }
}

template <int S>
class BucketPeelingTile {
    using L = Lanes<S>;
    using Text = BucketPeelingText<PreciseLanes<S>>;
    using Layer = typename Text::Layer;
    using Peel = typename Text::DepthPeel;
    using Range = typename Text::BucketRange;
    using real = typename L::real;
    using whole = typename L::whole;
    using mask = typename L::mask;
    static constexpr int kBins = 1024;
    static constexpr std::size_t kWords = kBins / 32;

public:
    explicit BucketPeelingTile(const StoreShape& shape)
        : set_(*shape.samples),
          buckets_(shape.method->number("buckets")),
          adaptive_(shape.method->value("borders") == "adaptive"),
          again_(shape.method->number("peels") > 1),
          ranges_(set_.count),
          nearest_(layers_size()),
          front_(again_ ? layers_size() : 0),
          bins_(adaptive_ ? kTilePixels * kWords * count() : 0),
          before_(adaptive_ ? kTilePixels * (kWords + 1) * count() : 0)
    {
    }

    void clear(const TilePlace&)
    {
        std::fill_n(used_, kTilePixels, 0u);
        std::fill_n(seen_, kTilePixels, false);
        pass_ = 0;
        found_ = false;
    }

    void insert(const FragmentStream& f, int pass)
    {
        if (pass != pass_) begin(pass);
        // Buckets are those of precise depths, too: what lies in the nearer one is nearer.
        const auto wanted = [&](std::size_t pixel, std::size_t s, const RoughLayer<L>& layer)
                                HWY_ATTR { return pass == 0 ? widens(layer, pixel, s) : true; };
        for_each_precise_layer<S, Text>(
            f, set_, wanted, [&](std::size_t pixel, std::size_t s, const Layer& layer) HWY_ATTR {
                if (pass == 0) {
                    widen(layer, pixel, s);
                } else if (pass < first_peel()) {
                    mark(layer, pixel, s);
                } else {
                    peel(layer, pixel, s);
                }
            });
    }

    // After the same pass.
    void merge(const BucketPeelingTile& other)
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (!other.seen_[pixel]) continue;
            see(pixel);
            for (std::size_t s = 0; s < count(); s += L::kCount) {
                save_range(
                    Text::bucket_range_merge(load_range(pixel, s), other.load_range(pixel, s)),
                    pixel, s);
                for (std::size_t w = 0; adaptive_ && w < kWords; ++w) {
                    const whole both =
                        load_word(pixel, w, s) |
                        whole::load(other.bins_.data() + index(pixel * kWords + w, s));
                    both.store(bins_.data() + index(pixel * kWords + w, s));
                }
                for (std::uint32_t left = other.used_[pixel]; left != 0; left &= left - 1) {
                    const auto bucket = static_cast<std::uint32_t>(std::countr_zero(left));
                    put(other.load_nearest(pixel, bucket, s), pixel, bucket, s);
                }
            }
        }
        found_ |= other.found_;
    }

    bool done() const { return pass_ >= first_peel() && !found_; }

    void resolve(SampleColors& backdrop) const
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (used_[pixel] == 0) continue;
            for (std::size_t s = 0; s < count(); s += L::kCount) {
                Layer all = Text::layer_clear(beyond_any());
                for (std::uint32_t left = used_[pixel]; left != 0; left &= left - 1) {
                    const auto bucket = static_cast<std::size_t>(std::countr_zero(left));
                    const Peel last =
                        Text::depth_peeling_begin(load_peel(pixel, bucket, s), beyond_any());
                    all = Text::layer_over(all, last.front);
                }
                resolve_samples<Text>(backdrop, pixel, s,
                                      [&](auto behind, real& transmittance) HWY_ATTR {
                                          transmittance = real(1.0f) - all.opacity;
                                          return Text::layer_resolve(all, behind);
                                      });
            }
        }
    }

private:
    static HWY_INLINE real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    static HWY_INLINE mask covers(const Layer& layer) { return layer.depth.upper < beyond_any(); }

    std::size_t count() const { return sample_count<S>(set_.count); }
    std::size_t layers_size() const
    {
        return kTilePixels * static_cast<std::size_t>(buckets_) * kLayerChannels<Text> * count();
    }
    int first_peel() const { return adaptive_ ? 2 : 1; }

    // ---- what lies where ----------------------------------------------------------------------

    std::size_t index(std::size_t row, std::size_t s) const { return row * count() + s; }
    std::size_t layer_index(std::size_t pixel, std::size_t bucket, std::size_t s) const
    {
        return index((pixel * static_cast<std::size_t>(buckets_) + bucket) * kLayerChannels<Text>,
                     s);
    }
    HWY_INLINE Range load_range(std::size_t pixel, std::size_t s) const
    {
        return {real::load(ranges_.channel(pixel, 0) + s),
                real::load(ranges_.channel(pixel, 1) + s)};
    }
    HWY_INLINE void save_range(Range range, std::size_t pixel, std::size_t s)
    {
        range.nearest.store(ranges_.channel(pixel, 0) + s);
        range.farthest.store(ranges_.channel(pixel, 1) + s);
    }
    HWY_INLINE whole load_word(std::size_t pixel, std::size_t word, std::size_t s) const
    {
        return whole::load(bins_.data() + index(pixel * kWords + word, s));
    }
    HWY_INLINE whole load_before(std::size_t pixel, std::size_t word, std::size_t s) const
    {
        return whole::load(before_.data() + index(pixel * (kWords + 1) + word, s));
    }
    HWY_INLINE Layer load_nearest(std::size_t pixel, std::size_t bucket, std::size_t s) const
    {
        return load_layer<Text>(nearest_.data() + layer_index(pixel, bucket, s), count());
    }
    HWY_INLINE Peel load_peel(std::size_t pixel, std::size_t bucket, std::size_t s) const
    {
        Peel peel = Text::depth_peeling_clear(beyond_any());
        if (again_) {
            peel.front = load_layer<Text>(front_.data() + layer_index(pixel, bucket, s), count());
        }
        peel.nearest = load_nearest(pixel, bucket, s);
        return peel;
    }
    HWY_INLINE void save_peel(const Peel& peel, std::size_t pixel, std::size_t bucket,
                              std::size_t s)
    {
        const std::size_t at = layer_index(pixel, bucket, s);
        save_layer<Text>(peel.nearest, nearest_.data() + at, count());
        if (again_) save_layer<Text>(peel.front, front_.data() + at, count());
    }

    // ---- the passes ---------------------------------------------------------------------------

    // Makes a pixel's range and bins clear.
    HWY_INLINE void see(std::size_t pixel)
    {
        if (seen_[pixel]) return;
        seen_[pixel] = true;
        for (std::size_t s = 0; s < count(); s += L::kCount) {
            save_range(Text::bucket_range_clear(beyond_any()), pixel, s);
        }
        if (adaptive_) std::fill_n(bins_.data() + index(pixel * kWords, 0), kWords * count(), 0u);
    }

    void begin(int pass)
    {
        if (pass == first_peel() && adaptive_) count_bins();
        for (std::size_t pixel = 0; pass > first_peel() && pixel < kTilePixels; ++pixel) {
            for (std::uint32_t left = used_[pixel]; left != 0; left &= left - 1) {
                const auto bucket = static_cast<std::size_t>(std::countr_zero(left));
                for (std::size_t s = 0; s < count(); s += L::kCount) {
                    save_peel(Text::depth_peeling_begin(load_peel(pixel, bucket, s), beyond_any()),
                              pixel, bucket, s);
                }
            }
        }
        pass_ = pass;
        found_ = false;
    }

    HWY_INLINE bool widens(const RoughLayer<L>& layer, std::size_t pixel, std::size_t s) const
    {
        if (!seen_[pixel]) return true;
        const Range range = load_range(pixel, s);
        return (layer.covered &
                ((layer.nearest < range.nearest) | (layer.farthest > range.farthest)))
            .any();
    }
    HWY_INLINE void widen(const Layer& layer, std::size_t pixel, std::size_t s)
    {
        see(pixel);
        const Range range = load_range(pixel, s);
        save_range(Text::bucket_range_insert(range, covers(layer), layer.depth.upper), pixel, s);
    }

    HWY_INLINE whole place(const Layer& layer, std::size_t pixel, std::size_t s, int parts) const
    {
        return Text::bucket_place(load_range(pixel, s), covers(layer), layer.depth.upper, parts);
    }

    HWY_INLINE void mark(const Layer& layer, std::size_t pixel, std::size_t s)
    {
        const whole bin = place(layer, pixel, s, kBins);
        for_each_number<L>(covers(layer), Text::bucket_word(bin),
                           [&](std::size_t word, mask lanes) HWY_ATTR {
                               Text::bucket_mark(load_word(pixel, word, s), lanes, bin)
                                   .store(bins_.data() + index(pixel * kWords + word, s));
                           });
    }

    void count_bins()
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (!seen_[pixel]) continue;
            for (std::size_t s = 0; s < count(); s += L::kCount) {
                whole before(0u);
                for (std::size_t word = 0; word <= kWords; ++word) {
                    before.store(before_.data() + index(pixel * (kWords + 1) + word, s));
                    if (word == kWords) break;
                    before = before + Text::bit_count(load_word(pixel, word, s));
                }
            }
        }
    }

    HWY_INLINE whole adaptive_bucket(const Layer& layer, std::size_t pixel, std::size_t s) const
    {
        const whole bin = place(layer, pixel, s, kBins);
        whole rank(0u);
        for_each_number<L>(
            covers(layer), Text::bucket_word(bin), [&](std::size_t word, mask lanes) HWY_ATTR {
                const whole here =
                    Text::bucket_rank(load_before(pixel, word, s), load_word(pixel, word, s), bin);
                rank = L::select(lanes, here, rank);
            });
        return Text::bucket_of_rank(rank, load_before(pixel, kWords, s), buckets_);
    }

    HWY_INLINE void peel(const Layer& layer, std::size_t pixel, std::size_t s)
    {
        const whole bucket =
            adaptive_ ? adaptive_bucket(layer, pixel, s) : place(layer, pixel, s, buckets_);
        for_each_number<L>(covers(layer), bucket, [&](std::uint32_t number, mask lanes) HWY_ATTR {
            const Layer none = Text::layer_clear(beyond_any());
            put(Text::layer_select(lanes, layer, none), pixel, number, s);
        });
    }

    HWY_INLINE void put(const Layer& layer, std::size_t pixel, std::uint32_t bucket, std::size_t s)
    {
        if ((used_[pixel] >> bucket & 1) == 0) {
            used_[pixel] |= 1u << bucket;
            for (std::size_t t = 0; t < count(); t += L::kCount) {
                save_peel(Text::depth_peeling_clear(beyond_any()), pixel, bucket, t);
            }
        }
        const Peel peel = load_peel(pixel, bucket, s);
        if (!Text::depth_peeling_takes(peel, layer).any()) return;
        save_layer<Text>(Text::depth_peeling_insert(peel, layer).nearest,
                         nearest_.data() + layer_index(pixel, bucket, s), count());
        found_ = true;
    }

    const SampleSet& set_;
    const int buckets_;
    const bool adaptive_;
    const bool again_;  // buckets are peeled more than once
    SampleValues<2> ranges_;
    AlignedArray<float> nearest_, front_;
    AlignedArray<std::uint32_t> bins_;      // a bit each, 32 words a sample
    AlignedArray<std::uint32_t> before_;    // bits in front of each word, and all
    std::uint32_t used_[kTilePixels] = {};  // buckets that have been written to, a bit each
    bool seen_[kTilePixels] = {};           // ranges and bins that have been
    int pass_ = 0;
    bool found_ = false;  // in this pass
};

StoreVerbs bucket_peeling_store(int samples)
{
    return verbs_for_samples<BucketPeelingTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(bucket_peeling_store);

StoreVerbs bucket_peeling_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(bucket_peeling_store, targets)(samples);
}

}  // namespace sheer
#endif
