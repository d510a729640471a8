// Names, colours and materials of bare meshes.
#include "scene/mesh_files.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <sheer/error.h>

#include "image/color.h"

namespace sheer {

void fail_in_file(const std::string& path, const std::string& what)
{
    throw Error(Fault::input, path + ": " + what);
}

std::string name_of_file(const std::string& path)
{
    return std::filesystem::path(path).stem().string();
}

Material plain_material(const std::string& name, bool colored_vertices, Topology topology)
{
    constexpr float kLightGrey = 0.7f;  // bright enough for shape to show, and no highlight clips
    constexpr float kDarkGrey = 0.1f;   // in full light a sixth of the default background's light
    const float grey = topology == Topology::triangles ? kLightGrey : kDarkGrey;
    Material material;
    material.name = name;
    if (!colored_vertices) material.base_color = {grey, grey, grey};
    material.double_sided = true;
    return material;
}

float linear_color(double encoded)
{
    return static_cast<float>(linear_from_srgb(encoded > 0 ? std::min(encoded, 1.0) : 0));
}

void place_mesh(Scene& scene, Mesh mesh)
{
    Object object;
    object.name = mesh.name;
    object.mesh = static_cast<std::uint32_t>(scene.meshes.size());
    object.id = static_cast<std::uint32_t>(scene.objects.size());
    scene.meshes.push_back(std::move(mesh));
    scene.objects.push_back(std::move(object));
}

}  // namespace sheer
