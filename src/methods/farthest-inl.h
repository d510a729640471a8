// The depths that a tile's samples keep; that behind which a pixel shows nothing more, and the
// fragments before it.
#if defined(SHEER_FARTHEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_FARTHEST_INL_H
#undef SHEER_FARTHEST_INL_H
#else
#define SHEER_FARTHEST_INL_H
#endif

#include <cmath>
#include <limits>
#include <type_traits>

#include "lanes/lanes-inl.h"
#include "methods/method.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Where a store has the nearest fragments: the depths of a pixel's samples, then their ids.
struct KeptDepths {
    const float* values;
    std::size_t channels;  // of a sample

    HWY_INLINE const float* of_pixel(std::size_t pixel, std::size_t samples) const
    {
        return values + channels * pixel * samples;
    }
};

// Passes of the same frame that are to be independent: an odd number between their keys.
inline constexpr std::uint32_t kPassesApart = 0x632be5abu;

class Farthest {
public:
    using Block = Lanes<16>;  // of fragments
    using whole = Block::whole;
    using Real = Block::real;

    // Of each pixel: the most depth that a sample keeps.
    float* data() { return of_pixel_.data(); }
    const float* data() const { return of_pixel_.data(); }
    void clear()
    {
        std::fill_n(of_pixel_.data(), kTilePixels, std::numeric_limits<float>::infinity());
    }

    // i, i + 1, ...
    static HWY_INLINE whole numbers(std::size_t i)
    {
        return Block::iota() + whole(static_cast<std::int32_t>(i));
    }

    // Calls visit(packing, i, pixels, depths) for the run's fragments i, i + 1, ..., a vector at a
    // time, of which the packing leaves those that are nearer than that at a sample, or may be.
    template <class Visit>
    HWY_INLINE void for_each_nearer(const FragmentStream& f, const FragmentRun& run,
                                    Visit&& visit) const
    {
        const DepthPlane& plane = run.depth;
        const Real least(plane.least), most(plane.most);
        const Real reach(0.5f * (std::abs(plane.dx) + std::abs(plane.dy)) + plane.slack);
        const std::size_t last = run.first + run.count;
        const whole end(static_cast<std::int32_t>(last));
        const float* far = of_pixel_.data();
        for (std::size_t i = run.first; i < last; i += Block::kCount) {
            // What lies past the stream's end may be any number.
            const whole pixels = whole::load(f.pixel.data() + i) & whole(kTilePixels - 1);
            const Real depths = Real::load(f.depth.data() + i);
            const Real nearest = Block::min(Block::max(depths - reach, least), most);
            // Written so that a depth that is no number may be nearer.
            const auto keep = !(nearest > Block::gather(far, pixels)) && numbers(i) < end;
            if (keep.any()) visit(typename Block::Packing(keep), i, pixels, depths);
        }
    }

private:
    AlignedArray<float> of_pixel_{kTilePixels};
};

// Calls insert(k, count) for a run's candidates of `masks` from k on that are before `end` in the
// stream, one or two (count: a constant) at once. No two of them are in one pixel, so that what the
// first one reads and stores and what the second one does have nothing to wait for. Returns the
// number of the next run's first.
template <class Masks, class Insert>
HWY_INLINE std::size_t two_at_once(const Masks& masks, std::size_t k, std::size_t end,
                                   Insert&& insert)
{
    for (; masks.number(k) < end && masks.number(k + 1) < end; k += 2) {
        insert(k, std::integral_constant<std::size_t, 2>());
    }
    for (; masks.number(k) < end; ++k) insert(k, std::integral_constant<std::size_t, 1>());
    return k;
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_FARTHEST_INL_H
