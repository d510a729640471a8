// Layers in the order of depth where floats can't tell it, too: for stores that are exact.
#if defined(SHEER_PRECISE_DEPTH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_PRECISE_DEPTH_INL_H
#undef SHEER_PRECISE_DEPTH_INL_H
#else
#define SHEER_PRECISE_DEPTH_INL_H
#endif

#include <cstddef>
#include <limits>

#include "methods/sample_depths-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// precise_depth as the sum of two floats, of which the upper is the nearest to it: 32 significant
// bits are 24 and what is left. Ordered by the upper, then by the lower, which is as by the sum.
template <class L>
struct PreciseDepth {
    using real = typename L::real;
    using mask = typename L::mask;
    real upper, lower;

    PreciseDepth() = default;
    HWY_INLINE PreciseDepth(real depth) : upper(depth), lower(0.0f) {}
    HWY_INLINE PreciseDepth(real high, real low) : upper(high), lower(low) {}
    // At samples first, first + 1, ... of a pixel of the tile.
    HWY_INLINE PreciseDepth(const DepthPlane& plane, const SampleSet& set, std::size_t pixel,
                            std::size_t first)
    {
        // One vector of doubles for one of floats, or two.
        using W = WideLanes<L::kCount>;
        const Halves<W> near(precise_depths<W>(plane, set, pixel, first));
        if constexpr (W::kCount == L::kCount) {
            upper = near.upper;
            lower = near.lower;
        } else {
            const Halves<W> far(precise_depths<W>(plane, set, pixel, first + W::kCount));
            // Not hn::Combine, which single lanes have not.
            upper = Combine(typename L::F(), far.upper, near.upper);
            lower = Combine(typename L::F(), far.lower, near.lower);
        }
    }
    friend HWY_ATTR HWY_INLINE mask operator<(const PreciseDepth& a, const PreciseDepth& b)
    {
        return a.upper < b.upper || (a.upper == b.upper && a.lower < b.lower);
    }
    friend HWY_ATTR HWY_INLINE mask operator==(const PreciseDepth& a, const PreciseDepth& b)
    {
        return a.upper == b.upper && a.lower == b.lower;
    }
    static HWY_INLINE PreciseDepth select(mask m, const PreciseDepth& a, const PreciseDepth& b)
    {
        return {L::select(m, a.upper, b.upper), L::select(m, a.lower, b.lower)};
    }

private:
    template <class W>
    struct Halves {
        hn::Vec<typename W::Float> upper, lower;
        HWY_INLINE explicit Halves(typename W::real depth)
            : upper(depth.narrowed()),
              lower(
                  typename W::real(depth - typename W::real(hn::PromoteTo(typename W::D(), upper)))
                      .narrowed())
        {
        }
    };
};

// Lanes whose depth_real is that.
template <int S>
struct PreciseLanes : Lanes<S> {
    using depth_real = PreciseDepth<Lanes<S>>;
};

// What is known of a layer before its precise depth.
template <class L>
struct RoughLayer {
    typename L::mask covered;
    typename L::whole id;
    typename L::real nearest, farthest;  // between which its depth is

    // Than a layer of that depth.
    HWY_INLINE typename L::mask may_be_before(typename L::real depth) const
    {
        return nearest <= depth;
    }
    HWY_INLINE typename L::mask may_be_behind(typename L::real depth) const
    {
        return farthest >= depth;
    }
    // The layer of that depth and id.
    HWY_INLINE typename L::mask is(typename L::real depth, typename L::whole other) const
    {
        return may_be_before(depth) & may_be_behind(depth) & (id == other);
    }
};

// As for_each_layer, of a Text over PreciseLanes. As precise depths take time, first is asked
// wanted(pixel, s, rough).
template <int S, class Text, class Wanted, class Visit>
HWY_INLINE void for_each_precise_layer(const FragmentStream& f, const SampleSet& set,
                                       Wanted&& wanted, Visit&& visit)
{
    using L = Lanes<S>;
    using real = typename L::real;
    const auto clear = Text::layer_clear(real(std::numeric_limits<float>::infinity()));
    for_each_sample_depth<S>(
        f, set,
        [&](const DepthPlane& plane, std::uint32_t primitive, std::size_t i, std::size_t s,
            real depth) HWY_ATTR {
            const std::size_t pixel = f.pixel[i];
            const real slack(plane.slack);
            const RoughLayer<L> rough{sample_mask<L>(f, i, s), typename L::whole(primitive),
                                      depth - slack, depth + slack};
            if (!wanted(pixel, s, rough)) return;
            visit(pixel, s,
                  Text::layer_of(rough.covered, clear, PreciseDepth<L>(plane, set, pixel, s),
                                 rough.id, color_of<Text>(f, i), real(f.opacity[i])));
        });
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_PRECISE_DEPTH_INL_H
