// A triangle of which is known where each point of the picture is on it.
#pragma once

#include <array>
#include <cmath>

#include <sheer/scene.h>

namespace sheer::test {

using Point = std::array<double, 3>;

inline constexpr int kWidth = 90, kHeight = 64;

// One triangle that a camera at the origin sees along -z.
struct Sheet {
    Point corner[3];
    bool orthographic = false;

    Scene scene() const
    {
        Scene scene;
        Material material;
        material.shading = Shading::unlit;
        material.alpha_mode = AlphaMode::blend;
        material.opacity = 0.5f;
        material.double_sided = true;
        scene.materials.push_back(material);
        Mesh mesh;
        for (const Point& p : corner) {
            mesh.positions.push_back(
                {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
            // Of the plane's x and y: known wherever the place is.
            mesh.texcoords[0].push_back(
                {static_cast<float>(0.5 * p[0] + 1), static_cast<float>(2 * p[1] - p[0])});
        }
        mesh.indices = {0, 1, 2};
        scene.meshes.push_back(mesh);
        Object object;
        // A whole that is a quarter turn about z from the world, twice as large and 3 m along x.
        object.to_whole = Mat4{0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 3, 0, 0, 1};
        scene.objects.push_back(object);
        Camera camera;
        camera.orthographic = orthographic;
        camera.yfov = 0.9f;
        camera.xmag = 3.0f * kWidth / kHeight;
        camera.ymag = 3;
        camera.znear = 0.1f;
        camera.zfar = 500;
        scene.cameras.push_back(camera);
        return scene;
    }

    // Of the picture's (x, y) in pixels.
    Point at(double x, double y) const
    {
        const double scale = 2.0 / kHeight * (orthographic ? 3 : std::tan(0.5 * double{0.9f}));
        const double sx = (x - 0.5 * kWidth) * scale, sy = (0.5 * kHeight - y) * scale;
        Point a, b, n;
        for (std::size_t i = 0; i < 3; ++i) {
            a[i] = corner[1][i] - corner[0][i];
            b[i] = corner[2][i] - corner[0][i];
        }
        for (std::size_t i = 0; i < 3; ++i) {
            n[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
        }
        const double d = n[0] * corner[0][0] + n[1] * corner[0][1] + n[2] * corner[0][2];
        if (orthographic) return {sx, sy, (d - n[0] * sx - n[1] * sy) / n[2]};
        const double t = d / (n[0] * sx + n[1] * sy - n[2]);
        return {t * sx, t * sy, -t};
    }
};

}  // namespace sheer::test
