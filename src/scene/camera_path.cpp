// Splines, turns and distances.
#include "scene/camera_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <sheer/error.h>

#include "scene/camera.h"
#include "support/math.h"

namespace sheer {

namespace {

constexpr double kPi = 3.14159265358979323846;

enum class Limit { none, between_keys };

// Value i of a key: eye, target, fov.
constexpr std::size_t kValues = 7;
float value_of(const CameraKey& key, std::size_t i)
{
    return i < 3 ? key.eye[i] : i < 6 ? key.target[i - 3] : key.fov;
}

struct Spline {
    std::span<const CameraKey> keys;
    std::size_t value;

    double at(std::size_t k) const { return value_of(keys[k], value); }
    double length(std::size_t k) const { return keys[k + 1].frame - keys[k].frame; }
    double chord(std::size_t k) const { return (at(k + 1) - at(k)) / length(k); }

    double slope(std::size_t k, Limit limit) const
    {
        if (k == 0) return chord(0);
        if (k + 1 == keys.size()) return chord(k - 1);
        const double before = chord(k - 1), after = chord(k);
        const double free =
            (length(k) * before + length(k - 1) * after) / (length(k - 1) + length(k));
        if (limit == Limit::none) return free;
        if (before * after <= 0) return 0;
        const double most = 3 * std::min(std::abs(before), std::abs(after));
        return std::clamp(free, -most, most);
    }

    // u in [0, 1], from key k to the next.
    double between(std::size_t k, double u, Limit limit) const
    {
        const double v = 1 - u;
        return v * v * (1 + 2 * u) * at(k) + u * u * (1 + 2 * v) * at(k + 1) +
               length(k) * u * v * (v * slope(k, limit) - u * slope(k + 1, limit));
    }
};

CameraKey camera_of(const Scene& scene, const View& view)
{
    CameraKey key;
    if (view.eye && view.target) {
        key.eye = *view.eye;
        key.target = *view.target;
        key.fov = view.fov.value_or(key.fov);
        return key;
    }
    const Projection projection = resolve_camera(scene, view);
    if (projection.orthographic) {
        throw Error(Fault::input,
                    "eye: the camera is orthographic; one that moves needs an eye and a target");
    }
    double middle[3] = {}, distance = 0, axis[3];
    // What is behind the models may be far away and large.
    std::vector<Vec3> corners = corner_points(scene, CornersOf::transparent);
    if (corners.empty()) corners = corner_points(scene);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [least, most] =
            std::minmax_element(corners.begin(), corners.end(),
                                [i](const Vec3& a, const Vec3& b) { return a[i] < b[i]; });
        if (!corners.empty()) middle[i] = ((*least)[i] + (*most)[i]) / 2;
        axis[i] = -projection.world_to_view[4 * i + 2];
        distance += axis[i] * (middle[i] - projection.eye[i]);
    }
    // A camera that looks away from the scene turns about what is a metre before it.
    if (!(distance > 0)) distance = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        key.eye[i] = static_cast<float>(projection.eye[i]);
        key.target[i] = static_cast<float>(projection.eye[i] + distance * axis[i]);
    }
    key.fov = static_cast<float>(own_atan2(1, projection.scale_y) * (360 / kPi));
    return key;
}

View seen_by(const CameraKey& camera, View view)
{
    view.camera.clear();
    view.eye = camera.eye;
    view.target = camera.target;
    view.fov = camera.fov;
    return view;
}

double part_of(const CameraPath& path, int frame)
{
    if (path.last <= path.first) return 0;
    const double part = static_cast<double>(frame - path.first) / (path.last - path.first);
    return std::clamp(part, 0.0, 1.0);
}

}  // namespace

CameraKey between_keys(std::span<const CameraKey> keys, double frame)
{
    const auto after =
        std::upper_bound(keys.begin(), keys.end(), frame,
                         [](double f, const CameraKey& key) { return f < key.frame; });
    if (after == keys.begin()) return keys.front();
    const auto k = static_cast<std::size_t>(after - keys.begin()) - 1;
    if (after == keys.end() || frame == keys[k].frame) return keys[k];
    CameraKey result{frame, {}, {}, 0};
    for (std::size_t i = 0; i < kValues; ++i) {
        const Spline spline{keys, i};
        const double u = (frame - keys[k].frame) / spline.length(k);
        const Limit limit = i == 6 ? Limit::between_keys : Limit::none;
        const auto value = static_cast<float>(spline.between(k, u, limit));
        (i < 3 ? result.eye[i] : i < 6 ? result.target[i - 3] : result.fov) = value;
    }
    return result;
}

CameraKey along_path(const CameraPath& path, const CameraKey& start, double part)
{
    // Whole turns are none, to the last bit.
    const double degrees = std::fmod(double{path.orbit} * part, 360.0);
    const double factor = own_pow(path.dolly, part);
    if (degrees == 0 && factor == 1) return start;
    const double c = own_cos(degrees * (kPi / 180)), s = own_sin(degrees * (kPi / 180));
    double from[3];
    for (std::size_t i = 0; i < 3; ++i) from[i] = factor * (double{start.eye[i]} - start.target[i]);
    const double turned[3] = {c * from[0] + s * from[2], from[1], c * from[2] - s * from[0]};
    CameraKey result = start;
    for (std::size_t i = 0; i < 3; ++i) {
        result.eye[i] = static_cast<float>(start.target[i] + turned[i]);
    }
    return result;
}

bool moves(const CameraPath& path)
{
    return !path.keys.empty() || path.orbit != 0 || path.dolly != 1;
}

View view_of_frame(const Scene& scene, const View& view, const CameraPath& path, int frame)
{
    if (!moves(path)) return view;
    if (!std::isfinite(path.orbit)) throw Error(Fault::input, "orbit: not finite");
    if (!(path.dolly >= 1e-6f && path.dolly <= 1e6f)) {
        throw Error(Fault::input, "dolly: not between 0.000001 and 1000000");
    }
    const CameraKey start =
        path.keys.empty() ? camera_of(scene, view) : between_keys(path.keys, frame);
    const CameraKey camera = along_path(path, start, part_of(path, frame));
    if (camera.eye == camera.target) {
        throw Error(Fault::input, "camera path: in frame " + std::to_string(frame) +
                                      " the eye is the same point as the target");
    }
    return seen_by(camera, view);
}

View standing_view(const Scene& scene, const View& view)
{
    return seen_by(camera_of(scene, view), view);
}

}  // namespace sheer
