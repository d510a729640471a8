// Layers of a pixel whose order floats can't tell, or tell apart at its samples: each sample gets
// its own order of them, in doubles, and of equal depths by primitive.
#if defined(SHEER_EXACT_DOUBTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_EXACT_DOUBTS_INL_H
#undef SHEER_EXACT_DOUBTS_INL_H
#else
#define SHEER_EXACT_DOUBTS_INL_H
#endif

#include <cstddef>
#include <cstdint>

#include "lanes/lanes-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Precise depths at the samples of lanes, as two words that are ordered like them, the upper one
// first. What 32 significant bits leave free of the lower one is zero.
template <class L>
struct DepthWords {
    static constexpr int kFreeBits = 21;
    typename L::whole upper, lower;

    HWY_INLINE DepthWords() = default;
    HWY_INLINE DepthWords(const DepthPlane& plane, const SampleSet& set, std::size_t pixel,
                          std::size_t first)
    {
        using W = WideLanes<L::kCount>;
        constexpr std::int64_t kMagnitude = 0x7fffffffffffffff;
        constexpr std::int64_t kSignificant = -(std::int64_t{1} << kFreeBits);
        alignas(64) std::int64_t bits[L::kCount];
        for (std::size_t i = 0; i < L::kCount; i += W::kCount) {
            const auto depth = precise_depths<W>(plane, set, pixel, first + i);
            // -0 becomes 0.
            W::whole::bits_of(depth + typename W::real(0.0)).store(bits + i);
        }
        alignas(64) std::int32_t uppers[L::kCount], lowers[L::kCount];
        for (std::size_t i = 0; i < L::kCount; ++i) {
            // Below zero the larger magnitude is the smaller number.
            const std::int64_t ordered = (bits[i] ^ (bits[i] >> 63 & kMagnitude)) & kSignificant;
            uppers[i] = static_cast<std::int32_t>(ordered >> 32);
            // The lower word has no sign, but is compared as if it had one.
            lowers[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(ordered) ^ 1u << 31);
        }
        upper = L::whole::load(uppers);
        lower = L::whole::load(lowers);
    }
    friend HWY_ATTR HWY_INLINE typename L::mask operator<(const DepthWords& a, const DepthWords& b)
    {
        return a.upper < b.upper || (a.upper == b.upper && a.lower < b.lower);
    }
};

// Few layers, at a vector of samples. Exchanges of neighbours, which are few, put them in order.
template <class L, class Verbs>
struct DoubtfulLayers {
    using mask = typename L::mask;
    using Fragment = typename Verbs::Fragment;
    static constexpr std::size_t kMost = 8;
    static_assert(kMost <= std::size_t{1} << DepthWords<L>::kFreeBits);

    struct Item {
        DepthWords<L> depth;
        Fragment fragment;
    };
    Item items[kMost];
    std::uint32_t primitives[kMost];
    std::uint32_t ranks[kMost];  // of the primitives
    std::size_t size = 0;

    // Where `covered` says no, the layer lets all light through, so that it may be anywhere.
    template <class Layer>
    HWY_INLINE void add(const Layer& layer, std::uint32_t primitive, mask covered,
                        const DepthWords<L>& depth)
    {
        items[size] = {depth, Verbs::template where<L>(covered, layer)};
        primitives[size] = primitive;
        ranks[size] = 0;
        for (std::size_t i = 0; i < size; ++i) ++ranks[primitive < primitives[i] ? i : size];
        ++size;
    }

    template <class Sum>
    HWY_INLINE Sum composite(Sum sum)
    {
        for (std::size_t i = 0; i < size; ++i) {
            items[i].depth.lower = items[i].depth.lower | typename L::whole(ranks[i]);
        }
        for (std::size_t i = 1; i < size; ++i) {
            for (std::size_t k = i; k > 0; --k) {
                const mask swap = items[k].depth < items[k - 1].depth;
                if (!swap.any()) break;
                exchange(swap, items[k - 1], items[k]);
            }
        }
        for (std::size_t i = 0; i < size; ++i) sum = Verbs::add(sum, items[i].fragment);
        return sum;
    }

private:
    static HWY_INLINE void exchange(mask swap, Item& a, Item& b)
    {
        const auto numbers = [&](auto& in_a, auto& in_b) HWY_ATTR {
            const auto old = in_a;
            in_a = L::select(swap, in_b, old);
            in_b = L::select(swap, old, in_b);
        };
        numbers(a.depth.upper, b.depth.upper);
        numbers(a.depth.lower, b.depth.lower);
        Verbs::for_each_number(a.fragment, b.fragment, numbers);
    }
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_EXACT_DOUBTS_INL_H
