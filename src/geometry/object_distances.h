// Objects by their distance, as engines sort them.
#pragma once

#include <vector>

#include "scene/camera.h"

namespace sheer {

// For each object the distance from the eye, along the axis of view, of the centre of its mesh's
// bounding box.
std::vector<float> object_distances(const Scene& scene, const Projection& projection);

}  // namespace sheer
