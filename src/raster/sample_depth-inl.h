// Depth at a pixel's samples from depth at its centre.
#if defined(SHEER_SAMPLE_DEPTH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SAMPLE_DEPTH_INL_H
#undef SHEER_SAMPLE_DEPTH_INL_H
#else
#define SHEER_SAMPLE_DEPTH_INL_H
#endif

#include <algorithm>

#include "lanes/wide-inl.h"
#include "raster/depth_plane.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// How much deeper samples first, first + 1, ... of a pixel are than its centre.
template <class L>
HWY_INLINE typename L::real sample_depth_offset(const DepthPlane& plane, const SampleSet& set,
                                                std::size_t first)
{
    using real = typename L::real;
    const real x = real::load(set.offset_x.data() + first);
    const real y = real::load(set.offset_y.data() + first);
    return x * real(plane.dx) + y * real(plane.dy);
}

// The one expression for depth at a sample, with sample_depth_at: whatever compares depths compares
// the same bits.
template <class L>
HWY_INLINE typename L::real sample_depth(const DepthPlane& plane, typename L::real offset,
                                         float center)
{
    using real = typename L::real;
    return L::min(L::max(real(center) + offset, real(plane.least)), real(plane.most));
}

// Of samples first, first + 1, ... of one pixel.
template <class L>
HWY_INLINE typename L::real sample_depth(const DepthPlane& plane, const SampleSet& set,
                                         float center, std::size_t first)
{
    return sample_depth<L>(plane, sample_depth_offset<L>(plane, set, first), center);
}

// At the centres of pixels, one a lane, from the plane's values there: that of a pixel at the
// triangle's edge may lie behind the eye.
template <class L>
HWY_INLINE typename L::real depth_at_centers(const DepthPlane& plane, const float* centers)
{
    using real = typename L::real;
    return L::min(L::max(real::load(centers), real(plane.least)), real(plane.most));
}

// precise_depth of samples first, first + 1, ... of a pixel of the tile: the same bits.
template <class W>
HWY_INLINE typename W::real precise_depths(const DepthPlane& plane, const SampleSet& set,
                                           std::size_t pixel, std::size_t first)
{
    using real = typename W::real;
    const real x =
        real(static_cast<double>(pixel % kTileSize)) + real::load(set.offset_x.data() + first);
    const real y =
        real(static_cast<double>(pixel / kTileSize)) + real::load(set.offset_y.data() + first);
    const real depth =
        real(plane.precise_at) + (x * real(plane.precise_dx) + y * real(plane.precise_dy));
    const real clamped = W::min(W::max(depth, real(static_cast<double>(plane.least))),
                                real(static_cast<double>(plane.most)));
    const real big = clamped * real(kSplitTo32Bits);
    return big - (big - clamped);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SAMPLE_DEPTH_INL_H
