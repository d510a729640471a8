// Horizontal transparent sheets over an opaque floor, under a sun that stands above them: what
// reaches the floor is known.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <sheer/sheer.h>

namespace sheer::test {

// Its normal up, with an object and a material of its own.
inline void add_mesh(Scene& scene, Mesh mesh, const Material& material)
{
    const auto number = static_cast<std::uint32_t>(scene.meshes.size());
    mesh.material = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(material);
    scene.meshes.push_back(std::move(mesh));
    Object object;
    object.mesh = object.id = number;
    scene.objects.push_back(object);
}

inline void add_square(Scene& scene, float half, float height, const Material& material)
{
    Mesh mesh;
    mesh.positions = {
        {-half, height, -half}, {-half, height, half}, {half, height, half}, {half, height, -half}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    add_mesh(scene, mesh, material);
}

// Over a square and more: an edge inside would divide texels between the masks of two triangles.
inline void add_triangle_over(Scene& scene, float half, float height, const Material& material)
{
    Mesh mesh;
    mesh.positions = {{-half, height, -half}, {-half, height, 3 * half}, {3 * half, height, -half}};
    mesh.indices = {0, 1, 2};
    add_mesh(scene, mesh, material);
}

inline Material sheet_of(float opacity)
{
    Material material;
    material.opacity = opacity;
    material.alpha_mode = AlphaMode::blend;
    material.double_sided = true;
    return material;
}

inline constexpr float kSheetHeight = 1;  // of the lowest, and from each to the next

// The first opacity is the highest sheet's. The light of the sun alone: a white floor's radiance is
// the part of it that arrives.
inline Scene sheets_over_floor(const std::vector<float>& opacities)
{
    Scene scene;
    add_square(scene, 4, 0, Material{});
    for (std::size_t i = 0; i < opacities.size(); ++i) {
        add_triangle_over(scene, 4, kSheetHeight * static_cast<float>(opacities.size() - i),
                          sheet_of(opacities[i]));
    }
    scene.sun.to_light = {0, 1, 0};
    scene.sun.color = {1, 1, 1};
    scene.sky.up = scene.sky.down = {0, 0, 0};
    return scene;
}

// Of the floor's middle, from below the sheets.
inline View floor_view(const Shadows& shadows)
{
    View view;
    view.width = view.height = 32;
    view.samples = 1;
    view.eye = Float3{0, 0.5f, 0};
    view.target = Float3{0, 0, 0};
    view.fov = 120.0f;
    view.shadows = shadows;
    return view;
}

inline Shadows stochastic_shadows(int samples, int filter)
{
    Shadows shadows;
    shadows.kind = ShadowKind::stochastic;
    shadows.size = 64;
    shadows.samples = samples;
    shadows.filter = filter;
    return shadows;
}

inline Shadows exact_shadows()
{
    Shadows shadows;
    shadows.kind = ShadowKind::exact;
    return shadows;
}

}  // namespace sheer::test
