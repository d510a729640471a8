// Views, a scene that is a box, and the projection of points: what the tests of cameras share.
#pragma once

#include <sheer/render.h>
#include <sheer/scene.h>

#include "scene/camera.h"
#include "scene/framing.h"

namespace sheer {

inline View view_of(int width, int height)
{
    View view;
    view.width = width;
    view.height = height;
    return view;
}

inline Scene box_scene(const Float3& low, const Float3& high)
{
    Scene scene;
    Mesh mesh;
    mesh.positions = {low, high};
    scene.meshes.push_back(mesh);
    scene.objects.push_back({"box", 0, kIdentity, 0});
    return scene;
}

struct Projected {
    double x, y, depth;
};

inline Projected project(const Projection& camera, const Vec3& p)
{
    double q[3];
    const double* m = camera.world_to_view;
    for (int i = 0; i < 3; ++i) q[i] = m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i];
    const double w = camera.orthographic ? 1 : -q[2];
    return {camera.scale_x * q[0] / w, camera.scale_y * q[1] / w, -q[2]};
}

}  // namespace sheer
