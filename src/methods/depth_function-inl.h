// A method's function of depth as its stores call it (depth_function.h).
//
// Function says what is added up for a fragment, what is kept of the sums, and what that says:
//   kSums, of which the first is that of the optical depths; kKept, of each pass over the sums
//   addends<W>(place, depth, addends)           the kSums numbers of fragments
//   prepare<W>(sums, to, stride)                kKept floats, `stride` from one to the next
//   transmittance<L>(kept, place)               kept[k]: what was kept; kept.at(k): if k is whole
// and, where there may be a second pass over the sums or a reduced picture,
//   passes()
//   prepare<W>(sums, to, stride, is_first)      instead of that without
//   round_texels<W>(sums)                       of a reduced picture
// W are lanes of doubles. Where a fragment adds to few of the sums there is
//   kTouched                                    and instead of kSums numbers
//   addends_of_one(place, depth, addends, sums) as many, and where they belong
#if defined(SHEER_DEPTH_FUNCTION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_DEPTH_FUNCTION_INL_H
#undef SHEER_DEPTH_FUNCTION_INL_H
#else
#define SHEER_DEPTH_FUNCTION_INL_H
#endif

#include <algorithm>
#include <bit>

#include "lanes/text.h"
#include "methods/depth_function.h"
#include "methods/fragment_units-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Where the depths are too small for the grid of their sums there is nothing to divide.
template <class W>
HWY_INLINE typename W::real depth_divisor(typename W::real depth)
{
    return W::max(depth, typename W::real(0x1p-38));
}

// What is kept of as many samples as L has lanes: of samples that follow one another, or of any.
template <class L>
struct KeptLanes {
    const float* from;
    int stride_bits;
    bool apart;
    typename L::whole places;  // of the lanes' samples, if apart

    HWY_INLINE typename L::real operator[](std::size_t k) const
    {
        const float* number = from + (k << stride_bits);
        return apart ? L::gather(number, places) : L::real::load(number);
    }
    // The same of all lanes, if these are not apart.
    HWY_INLINE typename L::real at(typename L::whole k) const
    {
        if (apart) return L::gather(from, (k << stride_bits) + places);
        return L::real::load(from + (static_cast<std::size_t>(k.first()) << stride_bits));
    }
};

template <class Function>
class DepthFunctionOf final : public DepthFunction {
    using Block = Lanes<16>;
    using Wide = WideLanes<kPrepared>;
    static constexpr bool kReducible = requires(const Function& function)
    {
        function.passes();  // and with it the others
    };
    static_assert(Function::kSums <= kMostSums && Function::kKept <= kMostKept);

public:
    explicit DepthFunctionOf(const ChosenMethod& method) : DepthFunctionOf(Function(method)) {}

    AddedUnits find_units(const float* places, const float* depths, std::size_t some) override
    {
        units_.set(function_, places, depths, some, false);
        return {units_.units(), units_.sums()};
    }

    void add_to_pixels(const float* places, const float* depths, std::size_t some,
                       const std::uint32_t* pixels, std::int64_t* sums, std::size_t stride) override
    {
        units_.set(function_, places, depths, some);
        for (std::size_t i = 0; i < some; ++i) units_.add_to(sums + pixels[i] * stride, i);
    }

    void prepare(const PreparedSums& sums, float* to, std::size_t stride,
                 bool is_first) const override
    {
        for (std::size_t i = 0; i < kPrepared; i += Wide::kCount) {
            typename Wide::real some[Function::kSums];
            for (std::size_t k = 0; k < Function::kSums; ++k)
                some[k] = Wide::real::load(&sums[k][i]);
            if constexpr (kReducible) {
                function_.template prepare<Wide>(some, to + i, stride, is_first);
            } else {
                function_.template prepare<Wide>(some, to + i, stride);
            }
        }
    }

    void round_texels(PreparedSums& sums) const override
    {
        if constexpr (kReducible) {
            for (std::size_t i = 0; i < kPrepared; i += Wide::kCount) {
                typename Wide::real some[Function::kSums];
                for (std::size_t k = 0; k < Function::kSums; ++k) {
                    some[k] = Wide::real::load(&sums[k][i]);
                }
                function_.template round_texels<Wide>(some);
                for (std::size_t k = 0; k < Function::kSums; ++k) some[k].store(&sums[k][i]);
            }
        }
    }

    void find_transmittances(const KeptNumbers& kept, const std::uint32_t* pixels,
                             const float* places, std::size_t fragments,
                             float* values) const override
    {
        if constexpr (Block::kCount > 8) {
            // Two fragments in one vector would have to be gathered.
            if (kept.samples == 8) return find<Lanes<8>>(kept, pixels, places, fragments, values);
        }
        find<Block>(kept, pixels, places, fragments, values);
    }

private:
    explicit DepthFunctionOf(Function function)
        : DepthFunction({Function::kSums, touched_sums<Function>(),
                         Function::kKept * static_cast<std::size_t>(passes_of(function)),
                         passes_of(function)}),
          function_(function)
    {
    }
    static int passes_of(const Function& function)
    {
        if constexpr (kReducible)
            return function.passes();
        else
            return 1;
    }

    template <class L>
    void find(const KeptNumbers& kept, const std::uint32_t* pixels, const float* places,
              std::size_t fragments, float* values) const
    {
        using Real = typename L::real;
        const int bits = std::countr_zero(kept.samples);
        const std::size_t all = fragments << bits;
        KeptLanes<L> lanes{kept.from, kept.stride_bits, kept.samples < L::kCount, {}};
        for (std::size_t n = 0; n < all; n += L::kCount) {
            Real place;
            if (!lanes.apart) {
                const std::size_t i = n >> bits;
                place = Real(places[i]);
                lanes.from = kept.from + pixels[i] * kept.pixel_stride + (n & (kept.samples - 1));
            } else if (bits == 0) {
                // What lies past the last may be any number.
                lanes.places = L::whole::load(pixels + n) &
                               typename L::whole(static_cast<std::uint32_t>(kTilePixels - 1));
                place = Real::load(places + n);
            } else {
                place = set_lanes_apart<L>(kept, pixels, places, fragments, n, lanes);
            }
            function_.template transmittance<L>(lanes, place).store(values + n);
        }
    }

    // Samples n, n + 1, ... of all that are asked for; the last fragment is repeated.
    template <class L>
    static HWY_INLINE typename L::real set_lanes_apart(const KeptNumbers& kept,
                                                       const std::uint32_t* pixels,
                                                       const float* places, std::size_t fragments,
                                                       std::size_t n, KeptLanes<L>& lanes)
    {
        const int bits = std::countr_zero(kept.samples);
        alignas(64) std::uint32_t at[L::kCount];
        alignas(64) float place[L::kCount];
        for (std::size_t j = 0; j < L::kCount; ++j) {
            const std::size_t i = std::min((n + j) >> bits, fragments - 1);
            at[j] = pixels[i] * static_cast<std::uint32_t>(kept.pixel_stride) +
                    static_cast<std::uint32_t>((n + j) & (kept.samples - 1));
            place[j] = places[i];
        }
        lanes.places = L::whole::load(at);
        return L::real::load(place);
    }

    Function function_;
    FragmentUnits<Function, kChunk> units_;
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_DEPTH_FUNCTION_INL_H
