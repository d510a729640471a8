// How much light passes to a point, by a map of moments of optical depth.
#pragma once

#include "shade/shadow_map.h"

namespace sheer {

// A point on a map and the plane of its surface.
struct MapPoint {
    float x, y;  // texels
    float depth;
    float depth_x, depth_y;
};

// Of the measure that is mixed in, of single precision: how much, and its second and fourth moment.
// Peters, Muenstermann, Wetzstein and Klein. Improved Moment Shadow Maps for Translucent Occluders,
// Soft Shadows and Single Scattering. JCGT 6(1), 2017.
inline constexpr double kMomentBias = 3e-7, kMomentBiasEven = 0.375;

// Of the map's fragments, from the nearest at -kFarthestPlace on.
inline constexpr float kFarthestPlace = 0.9f;

// Through all that is transparent and before the point, within the map.
float moment_part(const ShadowMap& map, const MapPoint& point);

}  // namespace sheer
