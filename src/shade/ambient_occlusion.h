// How much of the sky a point sees: rays over the hemisphere around its normal, more of them where
// more light comes from, in proportion to the cosine.
// C. Wyman, M. McGuire. Improved Alpha Testing Using Hashed Sampling. TVCG 25(2), 2019, section 9.
#pragma once

#include <cstdint>

#include <sheer/render.h>

#include "shade/light_rays.h"

namespace sheer {

// A point that is lit by the sky, world axes.
struct SkyPoint {
    Vec3d place;   // relative to the triangle's first vertex
    Vec3d normal;  // unit
    Vec3d plane;   // the triangle's normal to the side that is seen; unit, or zero: there is none
};

class OcclusionRays {
public:
    // `eye`: what lines and points face, in a picture `height` pixels high. `surfaces` and `scene`
    // are to outlive this. `key`: of the frame's random numbers.
    OcclusionRays(const Scene& scene, const FrameSurfaces& surfaces, const Projection& eye,
                  const Eye& seen_from, const AmbientOcclusion& settings, std::uint32_t key);

    bool is_hashed() const { return settings_.samples == RaySamples::hashed; }
    RayCells cells() const { return settings_.cells; }
    std::uint32_t key() const { return key_; }

    // In [0, 1]: the mean over the rays, whose directions are evenly spread points of a square,
    // moved by the two numbers in [0, 1].
    double open_part(const RayOrigin& origin, const SkyPoint& point, double chi1,
                     double chi2) const;

private:
    AmbientOcclusion settings_;
    std::uint32_t key_;
    Eye eye_;
    Casters casters_;
};

}  // namespace sheer
