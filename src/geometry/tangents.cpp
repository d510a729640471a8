// Each triangle gives its vertices dP/du and dP/dv, the directions in which u and v grow.
#include "geometry/tangents.h"

#include <cmath>

namespace sheer {

namespace {

struct Vec3d {
    double v[3] = {0, 0, 0};
};

Vec3d difference(const Float3& a, const Float3& b)
{
    Vec3d d;
    for (std::size_t i = 0; i < 3; ++i) {
        d.v[i] = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    }
    return d;
}

double dot(const Vec3d& a, const Vec3d& b)
{
    return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

Vec3d cross(const Vec3d& a, const Vec3d& b)
{
    return {{a.v[1] * b.v[2] - a.v[2] * b.v[1], a.v[2] * b.v[0] - a.v[0] * b.v[2],
             a.v[0] * b.v[1] - a.v[1] * b.v[0]}};
}

// Of length 1, or zero.
Vec3d normalized(const Vec3d& a)
{
    const double length = std::sqrt(dot(a, a));
    if (!(length > 0) || !std::isfinite(length)) return {};
    return {{a.v[0] / length, a.v[1] / length, a.v[2] / length}};
}

void add(Vec3d& sum, const Vec3d& a)
{
    for (std::size_t i = 0; i < 3; ++i) sum.v[i] += a.v[i];
}

struct Frame {
    Vec3d along_u, along_v, normal;
};

// Of unit length each, so that large triangles do not outweigh small ones.
Frame frame_of(const Mesh& mesh, const std::uint32_t* corner, const std::vector<Float2>& uv)
{
    const Vec3d e1 = difference(mesh.positions[corner[1]], mesh.positions[corner[0]]);
    const Vec3d e2 = difference(mesh.positions[corner[2]], mesh.positions[corner[0]]);
    const auto step = [&](std::size_t k, std::size_t c) {
        return static_cast<double>(uv[corner[k]][c]) - static_cast<double>(uv[corner[0]][c]);
    };
    const double u1 = step(1, 0), v1 = step(1, 1), u2 = step(2, 0), v2 = step(2, 1);
    const double side = u1 * v2 - u2 * v1 < 0 ? -1 : 1;
    Frame frame;
    for (std::size_t i = 0; i < 3; ++i) {
        frame.along_u.v[i] = side * (v2 * e1.v[i] - v1 * e2.v[i]);
        frame.along_v.v[i] = side * (u1 * e2.v[i] - u2 * e1.v[i]);
    }
    return {normalized(frame.along_u), normalized(frame.along_v), normalized(cross(e1, e2))};
}

}  // namespace

std::vector<Float4> make_tangents(const Mesh& mesh, std::size_t set)
{
    std::vector<Frame> frames(mesh.positions.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Frame frame = frame_of(mesh, &mesh.indices[i], mesh.texcoords[set]);
        for (std::size_t k = 0; k < 3; ++k) {
            Frame& at = frames[mesh.indices[i + k]];
            add(at.along_u, frame.along_u);
            add(at.along_v, frame.along_v);
            add(at.normal, frame.normal);
        }
    }
    std::vector<Float4> tangents(mesh.positions.size());
    for (std::size_t i = 0; i < tangents.size(); ++i) {
        const Vec3d t = normalized(frames[i].along_u);
        Vec3d n = frames[i].normal;
        if (!mesh.normals.empty()) n = difference(mesh.normals[i], {0, 0, 0});
        const bool turned = dot(cross(n, t), frames[i].along_v) > 0;
        tangents[i] = {static_cast<float>(t.v[0]), static_cast<float>(t.v[1]),
                       static_cast<float>(t.v[2]), turned ? -1.0f : 1.0f};
    }
    return tangents;
}

}  // namespace sheer
