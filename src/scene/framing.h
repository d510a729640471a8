// Where a camera must stand to see a set of points.
#pragma once

#include <array>
#include <vector>

#include <sheer/scene.h>

namespace sheer {

using Vec3 = std::array<double, 3>;

struct Pose {
    Vec3 right = {1, 0, 0}, up = {0, 1, 0}, back = {0, 0, 1};  // orthonormal, world space
    Vec3 eye = {0, 0, 0};
};

// From `eye` against `back`, y up; straight down -z is up, straight up +z.
Pose look_along(const Vec3& eye, const Vec3& back);

// Gram and Schmidt, from back to right; false when the axes don't span space. Leaves the eye.
bool orthonormalize(const std::array<Vec3, 3>& right_up_back, Pose& pose);

// lit: without objects whose material is unlit; transparent: of those that methods see, MASK too.
enum class CornersOf { all, lit, transparent };

// The corners of each object's bounds, in world space.
std::vector<Vec3> corner_points(const Scene& scene, CornersOf which = CornersOf::all);

struct HalfTangents {
    double x, y;  // of the view's half angles
};

// The nearest pose in the default direction from which all points lie inside the view, with the
// margin.
Pose frame_points(const std::vector<Vec3>& points, HalfTangents view);

// A near distance > 0 that cuts nothing of the points that are well before the eye.
double safe_near(const Pose& pose, const std::vector<Vec3>& points);

}  // namespace sheer
