// Centres of bounding boxes, posed.
#include "geometry/object_distances.h"

#include <algorithm>

namespace sheer {

namespace {

Float3 center_of_bounds(const Mesh& mesh)
{
    if (mesh.positions.empty()) return {};
    Float3 least = mesh.positions.front(), most = least;
    for (const Float3& p : mesh.positions) {
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], p[k]);
            most[k] = std::max(most[k], p[k]);
        }
    }
    return {0.5f * (least[0] + most[0]), 0.5f * (least[1] + most[1]), 0.5f * (least[2] + most[2])};
}

}  // namespace

std::vector<float> object_distances(const Scene& scene, const Projection& projection)
{
    std::vector<Float3> centers;
    for (const Mesh& mesh : scene.meshes) centers.push_back(center_of_bounds(mesh));
    std::vector<float> distances;
    for (const Object& object : scene.objects) {
        const Float3& c = centers[object.mesh];
        const Mat4& m = object.transform;
        double distance = -projection.world_to_view[14];
        for (std::size_t row = 0; row < 3; ++row) {
            double world = static_cast<double>(m[12 + row]);
            for (std::size_t k = 0; k < 3; ++k) {
                world += static_cast<double>(m[4 * k + row]) * static_cast<double>(c[k]);
            }
            distance -= projection.world_to_view[4 * row + 2] * world;
        }
        distances.push_back(static_cast<float>(distance));
    }
    return distances;
}

}  // namespace sheer
