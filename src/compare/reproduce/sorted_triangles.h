// A scene's triangles in another order of submission.
#pragma once

#include <sheer/render.h>
#include <sheer/scene.h>

namespace sheer {

enum class TriangleOrder { near_to_far, far_to_near };

// Of triangles alone, by the distance of their centroids from the view's eye, along its axis. Which
// object they belong to is lost.
Scene with_sorted_triangles(const Scene& scene, const View& view, TriangleOrder order);

}  // namespace sheer
