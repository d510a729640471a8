#include "scene/builtin/stage.h"

#include <algorithm>
#include <utility>

#include "support/math.h"

namespace sheer {

using shapes::Vec;

Float3 to_float(Vec v)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

Float4 to_float(Vec color, double alpha)
{
    return {static_cast<float>(color.x), static_cast<float>(color.y), static_cast<float>(color.z),
            static_cast<float>(alpha)};
}

std::uint32_t add_material(Scene& scene, const std::string& name, Vec color)
{
    Material material;
    material.name = name;
    material.base_color = to_float(color);
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

std::uint32_t add_image(Scene& scene, TextureImage image)
{
    scene.images.push_back(std::move(image));
    return static_cast<std::uint32_t>(scene.images.size() - 1);
}

std::uint32_t add_mesh(Scene& scene, Mesh mesh, std::uint32_t material)
{
    mesh.material = material;
    scene.meshes.push_back(std::move(mesh));
    const auto index = static_cast<std::uint32_t>(scene.meshes.size() - 1);
    add_object(scene, index, {});
    return index;
}

void add_object(Scene& scene, std::uint32_t mesh, const shapes::Placement& placement)
{
    scene.objects.push_back({scene.meshes[mesh].name, mesh, shapes::to_matrix(placement),
                             static_cast<std::uint32_t>(scene.objects.size())});
}

std::uint32_t add_card_material(Scene& scene, const std::string& name, TextureImage image,
                                AlphaMode mode, Wrap wrap)
{
    const std::uint32_t index = add_material(scene, name, {1, 1, 1});
    Material& material = scene.materials[index];
    material.alpha_mode = mode;
    material.double_sided = true;
    Texture texture;
    texture.image = add_image(scene, std::move(image));
    texture.sampler.wrap_u = texture.sampler.wrap_v = wrap;
    material.base_color_texture = texture;
    return index;
}

void add_card(Mesh& mesh, const Card& card)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const bool flat = dot(card.normal, card.normal) == 0;
    const Float3 normal =
        to_float(shapes::normalize(flat ? cross(card.down, card.right) : card.normal));
    for (std::uint32_t i = 0; i < 4; ++i) {
        const double u = i == 1 || i == 2 ? 1 : 0, v = i >= 2 ? 1 : 0;
        mesh.positions.push_back(to_float(card.corner + u * card.right + v * card.down));
        mesh.normals.push_back(normal);
        mesh.colors.push_back(to_float(card.color, card.alpha));
        mesh.texcoords[0].push_back(
            {u > 0 ? card.to[0] : card.from[0], v > 0 ? card.to[1] : card.from[1]});
    }
    for (const std::uint32_t i : {0u, 3u, 2u, 0u, 2u, 1u}) mesh.indices.push_back(first + i);
}

void add_sheet(Mesh& mesh, const Sheet& sheet)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const int wide = sheet.columns + 1, high = sheet.rows + 1;
    std::vector<Vec> points;
    for (int j = 0; j < high; ++j)
        for (int i = 0; i < wide; ++i)
            points.push_back(sheet.point(static_cast<double>(i) / sheet.columns,
                                         static_cast<double>(j) / sheet.rows));
    const auto at = [&](int i, int j) {
        if (sheet.closed) i = (i + sheet.columns) % sheet.columns;
        i = std::min(std::max(i, 0), sheet.columns);
        j = std::min(std::max(j, 0), sheet.rows);
        return points[static_cast<std::size_t>(j * wide + i)];
    };
    for (int j = 0; j < high; ++j) {
        for (int i = 0; i < wide; ++i) {
            const double u = static_cast<double>(i) / sheet.columns;
            const double v = static_cast<double>(j) / sheet.rows;
            const Paint paint = sheet.color ? sheet.color(u, v) : Paint{{1, 1, 1}, 1};
            mesh.positions.push_back(to_float(at(i, j)));
            mesh.normals.push_back(to_float(shapes::normalize(
                cross(at(i, j + 1) - at(i, j - 1), at(i + 1, j) - at(i - 1, j)))));
            mesh.colors.push_back(to_float(paint.color, paint.alpha));
            mesh.texcoords[0].push_back(
                {static_cast<float>(u) * sheet.repeat[0], static_cast<float>(v) * sheet.repeat[1]});
        }
    }
    for (int j = 0; j < sheet.rows; ++j) {
        for (int i = 0; i < sheet.columns; ++i) {
            const auto a = first + static_cast<std::uint32_t>(j * wide + i);
            const std::uint32_t b = a + 1, c = a + static_cast<std::uint32_t>(wide), d = c + 1;
            mesh.indices.insert(mesh.indices.end(), {a, c, d, a, d, b});
        }
    }
}

Camera make_camera(const std::string& name, Vec eye, Vec target, double yfov, double znear)
{
    Camera camera;
    camera.name = name;
    camera.yfov = static_cast<float>(yfov);
    camera.znear = static_cast<float>(znear);
    const Vec back = shapes::normalize(eye - target);
    const Vec right = shapes::normalize(cross({0, 1, 0}, back));
    camera.transform = shapes::to_matrix({right, cross(back, right), back, eye});
    return camera;
}

void add_backdrop(Scene& scene, const Camera& camera, const Backdrop& backdrop)
{
    const Mat4& m = camera.transform;
    const Vec eye = {m[12], m[13], m[14]};
    const Vec away = shapes::normalize({-m[8], 0, -m[10]});
    const Vec right = cross(away, {0, 1, 0});
    const double d = backdrop.distance;
    const double heights[] = {-2 * d, 0, own_tan(backdrop.reach) * d, 3 * d};
    Mesh mesh;
    mesh.name = "sky";
    Sheet sheet;
    sheet.rows = 3;
    const auto row = [](double v) { return static_cast<std::size_t>(3 * v + 0.5); };
    sheet.point = [&](double u, double v) {
        return eye + d * away + (6 * d * (u - 0.5)) * right + Vec{0, heights[3 - row(v)], 0};
    };
    sheet.color = [&](double, double v) {
        return Paint{row(v) < 2 ? backdrop.high : backdrop.low, 1};
    };
    add_sheet(mesh, sheet);
    const std::uint32_t material = add_material(scene, "sky", {1, 1, 1});
    scene.materials[material].shading = Shading::unlit;
    scene.materials[material].double_sided = true;
    add_mesh(scene, std::move(mesh), material);
}

}  // namespace sheer
