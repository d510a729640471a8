// A wall that fills the picture and faces the camera, with a texture of one's own.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <sheer/sheer.h>

namespace sheer::test {

using Rgba8 = std::array<std::uint8_t, 4>;

inline TextureImage image_of(int width, int height, std::vector<Rgba8> texels)
{
    return {"image", width, height, std::move(texels)};
}

// Squares of one texel, black and white by turns.
inline TextureImage checkers(int size)
{
    std::vector<Rgba8> texels;
    for (int i = 0; i < size * size; ++i) {
        const std::uint8_t gray = (i % size + i / size) % 2 == 0 ? 0 : 255;
        texels.push_back({gray, gray, gray, 255});
    }
    return image_of(size, size, std::move(texels));
}

// Unlit, seen square on by an orthographic camera two metres wide and high; texture coordinates go
// from (u0, v0) at the picture's top left corner to (u1, v1) at its bottom right one.
struct Wall {
    Scene scene;
    View view;

    Wall(TextureImage image, float u0, float v0, float u1, float v1)
    {
        scene.images = {std::move(image)};
        Material material;
        material.shading = Shading::unlit;
        material.base_color_texture = Texture{};
        scene.materials = {material};
        Mesh mesh;
        mesh.positions = {{-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}};
        mesh.texcoords[0] = {{u0, v0}, {u0, v1}, {u1, v1}, {u1, v0}};
        mesh.indices = {0, 1, 2, 0, 2, 3};
        scene.meshes = {mesh};
        scene.objects = {Object{}};
        Camera camera;
        camera.orthographic = true;
        camera.transform[14] = 1;
        scene.cameras = {camera};
        view.width = view.height = 16;
        view.samples = 4;
        view.background = Float4{0, 0, 0, 0};
    }
    Material& material() { return scene.materials[0]; }
    Sampler& sampler() { return material().base_color_texture->sampler; }
    Image draw() const { return render(scene, view, {}).image; }
};

}  // namespace sheer::test
