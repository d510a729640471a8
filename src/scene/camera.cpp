// Which camera a view means, and its projection. The rules for glTF's cameras are those of
// glTF 2.0, section 3.10, with one addition: a picture of another shape than the camera's shows all
// that the camera would, and more on two sides.
#include "scene/camera.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <sheer/error.h>

#include "scene/framing.h"
#include "support/math.h"

namespace sheer {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kOwnFov = 40;     // degrees, where a view gives eye and target alone
constexpr double kFramedFov = 35;  // degrees

double aspect_of(const View& view)
{
    return static_cast<double>(view.width) / view.height;
}

void set_fov(Projection& projection, double half_tangent, double aspect)
{
    projection.scale_y = 1 / half_tangent;
    projection.scale_x = projection.scale_y / aspect;
}

bool finite(const Float3& v)
{
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

double half_tangent_of(double fov_degrees)
{
    return own_tan(fov_degrees * (kPi / 360));
}

Projection own_camera(const Scene& scene, const View& view)
{
    if (!view.eye) throw Error(Fault::input, "target: an eye is needed with it");
    if (!view.target) throw Error(Fault::input, "eye: a target is needed with it");
    if (!finite(*view.eye)) throw Error(Fault::input, "eye: not finite");
    if (!finite(*view.target)) throw Error(Fault::input, "target: not finite");
    if (*view.eye == *view.target) throw Error(Fault::input, "eye: the same point as the target");
    const double fov = view.fov ? static_cast<double>(*view.fov) : kOwnFov;
    // Below it the snapped grid is finer than the scene's own floats.
    if (!(fov >= 0.001 && fov < 180)) {
        throw Error(Fault::input, "fov: not between 0.001 and 180 degrees");
    }
    Vec3 eye, back;
    for (std::size_t i = 0; i < 3; ++i) {
        eye[i] = (*view.eye)[i];
        back[i] = eye[i] - (*view.target)[i];
    }
    const Pose pose = look_along(eye, back);
    Projection projection;
    set_pose(projection, pose);
    set_fov(projection, half_tangent_of(fov), aspect_of(view));
    projection.znear = safe_near(pose, corner_points(scene));
    return projection;
}

std::string list_cameras(const Scene& scene)
{
    constexpr std::size_t kMost = 20;
    if (scene.cameras.empty()) return "the scene has none";
    std::string list = "there are";
    for (std::size_t i = 0; i < std::min(kMost, scene.cameras.size()); ++i)
        list += (i > 0 ? ", " : " ") + std::to_string(i) + " '" + scene.cameras[i].name + "'";
    if (scene.cameras.size() > kMost)
        list += " and " + std::to_string(scene.cameras.size() - kMost) + " more";
    return list;
}

std::size_t find_camera(const Scene& scene, const std::string& wanted)
{
    if (wanted.empty()) return 0;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        if (scene.cameras[i].name == wanted) return i;
    std::size_t index = 0;
    const char* const end = wanted.data() + wanted.size();
    const auto result = std::from_chars(wanted.data(), end, index);
    if (result.ec == std::errc() && result.ptr == end && index < scene.cameras.size()) return index;
    throw Error(Fault::input, "camera '" + wanted + "': no such camera; " + list_cameras(scene));
}

void check(const Camera& camera, const std::string& label)
{
    const auto fail = [&](const char* fault) { throw Error(Fault::input, label + fault); };
    for (const float value : camera.transform)
        if (!std::isfinite(value)) fail("its transform is not finite");
    if (!(camera.znear >= 0) || (!camera.orthographic && !(camera.znear > 0)))
        fail("znear must be positive");
    if (!(camera.zfar == 0 || camera.zfar > camera.znear)) fail("zfar must exceed znear");
    if (camera.orthographic) {
        if (!std::isfinite(camera.xmag) || !std::isfinite(camera.ymag) || camera.xmag == 0 ||
            camera.ymag == 0)
            fail("xmag and ymag must be finite and not 0");
    } else {
        if (!(camera.yfov > 0 && camera.yfov < kPi)) fail("yfov must be between 0 and pi");
        if (!(camera.aspect >= 0) || !std::isfinite(camera.aspect)) fail("its aspect is negative");
    }
}

void set_orthographic(Projection& projection, const Camera& camera, double aspect)
{
    const double half_width = std::abs(static_cast<double>(camera.xmag));
    const double half_height = std::abs(static_cast<double>(camera.ymag));
    projection.orthographic = true;
    set_fov(projection, std::max(half_height, half_width / aspect), aspect);
}

void set_perspective(Projection& projection, const Camera& camera, double aspect)
{
    // A picture narrower than the camera's own keeps the width of the view, not its height.
    const double widening = camera.aspect > aspect ? camera.aspect / aspect : 1;
    set_fov(projection, own_tan(camera.yfov / 2.0) * widening, aspect);
}

Projection scene_camera(const Scene& scene, const View& view)
{
    const std::size_t index = find_camera(scene, view.camera);
    const Camera& camera = scene.cameras[index];
    const std::string label = "camera " + std::to_string(index) + " '" + camera.name + "': ";
    check(camera, label);
    Vec3 column[4];
    for (std::size_t i = 0; i < 16; ++i)
        if (i % 4 < 3) column[i / 4][i % 4] = camera.transform[i];
    Pose pose;
    if (!orthonormalize({column[0], column[1], column[2]}, pose))
        throw Error(Fault::input, label + "its transform flattens space");
    pose.eye = column[3];
    Projection projection;
    set_pose(projection, pose);
    if (camera.orthographic)
        set_orthographic(projection, camera, aspect_of(view));
    else
        set_perspective(projection, camera, aspect_of(view));
    projection.znear = camera.znear;
    projection.zfar = std::isfinite(camera.zfar) ? camera.zfar : 0;
    return projection;
}

}  // namespace

void set_pose(Projection& projection, const Pose& pose)
{
    const Vec3 rows[3] = {pose.right, pose.up, pose.back};
    for (std::size_t row = 0; row < 3; ++row) {
        double shift = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            projection.world_to_view[4 * i + row] = rows[row][i];
            shift -= rows[row][i] * pose.eye[i];
        }
        projection.world_to_view[12 + row] = shift;
    }
    projection.world_to_view[15] = 1;
    std::copy(pose.eye.begin(), pose.eye.end(), projection.eye);
}

Projection frame_scene(const Scene& scene, const View& view)
{
    const std::vector<Vec3> points = corner_points(scene);
    const double half_tangent = half_tangent_of(kFramedFov);
    const Pose pose = frame_points(points, {half_tangent * aspect_of(view), half_tangent});
    Projection projection;
    set_pose(projection, pose);
    set_fov(projection, half_tangent, aspect_of(view));
    projection.znear = safe_near(pose, points);
    return projection;
}

Projection resolve_camera(const Scene& scene, const View& view)
{
    if (view.eye || view.target) return own_camera(scene, view);
    if (view.fov) throw Error(Fault::input, "fov: an eye and a target are needed with it");
    if (!scene.cameras.empty() || !view.camera.empty()) return scene_camera(scene, view);
    return frame_scene(scene, view);
}

}  // namespace sheer
