// The rays of ambient occlusion, made ready for a frame.
#pragma once

#include <memory>
#include <vector>

#include <sheer/render.h>
#include <sheer/scene.h>

#include "geometry/triangles.h"
#include "scene/camera.h"
#include "shade/ambient_occlusion.h"

namespace sheer {

struct SkyPass {
    const Scene& scene;
    const AmbientOcclusion& settings;
    const Projection& projection;
    const Eye& eye;
    const FrameSurfaces& surfaces;
    std::uint32_t key;  // of the frame's random numbers
};

struct SkyRays {
    std::unique_ptr<const OcclusionRays> rays;  // or null
    std::vector<PassTime> passes;               // one, or none without rays
};

// Throws Error(Fault::work) when the memory limit of the options is too low.
SkyRays prepare_sky_rays(const SkyPass& pass, const Options& options);

}  // namespace sheer
