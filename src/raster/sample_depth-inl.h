// Depth at a pixel's samples from depth at its centre.
#if defined(SHEER_SAMPLE_DEPTH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SAMPLE_DEPTH_INL_H
#undef SHEER_SAMPLE_DEPTH_INL_H
#else
#define SHEER_SAMPLE_DEPTH_INL_H
#endif

#include "lanes/lanes-inl.h"
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

// The one expression for depth at a sample: whatever compares depths compares the same bits.
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

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SAMPLE_DEPTH_INL_H
