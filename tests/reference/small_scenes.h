// Scenes of a few triangles given directly on the screen, as the geometry stage would hand them on.
#pragma once

#include <array>
#include <cstdint>

#include <sheer/render.h>
#include <sheer/scene.h>

#include "geometry/triangles.h"
#include "reference/reference.h"

namespace sheer::reference {

struct Corner {
    double x = 0, y = 0;  // pixels from the top left
    float depth = 1;
    Float4 color = {1, 1, 1, 1};
    Float3 normal = {0, 1, 0};
};

inline Material unlit(AlphaMode mode, Float3 color, float opacity)
{
    Material material;
    material.base_color = color;
    material.opacity = opacity;
    material.alpha_mode = mode;
    material.shading = Shading::unlit;
    return material;
}

struct SmallScene {
    Scene scene;
    Geometry geometry;

    SmallScene()
    {
        geometry.orthographic = true;
        geometry.chunks.emplace_back();
    }

    std::uint32_t add_object(const Material& material)
    {
        const auto index = static_cast<std::uint32_t>(scene.objects.size());
        Mesh mesh;
        mesh.material = index;
        Object object;
        object.mesh = index;
        object.id = index;
        scene.materials.push_back(material);
        scene.meshes.push_back(mesh);
        scene.objects.push_back(object);
        return index;
    }

    Triangle& add_triangle(std::uint32_t object, std::uint32_t primitive,
                           const std::array<Corner, 3>& corners)
    {
        Triangle triangle{};
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.x[i] = static_cast<std::int32_t>(corners[i].x * kSubpixels);
            triangle.y[i] = static_cast<std::int32_t>(corners[i].y * kSubpixels);
            triangle.depth[i] = corners[i].depth;
            triangle.vertex[i] = static_cast<std::uint32_t>(geometry.attributes.size());
            geometry.attributes.push_back({corners[i].normal, corners[i].color});
        }
        triangle.primitive = primitive;
        triangle.object = object & 0x7fffffffu;
        geometry.chunks.back().triangles.push_back(triangle);
        return geometry.chunks.back().triangles.back();
    }

    // Covers the picture and more; `tilt` is how much the depth grows per pixel to the right.
    void add_wall(const Material& material, std::uint32_t primitive, float depth, float tilt = 0)
    {
        const float right = depth + 1000 * tilt;
        add_triangle(add_object(material), primitive,
                     {{{0, -500, depth}, {1000, 500, right}, {0, 1500, depth}}});
    }

    Picture render(const View& view, Float4 background = {0, 0, 0, 0}) const
    {
        return reference::render(scene, geometry, view, background);
    }
};

inline View small_view(int width, int height, int samples)
{
    View view;
    view.width = width;
    view.height = height;
    view.samples = samples;
    return view;
}

}  // namespace sheer::reference
