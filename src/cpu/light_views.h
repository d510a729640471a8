// Where a light's shadow map looks.
#pragma once

#include <optional>
#include <vector>

#include <sheer/render.h>
#include <sheer/scene.h>

#include "geometry/triangles.h"
#include "scene/camera.h"
#include "shade/surface.h"

namespace sheer {

// Of the sun and of each of the scene's lights, in ShadowMaps' order; none for a light without a
// shadow: one that is dark, or a point light, or where nothing of the scene is lit. The sun's and a
// directional light's map is fitted around what is lit in the picture, a spot light's holds its
// cone, up to kWidestCone. Unlit surfaces neither cast nor receive shadows.
std::vector<std::optional<Projection>> light_views(const Scene& scene, const Shadows& shadows,
                                                   const Geometry& seen,
                                                   const FrameSurfaces& surfaces);

// Half the angle of the widest map, radians: 80 degrees. Beyond it a spot light casts no shadow.
inline constexpr double kWidestCone = 1.3962634;

}  // namespace sheer
