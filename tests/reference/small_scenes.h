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
    Float2 texcoord = {0, 0};  // of set 0; set 1 has v and u
    Float4 tangent = {0, 0, 0, 0};
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

    // Seen from the origin along -z.
    SmallScene()
    {
        geometry.orthographic = true;
        geometry.eye = {true, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 1, 1, 1};
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
            const Float2 uv = corners[i].texcoord;
            geometry.texture_attributes.push_back({{uv, {uv[1], uv[0]}}, corners[i].tangent});
        }
        triangle.primitive = primitive;
        triangle.object = object & 0x7fffffffu;
        geometry.chunks.back().triangles.push_back(triangle);
        return geometry.chunks.back().triangles.back();
    }

    // Covers the picture and more; `tilt` is how much the depth grows per pixel to the right.
    Triangle& add_wall(const Material& material, std::uint32_t primitive, float depth,
                       float tilt = 0)
    {
        const float right = depth + 1000 * tilt;
        return add_triangle(add_object(material), primitive,
                            {{{0, -500, depth}, {1000, 500, right}, {0, 1500, depth}}});
    }

    // A wall that faces the viewer, whose texture coordinates are pixels from the top left corner;
    // its tangent points to the right.
    Triangle& add_papered_wall(const Material& material, std::uint32_t primitive, float depth)
    {
        std::array<Corner, 3> corners = {{{0, -500, depth}, {1000, 500, depth}, {0, 1500, depth}}};
        for (Corner& corner : corners) {
            corner.normal = {0, 0, 1};
            corner.texcoord = {static_cast<float>(corner.x), static_cast<float>(corner.y)};
            corner.tangent = {1, 0, 0, 1};
        }
        return add_triangle(add_object(material), primitive, corners);
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

inline constexpr Sampler kNearest = {Wrap::repeat, Wrap::repeat, TexelFilter::nearest,
                                     TexelFilter::nearest, MipFilter::none};

// Texture coordinates of a papered wall are pixels: here `width` by `height` of them are the image.
inline Texture paper(std::uint32_t image, double width, double height)
{
    Texture texture;
    texture.image = image;
    texture.sampler = kNearest;
    texture.transform = {static_cast<float>(1 / width), 0, 0, 0, static_cast<float>(1 / height), 0};
    return texture;
}

inline Texture plain_paper(std::uint32_t image)
{
    return paper(image, 1, 1);
}

// Black but for what a test lights.
inline SmallScene dark_scene()
{
    SmallScene small;
    small.scene.sun.color = {0, 0, 0};
    small.scene.sky.up = small.scene.sky.down = {0, 0, 0};
    return small;
}

inline Material glossy(Float3 color, float metallic, float roughness)
{
    Material material;
    material.shading = Shading::metallic_roughness;
    material.base_color = color;
    material.metallic = metallic;
    material.roughness = roughness;
    return material;
}

// The only pixel of a picture with one sample.
inline Rgba pixel_of(const SmallScene& small, Float4 background = {0, 0, 0, 0})
{
    return small.render(small_view(1, 1, 1), background).pixels[0];
}

}  // namespace sheer::reference
