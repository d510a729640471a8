// Depth at a pixel's samples from depth at its centre.
#if defined(SHEER_SAMPLE_DEPTH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SAMPLE_DEPTH_INL_H
#undef SHEER_SAMPLE_DEPTH_INL_H
#else
#define SHEER_SAMPLE_DEPTH_INL_H
#endif

#include <algorithm>

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

// At the centres of pixels, one a lane, from the plane's values there: that of a pixel at the
// triangle's edge may lie behind the eye.
template <class L>
HWY_INLINE typename L::real depth_at_centers(const DepthPlane& plane, const float* centers)
{
    using real = typename L::real;
    return L::min(L::max(real::load(centers), real(plane.least)), real(plane.most));
}

// Of sample s alone: the same bits as in lanes.
HWY_INLINE float sample_depth_at(const DepthPlane& plane, const SampleSet& set, float center,
                                 std::size_t s)
{
    const float offset = set.offset_x[s] * plane.dx + set.offset_y[s] * plane.dy;
    return std::clamp(center + offset, plane.least, plane.most);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SAMPLE_DEPTH_INL_H
