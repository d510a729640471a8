// Rays from a vector of fragments to a light, one after the other.
#if defined(SHEER_LIGHT_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_LIGHT_RAYS_INL_H
#undef SHEER_LIGHT_RAYS_INL_H
#else
#define SHEER_LIGHT_RAYS_INL_H
#endif

#include "shade/light_rays.h"
#include "shade/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// `place`: relative to the triangle's first vertex, world axes; `lanes` hold a point.
template <class L>
HWY_NOINLINE Vector<L> light_through(const LightRays& rays, const RayOrigin& origin,
                                     const Vector<L>& place, int lanes)
{
    alignas(64) float x[16], y[16], z[16], part[3][16] = {};
    place.x.store(x);
    place.y.store(y);
    place.z.store(z);
    for (int i = 0; i < std::min(lanes, L::kCount); ++i) {
        const auto through = rays.transmittance(ray_start(rays.eye, origin, {x[i], y[i], z[i]}));
        for (std::size_t c = 0; c < 3; ++c) part[c][i] = static_cast<float>(through[c]);
    }
    using real = typename L::real;
    return {real::load(part[0]), real::load(part[1]), real::load(part[2])};
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_LIGHT_RAYS_INL_H
