// Fits maps to what lights see.
#include "cpu/light_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cpu/triangle_places.h"
#include "scene/framing.h"
#include "support/math.h"

namespace sheer {

namespace {

// From the least to the greatest along the right, up and back of a pose.
struct Extent {
    Vec3 least, most;

    Extent()
    {
        least.fill(std::numeric_limits<double>::infinity());
        most.fill(-std::numeric_limits<double>::infinity());
    }
    void add(const Vec3& p)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            least[i] = std::min(least[i], p[i]);
            most[i] = std::max(most[i], p[i]);
        }
    }
    bool empty() const { return !(least[0] <= most[0]); }
};

Vec3 along(const Pose& pose, const Vec3& p)
{
    const auto dot = [&](const Vec3& axis) {
        return axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
    };
    return {dot(pose.right), dot(pose.up), dot(pose.back)};
}

// What may be shadowed: the corners of all lit triangles in the picture.
Extent lit_extent(const Geometry& seen, const FrameSurfaces& surfaces, const Pose& pose)
{
    Extent extent;
    const Vec3 eye = {seen.eye.position[0], seen.eye.position[1], seen.eye.position[2]};
    const Vec3 shift = along(pose, eye);
    for (const TriangleChunk& chunk : seen.chunks) {
        for (const Triangle& t : chunk.triangles) {
            if (surfaces.surfaces[t.object].shading == Shading::unlit) continue;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3 p = along(pose, place_of(seen.eye, t, i));
                extent.add({p[0] + shift[0], p[1] + shift[1], p[2] + shift[2]});
            }
        }
    }
    return extent;
}

// The part of a map's half width that is inside its edge: footprints never reach over it.
double inside_edge(const Shadows& shadows)
{
    const double edge = 0.5 * (shadows.filter + 1) + 1;  // texels
    return std::max(0.25, 1 - 2 * edge / shadows.size);
}

std::optional<Projection> parallel_view(const Scene& scene, const Vec3& to_light,
                                        const Shadows& shadows, const Geometry& seen,
                                        const FrameSurfaces& surfaces)
{
    Pose pose = look_along({0, 0, 0}, to_light);
    const Extent lit = lit_extent(seen, surfaces, pose);
    if (lit.empty()) return std::nullopt;
    // From before all that may stand in the light's way; nothing is behind what is lit.
    double front = lit.most[2];
    for (const Vec3& corner : corner_points(scene, CornersOf::lit))
        front = std::max(front, along(pose, corner)[2]);
    const double depth = std::max(front - lit.least[2], 1e-6);
    double half[2];
    for (std::size_t i = 0; i < 2; ++i) half[i] = 0.5 * (lit.most[i] - lit.least[i]);
    // Square texels; a point or a line is given a width.
    const double wide = std::max({half[0], half[1], 1e-3 * depth});
    const Vec3 middle = {0.5 * (lit.least[0] + lit.most[0]), 0.5 * (lit.least[1] + lit.most[1]),
                         front + 0.01 * depth};
    for (std::size_t i = 0; i < 3; ++i) {
        pose.eye[i] = middle[0] * pose.right[i] + middle[1] * pose.up[i] + middle[2] * pose.back[i];
    }
    Projection view;
    set_pose(view, pose);
    view.orthographic = true;
    view.scale_x = view.scale_y = inside_edge(shadows) / wide;
    return view;
}

std::optional<Projection> spot_view(const Scene& scene, const Light& light, const Shadows& shadows)
{
    Vec3 position, back;
    for (std::size_t i = 0; i < 3; ++i) {
        position[i] = static_cast<double>(light.position[i]);
        back[i] = -static_cast<double>(light.direction[i]);
    }
    const Pose pose = look_along(position, back);
    Projection view;
    set_pose(view, pose);
    const double half_angle = std::min(static_cast<double>(light.outer_cone), kWidestCone);
    view.scale_x = view.scale_y = inside_edge(shadows) / own_tan(half_angle);
    view.znear = safe_near(pose, corner_points(scene, CornersOf::lit));
    return view;
}

bool is_dark(const Float3& color)
{
    return color == Float3{0, 0, 0};
}

bool is_direction(const Float3& d)
{
    return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] > 0;
}

Vec3 against(const Float3& direction)
{
    return {-static_cast<double>(direction[0]), -static_cast<double>(direction[1]),
            -static_cast<double>(direction[2])};
}

}  // namespace

std::vector<std::optional<Projection>> light_views(const Scene& scene, const Shadows& shadows,
                                                   const Geometry& seen,
                                                   const FrameSurfaces& surfaces)
{
    const auto parallel = [&](const Float3& color, const Float3& away) {
        return is_dark(color) || !is_direction(away)
                   ? std::nullopt
                   : parallel_view(scene, against(away), shadows, seen, surfaces);
    };
    const Float3& sun = scene.sun.to_light;
    std::vector<std::optional<Projection>> views = {
        parallel(scene.sun.color, {-sun[0], -sun[1], -sun[2]})};
    for (const Light& light : scene.lights) {
        std::optional<Projection> view;
        if (light.kind == LightKind::directional) view = parallel(light.intensity, light.direction);
        if (light.kind == LightKind::spot && !is_dark(light.intensity) &&
            is_direction(light.direction)) {
            view = spot_view(scene, light, shadows);
        }
        views.push_back(view);
    }
    return views;
}

}  // namespace sheer
