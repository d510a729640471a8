// Pictures of a few rectangles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <sheer/sheer.h>

namespace sheer {

// One object more, with a mesh and a material of its own; corners counter-clockwise from the front.
inline Mesh& add_rectangle(Scene& scene, const Material& material,
                           const std::vector<Float3>& corners)
{
    const auto number = static_cast<std::uint32_t>(scene.objects.size());
    Mesh mesh;
    mesh.positions = corners;
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = number;
    scene.materials.push_back(material);
    scene.meshes.push_back(mesh);
    Object object;
    object.mesh = object.id = number;
    scene.objects.push_back(object);
    return scene.meshes.back();
}

// Unlit, and transparent where the opacity is below 1.
inline Material flat_color(const Float3& color, float opacity)
{
    Material material;
    material.shading = Shading::unlit;
    material.base_color = color;
    material.opacity = opacity;
    if (opacity < 1) material.alpha_mode = AlphaMode::blend;
    return material;
}

// Parallel to a camera without perspective, whose picture is 2 wide and 2 high; as high as that.
inline void add_upright(Scene& scene, float left, float right, float distance, const Float3& color,
                        float opacity)
{
    const float z = -distance;
    add_rectangle(scene, flat_color(color, opacity),
                  {{left, -1, z}, {right, -1, z}, {right, 1, z}, {left, 1, z}});
}

inline View square(int side, int samples)
{
    View view;
    view.width = view.height = side;
    view.samples = samples;
    return view;
}

inline Image draw(const Scene& scene, const View& view, const std::string& method)
{
    Options options;
    options.threads = 2;
    options.method = method;
    return render(scene, view, options).image;
}

}  // namespace sheer
