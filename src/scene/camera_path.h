// Where a moving camera is.
#pragma once

#include <span>

#include <sheer/film.h>

namespace sheer {

// Cubic Hermite splines through the keys, 1 at least. Slopes of places are those of the parabola
// through a key and its two neighbours, at the ends those of the chord: Catmull and Rom's, for
// frames that need not be evenly spaced (A Class of Local Interpolating Splines. 1974). Those of
// angles are limited so that angles stay between their keys' (Fritsch and Carlson. Monotone
// Piecewise Cubic Interpolation. 1980).
CameraKey between_keys(std::span<const CameraKey> keys, double frame);

// `start` turned and moved. `part`: of the path, in [0, 1]. Distances grow by the same factor in
// equal parts.
CameraKey along_path(const CameraPath& path, const CameraKey& start, double part);

// The view with eye, target and fov of the camera that `render` would take for the scene; so it
// stands still when the scene moves.
View standing_view(const Scene& scene, const View& view);

}  // namespace sheer
