// Tilted glass that refracts, in whole pictures, against a ray for each pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <sheer/sheer.h>

#include "cpu/small_pictures.h"
#include "support/vec3.h"

namespace sheer {

namespace {

constexpr int kSide = 128;          // pixels
constexpr double kYfov = 0.9;       // radians
constexpr double kWall = 4;         // its distance, metres; it is parallel to the picture
constexpr double kWallHalf = 6;     // metres
constexpr double kPane = 2;         // the distance of its middle
constexpr double kPaneHalf = 0.55;  // metres
constexpr double kEta = 1.3;

// Axes of the pane: turned about the horizontal, then about the vertical, radians.
struct Tilt {
    double about_x, about_y;

    Vec3d along(double x, double y, double z) const
    {
        const double cx = std::cos(about_x), sx = std::sin(about_x);
        const double cy = std::cos(about_y), sy = std::sin(about_y);
        const Vec3d p{x, cx * y - sx * z, sx * y + cx * z};
        return {cy * p.x + sy * p.z, p.y, cy * p.z - sy * p.x};
    }
    Vec3d normal() const { return along(0, 0, 1); }
};

// Black glass before a wall that is redder to the right and greener to the top.
Scene pane_before_a_gradient(const Tilt& tilt, bool orthographic)
{
    Scene scene;
    Camera camera;
    camera.orthographic = orthographic;
    camera.yfov = static_cast<float>(kYfov);
    scene.cameras = {camera};
    const auto h = static_cast<float>(kWallHalf), wall = static_cast<float>(-kWall);
    add_rectangle(scene, flat_color({1, 1, 1}, 1),
                  {{-h, -h, wall}, {h, -h, wall}, {h, h, wall}, {-h, h, wall}})
        .colors = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}};
    const Vec3d middle{0, 0, -kPane};
    const auto corner = [&](double x, double y) {
        return to_float3(middle + tilt.along(x * kPaneHalf, y * kPaneHalf, 0));
    };
    add_rectangle(scene, flat_color({0, 0, 0}, 0.5f),
                  {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
    return scene;
}

struct Ray {
    Vec3d from, to;  // `to` is of length 1
};

// Through the middle of a pixel.
Ray ray_of(int x, int y, bool orthographic)
{
    const double right = (x + 0.5) / kSide * 2 - 1, up = 1 - (y + 0.5) / kSide * 2;
    if (orthographic) return {{right, up, 0}, {0, 0, -1}};
    const double slope = std::tan(kYfov / 2);
    return {{0, 0, 0}, normalized(Vec3d{slope * right, slope * up, -1})};
}

// Snell's law in Heckbert's form: Introduction to Ray Tracing, 1989, section 4.2.
Vec3d refracted(const Vec3d& ray, const Vec3d& normal, double eta)
{
    const double part = 1 / eta, c = -dot(ray, normal);
    const double root = std::sqrt(1 - part * part * (1 - c * c));
    return part * ray + (part * c - root) * normal;
}

// A place on the wall as the picture has it, which shows through the pane what is there in the
// picture without it.
Vec3d color_of_wall(const Vec3d& at)
{
    return {(at.x + kWallHalf) / (2 * kWallHalf), (at.y + kWallHalf) / (2 * kWallHalf), 0};
}

// Inside of the pane by more than a pixel's way.
bool meets(const Ray& ray, const Tilt& tilt, Vec3d& at)
{
    const Vec3d middle{0, 0, -kPane}, n = tilt.normal();
    at = ray.from + dot(middle - ray.from, n) / dot(ray.to, n) * ray.to;
    const Vec3d on_pane = at - middle;
    const double margin = kPaneHalf - 0.04;
    return std::abs(dot(on_pane, tilt.along(1, 0, 0))) < margin &&
           std::abs(dot(on_pane, tilt.along(0, 1, 0))) < margin;
}

}  // namespace

// A ray turns at the pane and goes on to the wall. Corners lie on a grid of 1/256 of a pixel, so
// that the slope of a pane of 60 pixels, at most 0.5, is off by 2 / 512 / 60 of it: 3.3e-5. What a
// ray turns by, as a slope, grows 0.6 times as fast at most, and is seen 2.2 metres farther on, of
// 64 pixels each (under perspective it is less): 0.0028 of a pixel. The wall's colour changes by 1
// / 12 for each metre, of which a pixel has at most 2 kWall tan(0.45) / 128, and half of that is
// seen: 0.00125 a pixel. Floats near 1/4, added a few times, are off by less than 1e-6. A sign that
// is wrong puts places off by pixels; the last line says that these are many bounds.
TEST(Refraction, TiltedPanesAgreeWithRays)
{
    constexpr double kBound = 0.0028 * 0.00125 + 1e-6;
    const Tilt tilts[] = {{0, 0.4}, {0, -0.4}, {0.4, 0}, {-0.4, 0}, {0.25, 0.3}, {-0.3, 0.25}};
    for (const bool orthographic : {false, true}) {
        for (const Tilt& tilt : tilts) {
            const Image image = draw(pane_before_a_gradient(tilt, orthographic), square(kSide, 1),
                                     "phenomenological:refraction=1.3");
            int pixels = 0;
            double farthest = 0;  // from what is straight behind, in colour
            for (int y = 0; y < kSide; ++y) {
                for (int x = 0; x < kSide; ++x) {
                    const Ray ray = ray_of(x, y, orthographic);
                    Vec3d at{};
                    if (!meets(ray, tilt, at)) continue;
                    const Vec3d turned = refracted(ray.to, tilt.normal(), kEta);
                    const auto on_wall = [&](const Vec3d& from, const Vec3d& to) {
                        return color_of_wall(from + (-kWall - from.z) / to.z * to);
                    };
                    const Vec3d wanted = 0.5 * on_wall(at, turned);
                    const Vec3d straight = 0.5 * on_wall(at, ray.to);
                    const auto& seen = image.at(x, y);
                    ASSERT_NEAR(static_cast<double>(seen[0]), wanted.x, kBound) << x << " " << y;
                    ASSERT_NEAR(static_cast<double>(seen[1]), wanted.y, kBound) << x << " " << y;
                    const Vec3d off = wanted - straight;
                    farthest = std::max({farthest, std::abs(off.x), std::abs(off.y)});
                    ++pixels;
                }
            }
            EXPECT_GT(pixels, 1000);
            EXPECT_GT(farthest, 100 * kBound);  // 0.36 of a pixel
        }
    }
}

}  // namespace sheer
