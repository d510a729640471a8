// Where vertices are on their surfaces: what stays when the camera moves, or the object does.
#include <algorithm>

#include "geometry/pose.h"

namespace sheer {

namespace {

Float3 moved(const Mat4& m, const Float3& p)
{
    Float3 result;
    for (std::size_t row = 0; row < 3; ++row) {
        double sum = static_cast<double>(m[12 + row]);
        for (std::size_t k = 0; k < 3; ++k) {
            sum += static_cast<double>(m[4 * k + row]) * static_cast<double>(p[k]);
        }
        result[row] = static_cast<float>(sum);
    }
    return result;
}

Float3 place_of(const Mesh& mesh, std::size_t vertex, PlaceSpace space, const Mat4& transform)
{
    if (space != PlaceSpace::texture) return moved(transform, mesh.positions[vertex]);
    if (mesh.texcoords[0].empty()) return {0, 0, 0};
    const Float2& uv = mesh.texcoords[0][vertex];
    return {uv[0], uv[1], 0};
}

}  // namespace

void pose_places(const Scene& scene, const DrawnObjects& drawn, const PlaceSpaces& wanted,
                 PosedScene& posed)
{
    for (const PlaceSpace space : {PlaceSpace::object, PlaceSpace::world, PlaceSpace::texture}) {
        if (!wanted[static_cast<std::size_t>(space)]) continue;
        std::vector<Float3>& places = posed.places[static_cast<std::size_t>(space)];
        places.reserve(posed.vertices.size());
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const Mesh& mesh = *drawn[i].mesh;
            // Ribbons and squares are made in the world, where they face the camera.
            const bool own = &mesh == &scene.meshes[scene.objects[i].mesh];
            const auto& to_whole = scene.objects[i].to_whole;
            const Mat4& transform =
                own && space == PlaceSpace::object && to_whole ? *to_whole : drawn[i].transform;
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                places.push_back(place_of(mesh, v, space, transform));
            }
        }
    }
}

}  // namespace sheer
