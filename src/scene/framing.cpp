// Framing in closed form. With a point's view-aligned coordinates (a, b, c), c along the view, and
// the eye at (x, y, z), the point is inside the view's sides of slope k where |a - x| <= k (c - z).
// Over all points that is  max(a - k c) <= x - k z  and  x + k z <= min(a + k c), which bounds z
// from above and gives x; b and y alike. The smaller of the two z is the nearest eye.
#include "scene/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/transparency.h"

namespace sheer {
namespace {

constexpr Vec3 kDefaultBack = {0.55, 0.42, 0.85};  // from the front right, a little above
constexpr double kInside = 0.9;  // of the view's width and height: 5 % margin on each side
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double dot(const Vec3& a, const Vec3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec3 normalized(const Vec3& v)
{
    // Scaling first keeps the squares of tiny and huge vectors in range.
    const double most = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if (most == 0) return v;
    const Vec3 s = {v[0] / most, v[1] / most, v[2] / most};
    const double length = std::sqrt(dot(s, s));
    return {s[0] / length, s[1] / length, s[2] / length};
}

struct Box {
    Vec3 low = {kInfinity, kInfinity, kInfinity};
    Vec3 high = {-kInfinity, -kInfinity, -kInfinity};

    void add(const Vec3& p)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
    bool empty() const { return !(low[0] <= high[0]); }
    Vec3 corner(unsigned i) const
    {
        return {(i & 1) ? high[0] : low[0], (i & 2) ? high[1] : low[1], (i & 4) ? high[2] : low[2]};
    }
    double half_diagonal() const
    {
        const Vec3 d = {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
        return 0.5 * std::sqrt(dot(d, d));
    }
};

bool finite(const Vec3& v)
{
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

Box bounds_of(const Mesh& mesh)
{
    Box box;
    for (const Float3& p : mesh.positions) {
        const Vec3 point = {p[0], p[1], p[2]};
        if (finite(point)) box.add(point);
    }
    return box;
}

Vec3 transform(const Mat4& m, const Vec3& p)
{
    Vec3 q;
    for (std::size_t i = 0; i < 3; ++i)
        q[i] = static_cast<double>(m[i]) * p[0] + static_cast<double>(m[4 + i]) * p[1] +
               static_cast<double>(m[8 + i]) * p[2] + static_cast<double>(m[12 + i]);
    return q;
}

// Along one axis of the picture: the greatest z that the points allow, and the eye's place there.
struct Fit {
    double steepest_low = -kInfinity;  // max(a - k c)
    double steepest_high = kInfinity;  // min(a + k c)

    void add(double a, double kc)
    {
        steepest_low = std::max(steepest_low, a - kc);
        steepest_high = std::min(steepest_high, a + kc);
    }
    double greatest_z(double k) const { return (steepest_high - steepest_low) / (2 * k); }
    double middle() const { return 0.5 * (steepest_low + steepest_high); }
};

// A box that has a size: one of no extent, or of none beyond rounding, gets one.
std::vector<Vec3> with_extent(const std::vector<Vec3>& points, Vec3& center, double& radius)
{
    Box box;
    for (const Vec3& point : points) box.add(point);
    if (box.empty()) box.add({0, 0, 0});
    for (std::size_t i = 0; i < 3; ++i) center[i] = 0.5 * (box.low[i] + box.high[i]);
    const double place = std::sqrt(dot(center, center));
    radius = box.half_diagonal();
    if (radius > 1e-12 * place && !points.empty()) return points;
    radius = std::max(1.0, 1e-6 * place);
    std::vector<Vec3> corners;
    for (unsigned i = 0; i < 8; ++i)
        corners.push_back({center[0] + ((i & 1) ? 0.5 : -0.5) * radius,
                           center[1] + ((i & 2) ? 0.5 : -0.5) * radius,
                           center[2] + ((i & 4) ? 0.5 : -0.5) * radius});
    return corners;
}

}  // namespace

Pose look_along(const Vec3& eye, const Vec3& back)
{
    Pose pose;
    pose.eye = eye;
    pose.back = normalized(back);
    Vec3 right = cross({0, 1, 0}, pose.back);
    if (dot(right, right) < 1e-20) right = {1, 0, 0};
    pose.right = normalized(right);
    pose.up = normalized(cross(pose.back, pose.right));
    return pose;
}

bool orthonormalize(const std::array<Vec3, 3>& right_up_back, Pose& pose)
{
    Vec3 axis[3];
    for (std::size_t i = 3; i-- > 0;) {
        axis[i] = normalized(right_up_back[i]);
        for (std::size_t j = 2; j > i; --j) {
            const double along = dot(axis[i], axis[j]);
            for (std::size_t k = 0; k < 3; ++k) axis[i][k] -= along * axis[j][k];
        }
        if (dot(axis[i], axis[i]) < 1e-12) return false;
        axis[i] = normalized(axis[i]);
    }
    pose.right = axis[0];
    pose.up = axis[1];
    pose.back = axis[2];
    return true;
}

std::vector<Vec3> corner_points(const Scene& scene, CornersOf which)
{
    const auto is_wanted = [&](const Object& object) {
        if (which == CornersOf::all) return true;
        const std::size_t number = material_number(scene, object);
        if (number >= scene.materials.size()) return false;  // of a scene that nobody checked
        const Material& material = scene.materials[number];
        return which == CornersOf::lit ? material.shading != Shading::unlit
                                       : makes_fragments(material, object, true);
    };
    std::vector<Box> boxes;
    for (const Mesh& mesh : scene.meshes) boxes.push_back(bounds_of(mesh));
    std::vector<Vec3> points;
    for (const Object& object : scene.objects) {
        if (object.mesh >= boxes.size() || boxes[object.mesh].empty()) continue;
        if (!is_wanted(object)) continue;
        for (unsigned i = 0; i < 8; ++i) {
            const Vec3 p = transform(object.transform, boxes[object.mesh].corner(i));
            if (finite(p)) points.push_back(p);
        }
    }
    return points;
}

Pose frame_points(const std::vector<Vec3>& points, HalfTangents view)
{
    Vec3 center;
    double radius = 0;
    const std::vector<Vec3> seen = with_extent(points, center, radius);
    Pose pose = look_along(center, kDefaultBack);
    const double kx = kInside * view.x, ky = kInside * view.y;
    Fit fit_x, fit_y;
    double nearest = kInfinity;
    // Relative to the centre: a small scene far from the origin keeps its digits.
    for (const Vec3& p : seen) {
        const Vec3 d = {p[0] - center[0], p[1] - center[1], p[2] - center[2]};
        const double c = -dot(d, pose.back);
        fit_x.add(dot(d, pose.right), kx * c);
        fit_y.add(dot(d, pose.up), ky * c);
        nearest = std::min(nearest, c);
    }
    // A line seen end on could be approached without end.
    const double z = std::min({fit_x.greatest_z(kx), fit_y.greatest_z(ky), nearest - 0.1 * radius});
    for (std::size_t i = 0; i < 3; ++i)
        pose.eye[i] = center[i] + fit_x.middle() * pose.right[i] + fit_y.middle() * pose.up[i] -
                      z * pose.back[i];
    return pose;
}

double safe_near(const Pose& pose, const std::vector<Vec3>& points)
{
    double nearest = kInfinity, farthest = 0;
    for (const Vec3& p : points) {
        const double depth =
            -dot({p[0] - pose.eye[0], p[1] - pose.eye[1], p[2] - pose.eye[2]}, pose.back);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    if (farthest <= 0) return 1e-3;
    return std::max(0.5 * nearest, 1e-5 * farthest);
}

}  // namespace sheer
