// The shadow pass: what each light sees, drawn as the camera's picture is, or rays to the lights.
#pragma once

#include <cstdint>

#include <sheer/render.h>
#include <sheer/scene.h>

#include "geometry/triangles.h"
#include "lanes/targets.h"
#include "methods/method.h"
#include "shade/shadow_map.h"
#include "shade/surface.h"

namespace sheer {

struct ShadowPass {
    const Scene& scene;
    const Shadows& shadows;
    const Geometry& seen;  // by the camera
    const FrameSurfaces& surfaces;
    TargetSet targets;
    int threads;
    std::uint32_t key;  // of the frame's random numbers
    FrameOfPicture frame = {};
};

struct FrameShadows {
    LightShadows shadows;
    std::vector<PassTime> passes;  // one, or none without shadows

    const LightShadows* drawn() const { return shadows.empty() ? nullptr : &shadows; }
};

// Throws Error(Fault::work) when the memory limit of the options is too low.
FrameShadows prepare_shadows(const ShadowPass& pass, const Options& options);

}  // namespace sheer
