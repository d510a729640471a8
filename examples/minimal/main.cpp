// A blue pane in front of a red one, from one's own arrays to the colour of a pixel.
#include <cstdint>
#include <cstdio>

#include <sheer/sheer.h>

// A square of 2 x 2 metres that faces +z, and lets half of what is behind it through.
static void add_pane(sheer::Scene& scene, const sheer::Float3& color, float z)
{
    const auto number = static_cast<std::uint32_t>(scene.objects.size());
    sheer::Material& material = scene.materials.emplace_back();
    material.base_color = color;
    material.opacity = 0.5f;
    material.alpha_mode = sheer::AlphaMode::blend;
    material.shading = sheer::Shading::unlit;
    sheer::Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = number;
    sheer::Object& object = scene.objects.emplace_back();
    object.mesh = number;
    object.id = number;
}

int main()
{
    sheer::Scene scene;
    add_pane(scene, {0, 0, 1}, 0);
    add_pane(scene, {1, 0, 0}, -1);

    sheer::View view;
    view.width = 64;
    view.height = 64;
    view.background = {0, 0, 0, 0};
    view.eye = {0, 0, 4};
    view.target = {0, 0, 0};
    sheer::Options options;
    options.method = "exact";
    const sheer::Frame frame = sheer::render(scene, view, options);

    const auto& [red, green, blue, alpha] = frame.image.at(32, 32);  // linear, premultiplied
    std::printf("%g %g %g %g\n", red, green, blue, alpha);           // 0.25 0 0.5 0.75
    return alpha > 0 ? 0 : 1;
}
