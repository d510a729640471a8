// Each triangle gives its vertices dP/du and dP/dv, the directions in which u and v grow.
#include "geometry/tangents.h"

#include "support/vec3.h"

namespace sheer {

namespace {

struct Frame {
    Vec3d along_u, along_v, normal;
};

// Of unit length each, so that large triangles do not outweigh small ones.
Frame frame_of(const Mesh& mesh, const std::uint32_t* corner, const std::vector<Float2>& uv)
{
    const Vec3d p0 = to_vec3d(mesh.positions[corner[0]]);
    const Vec3d e1 = to_vec3d(mesh.positions[corner[1]]) - p0;
    const Vec3d e2 = to_vec3d(mesh.positions[corner[2]]) - p0;
    const auto step = [&](std::size_t k, std::size_t c) {
        return static_cast<double>(uv[corner[k]][c]) - static_cast<double>(uv[corner[0]][c]);
    };
    const double u1 = step(1, 0), v1 = step(1, 1), u2 = step(2, 0), v2 = step(2, 1);
    const double side = u1 * v2 - u2 * v1 < 0 ? -1 : 1;
    return {normalized(side * (v2 * e1 - v1 * e2)), normalized(side * (u1 * e2 - u2 * e1)),
            normalized(cross(e1, e2))};
}

}  // namespace

std::vector<Float4> make_tangents(const Mesh& mesh, std::size_t set)
{
    std::vector<Frame> frames(mesh.positions.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Frame frame = frame_of(mesh, &mesh.indices[i], mesh.texcoords[set]);
        for (std::size_t k = 0; k < 3; ++k) {
            Frame& at = frames[mesh.indices[i + k]];
            at.along_u = at.along_u + frame.along_u;
            at.along_v = at.along_v + frame.along_v;
            at.normal = at.normal + frame.normal;
        }
    }
    std::vector<Float4> tangents(mesh.positions.size());
    for (std::size_t i = 0; i < tangents.size(); ++i) {
        const Vec3d t = normalized(frames[i].along_u);
        Vec3d n = frames[i].normal;
        if (!mesh.normals.empty()) n = to_vec3d(mesh.normals[i]);
        const bool turned = dot(cross(n, t), frames[i].along_v) > 0;
        const Float3 f = to_float3(t);
        tangents[i] = {f[0], f[1], f[2], turned ? -1.0f : 1.0f};
    }
    return tangents;
}

}  // namespace sheer
