// What a fragment counts for by its distance from the eye: that of its pixel's centre, as on a GPU.
#if defined(SHEER_WEIGHTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_WEIGHTS_INL_H
#undef SHEER_WEIGHTS_INL_H
#else
#define SHEER_WEIGHTS_INL_H
#endif

#include "lanes/lanes-inl.h"
#include "methods/method.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

using WeightBlock = Lanes<16>;  // of fragments

// What a depth buffer between znear and zfar has at distance z, or one without an end.
HWY_INLINE WeightBlock::real buffer_depth(const EyeSpace& eye, WeightBlock::real z)
{
    using Real = WeightBlock::real;
    const Real znear(eye.znear), zfar(eye.zfar);
    if (eye.orthographic) {
        return eye.zfar > eye.znear ? (z - znear) / (zfar - znear) : Real(0.0f);
    }
    return eye.zfar > 0 ? (znear * zfar / z - zfar) / (znear - zfar) : Real(1.0f) - znear / z;
}

// Makes weights[i] = weigh(depth, z, opacity) of each fragment i at distance z. There is room for
// FragmentStream::kSlack more.
template <class Weigh>
HWY_INLINE void weigh_fragments(const FragmentStream& f, const EyeSpace& eye,
                                AlignedArray<float>& weights, Weigh&& weigh)
{
    using Real = WeightBlock::real;
    for (std::size_t r = 0; r < static_cast<std::size_t>(f.run_count); ++r) {
        const FragmentRun& run = f.runs[r];
        for (std::size_t i = run.first; i < run.first + run.count; i += WeightBlock::kCount) {
            const Real depth = depth_at_centers<WeightBlock>(run.depth, f.depth.data() + i);
            const Real z = eye.orthographic ? depth : Real(-1.0f) / depth;
            weigh(depth, z, Real::load(f.opacity.data() + i)).store(weights.data() + i);
        }
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_WEIGHTS_INL_H
