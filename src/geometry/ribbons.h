// Lines and points as triangles that face the camera.
#pragma once

#include <sheer/scene.h>

#include "scene/camera.h"

namespace sheer {

struct RibbonView {
    const Projection& projection;
    int height;  // of the picture, pixels
};

// In world space. Each run of pieces is one ribbon, which turns with the line and is as wide
// everywhere but at corners sharper than 60 degrees.
Mesh make_ribbons(const Mesh& lines, const Mat4& to_world, const RibbonView& view);

// In world space, upright in the picture.
Mesh make_squares(const Mesh& points, const Mat4& to_world, const RibbonView& view);

}  // namespace sheer
