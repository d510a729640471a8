// From a scene and a view to the numbers that project its vertices.
#pragma once

#include <sheer/render.h>
#include <sheer/scene.h>

#include "scene/framing.h"

namespace sheer {

// A world point p goes to the view point q = world_to_view p, which looks along -z. Then
//   w = -q.z (perspective) or 1 (orthographic),  x_ndc = scale_x q.x / w,  y_ndc = scale_y q.y / w
// and the picture is -1..1 in both, y up. What is nearer than znear along the axis of view is not
// seen, nor what is farther than zfar where that isn't 0.
struct Projection {
    double world_to_view[16] = {};  // column-major, rigid
    double scale_x = 1, scale_y = 1;
    bool orthographic = false;
    double eye[3] = {};  // world space
    double znear = 0;    // > 0 under a perspective camera
    double zfar = 0;
};

// Fills in world_to_view and eye.
void set_pose(Projection& projection, const Pose& pose);

// The camera of a view: its own eye and target, else the one of the scene that it names (or
// numbers), else the scene's first, else one that frames all objects. Throws Error with
// Fault::input when there is no such camera or when it can't see.
Projection resolve_camera(const Scene& scene, const View& view);

// From the front right and a little above, as near as all objects' bounds allow with a margin of
// 5 % of the picture.
Projection frame_scene(const Scene& scene, const View& view);

}  // namespace sheer
