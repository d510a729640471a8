// Object space to view space to the subpixel grid, vertex by vertex.
#include "geometry/pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <sheer/error.h>

#include "support/parallel.h"
#include "support/vec3.h"

namespace sheer {

namespace {

constexpr std::size_t kVerticesAtOnce = 16384;

// std::floor is a function call on the oldest x86.
int floor_to_int(float x)
{
    const int whole = static_cast<int>(x);
    return whole - (static_cast<float>(whole) > x ? 1 : 0);
}

float screen_x(float x, float w, const ScreenMap& map)
{
    return x * map.half_width / w + map.half_width;
}

float screen_y(float y, float w, const ScreenMap& map)
{
    return map.half_height - y * map.half_height / w;
}

// Vertices on their way to the screen, an array for each part of PosedVertex.
struct VertexBlock {
    static constexpr std::size_t kMost = 64;

    float x[kMost], y[kMost], distance[kMost], depth[kMost];
    std::int32_t screen_x[kMost], screen_y[kMost];
    std::uint32_t outside[kMost];
};

// Without branches and always of a whole block, so that compilers make vectors of it; where a
// vertex is outside it computes something else, that is a number.
template <bool Orthographic>
void place_on_screen(VertexBlock& b, const ScreenMap& map)
{
    constexpr float kFurthest = 1e18f;  // products with what scales to the screen stay finite
    const ScreenMap m = map;
    const float guard_x = m.guard_x(), guard_y = m.guard_y();
    const auto flag = [](bool beyond, Outside plane) { return beyond ? std::uint32_t{plane} : 0u; };
    for (std::size_t i = 0; i < VertexBlock::kMost; ++i) {
        const float x = b.x[i], y = b.y[i], distance = b.distance[i];
        const float w = Orthographic ? 1.0f : distance;
        // Multiplied out, so that vertices behind the eye are sorted rightly too.
        const float off_x = x * m.half_width, off_y = y * m.half_height;
        std::uint32_t outside = 0;
        outside |= flag(!(std::abs(x) < kFurthest), kNowhere);
        outside |= flag(!(std::abs(y) < kFurthest), kNowhere);
        outside |= flag(!(std::abs(distance) < kFurthest), kNowhere);
        outside |= flag(distance < m.near_depth, kNear);
        outside |= flag(distance > m.far_depth, kFar);
        outside |= flag(off_x < -guard_x * w, kLeft);
        outside |= flag(off_x > guard_x * w, kRight);
        outside |= flag(off_y > guard_y * w, kTop);
        outside |= flag(off_y < -guard_y * w, kBottom);
        b.outside[i] = outside;
    }
    float inside_x[VertexBlock::kMost], inside_y[VertexBlock::kMost], inside_w[VertexBlock::kMost];
    for (std::size_t i = 0; i < VertexBlock::kMost; ++i) {
        inside_x[i] = b.outside[i] == 0 ? b.x[i] : 0.0f;
        inside_y[i] = b.outside[i] == 0 ? b.y[i] : 0.0f;
        inside_w[i] = b.outside[i] == 0 && !Orthographic ? b.distance[i] : 1.0f;
    }
    for (std::size_t i = 0; i < VertexBlock::kMost; ++i) {
        b.screen_x[i] = floor_to_int(screen_x(inside_x[i], inside_w[i], m) + 0.5f);
        b.screen_y[i] = floor_to_int(screen_y(inside_y[i], inside_w[i], m) + 0.5f);
        b.depth[i] = Orthographic ? b.distance[i] : -1.0f / inside_w[i];
    }
}

struct Matrix {
    double m[3][4];

    // The 3x3 part's cofactors times the sign of its determinant: turns normals, up to length.
    void cofactors(double (&c)[3][3]) const
    {
        for (int i = 0; i < 3; ++i) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            for (int j = 0; j < 3; ++j) {
                const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
                c[i][j] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
            }
        }
    }
};

Matrix to_matrix(const Mat4& a)
{
    Matrix r;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            r.m[row][column] = static_cast<double>(a[4 * column + row]);
        }
    }
    return r;
}

// world_to_view * object_to_world, rows x, y, z.
Matrix to_view(const Projection& projection, const Matrix& object)
{
    Matrix r;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            double sum = column == 3 ? projection.world_to_view[12 + row] : 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                sum += projection.world_to_view[4 * k + row] * object.m[k][column];
            }
            r.m[row][column] = sum;
        }
    }
    return r;
}

struct ObjectPose {
    float position[3][4];  // to view space, x and y scaled to the screen
    NormalMatrix normal;
    bool mirrored;
};

ObjectPose pose_object(const Mat4& transform, const Projection& projection, const ScreenMap& map)
{
    const Matrix world = to_matrix(transform), view = to_view(projection, world);
    ObjectPose pose;
    const double scale[3] = {static_cast<double>(map.scale_x), static_cast<double>(map.scale_y),
                             1.0};
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 4; ++c) {
            pose.position[r][c] = static_cast<float>(view.m[r][c] * scale[r]);
        }
    }
    double cofactor[3][3];
    world.cofactors(cofactor);
    const double determinant = world.m[0][0] * cofactor[0][0] + world.m[0][1] * cofactor[0][1] +
                               world.m[0][2] * cofactor[0][2];
    pose.mirrored = determinant < 0;
    // Tiny and huge objects keep their normals' length near 1.
    double largest = 0;
    for (const auto& row : cofactor) {
        for (const double c : row) largest = std::max(largest, c < 0 ? -c : c);
    }
    const double to_unit = largest > 0 ? (pose.mirrored ? -1.0 : 1.0) / largest : 0.0;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
            pose.normal.m[r][c] = static_cast<float>(cofactor[r][c] * to_unit);
        }
    }
    return pose;
}

// From object space.
void move_to_view(VertexBlock& b, const ObjectPose& pose)
{
    float m[3][4];
    std::copy_n(&pose.position[0][0], 12, &m[0][0]);
    for (std::size_t i = 0; i < VertexBlock::kMost; ++i) {
        const float x = b.x[i], y = b.y[i], z = b.distance[i];
        b.x[i] = m[0][0] * x + m[0][1] * y + m[0][2] * z + m[0][3];
        b.y[i] = m[1][0] * x + m[1][1] * y + m[1][2] * z + m[1][3];
        b.distance[i] = -(m[2][0] * x + m[2][1] * y + m[2][2] * z + m[2][3]);
    }
}

void pose_range(const Mesh& mesh, const ObjectPose& pose, const ScreenMap& map, std::size_t begin,
                std::size_t end, PosedVertex* vertices, Attributes* attributes)
{
    VertexBlock block{};
    for (std::size_t first = begin; first < end; first += VertexBlock::kMost) {
        const std::size_t count = std::min(end - first, VertexBlock::kMost);
        for (std::size_t i = 0; i < count; ++i) {
            const Float3& p = mesh.positions[first + i];
            block.x[i] = p[0];
            block.y[i] = p[1];
            block.distance[i] = p[2];
        }
        move_to_view(block, pose);
        map.orthographic ? place_on_screen<true>(block, map) : place_on_screen<false>(block, map);
        for (std::size_t i = 0; i < count; ++i) {
            PosedVertex& v = vertices[first + i];
            v.x = block.x[i];
            v.y = block.y[i];
            v.w = map.orthographic ? 1.0f : block.distance[i];
            v.distance = block.distance[i];
            v.depth = block.depth[i];
            v.screen_x = block.screen_x[i];
            v.screen_y = block.screen_y[i];
            v.outside = block.outside[i];
        }
    }
    const NormalMatrix to_world = pose.normal;  // that no attribute's writing can change
    const bool has_normals = !mesh.normals.empty(), has_colors = !mesh.colors.empty();
    for (std::size_t i = begin; i < end; ++i) {
        Attributes& a = attributes[i];
        a.normal = has_normals ? to_world(mesh.normals[i]) : Float3{0, 0, 0};
        a.color = has_colors ? mesh.colors[i] : Float4{1, 1, 1, 1};
    }
}

Float4 pose_tangent(const Float4& tangent, const Mat4& world, bool mirrored)
{
    const Float3 t =
        to_float3(normalized(turned(world, to_vec3d({tangent[0], tangent[1], tangent[2]}))));
    return {t[0], t[1], t[2], mirrored ? -tangent[3] : tangent[3]};
}

void pose_texture_range(const DrawnObject& object, bool mirrored, std::size_t begin,
                        std::size_t end, TextureAttributes* attributes)
{
    const Mesh& mesh = *object.mesh;
    for (std::size_t i = begin; i < end; ++i) {
        TextureAttributes& a = attributes[i];
        for (std::size_t set = 0; set < 2; ++set) {
            if (!mesh.texcoords[set].empty()) a.texcoords[set] = mesh.texcoords[set][i];
        }
        if (object.tangents != nullptr) {
            a.tangent = pose_tangent((*object.tangents)[i], object.transform, mirrored);
        }
    }
}

bool has_texture_attributes(const DrawnObject& object)
{
    return object.tangents != nullptr || !object.mesh->texcoords[0].empty() ||
           !object.mesh->texcoords[1].empty();
}

// Primitive ids count through the objects in the order of Object::id.
std::vector<std::uint32_t> number_primitives(const Scene& scene, const DrawnObjects& drawn)
{
    std::vector<std::size_t> order(scene.objects.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return scene.objects[a].id < scene.objects[b].id;
    });
    std::vector<std::uint32_t> first(scene.objects.size());
    std::uint64_t next = 0;
    for (const std::size_t i : order) {
        first[i] = static_cast<std::uint32_t>(next);
        next += drawn[i].mesh->indices.size() / 3;
    }
    constexpr std::uint64_t kMost = 0x7ffffffe;  // methods compare ids as signed integers
    if (next > kMost) {
        throw Error(Fault::input, "the scene has more than 2,147,483,646 triangles");
    }
    return first;
}

}  // namespace

ScreenMap::ScreenMap(const Projection& projection, int width, int height)
    : orthographic(projection.orthographic),
      scale_x(static_cast<float>(projection.scale_x)),
      scale_y(static_cast<float>(projection.scale_y)),
      half_width(0.5f * kSubpixels * static_cast<float>(width)),
      half_height(0.5f * kSubpixels * static_cast<float>(height)),
      near_depth(orthographic ? static_cast<float>(projection.znear)
                              : std::max(static_cast<float>(projection.znear), 1e-18f)),
      far_depth(projection.zfar > 0 ? static_cast<float>(projection.zfar)
                                    : std::numeric_limits<float>::infinity())
{
}

void snap_vertex(PosedVertex& v, const ScreenMap& map)
{
    // Clipping leaves it inside, but where the cut's own rounding is larger than the picture.
    constexpr float kMost = 8388607.0f;  // 2^23 - 1
    v.screen_x = floor_to_int(std::clamp(screen_x(v.x, v.w, map) + 0.5f, -kMost, kMost));
    v.screen_y = floor_to_int(std::clamp(screen_y(v.y, v.w, map) + 0.5f, -kMost, kMost));
    v.depth = map.orthographic ? v.distance : -1.0f / v.distance;
}

PosedScene pose_scene(const Scene& scene, const DrawnObjects& drawn, const Projection& projection,
                      const ScreenMap& map, int threads)
{
    PosedScene posed;
    struct Range {
        std::size_t object, begin, end;
    };
    std::vector<Range> ranges;
    std::vector<ObjectPose> poses;
    std::size_t total = 0;
    bool textured = false;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const std::size_t count = drawn[i].mesh->positions.size();
        textured = textured || has_texture_attributes(drawn[i]);
        posed.first_vertex.push_back(static_cast<std::uint32_t>(total));
        poses.push_back(pose_object(drawn[i].transform, projection, map));
        posed.normal_to_world.push_back(poses.back().normal);
        posed.mirrored.push_back(poses.back().mirrored);
        for (std::size_t begin = 0; begin < count; begin += kVerticesAtOnce) {
            ranges.push_back({i, begin, std::min(count, begin + kVerticesAtOnce)});
        }
        total += count;
        if (total >= kOwnVertex) {
            throw Error(Fault::input, "the scene has more than 2,147,483,647 vertices");
        }
    }
    posed.first_primitive = number_primitives(scene, drawn);
    posed.vertices.resize(total);
    posed.attributes.resize(total);
    if (textured) posed.texture_attributes.resize(total);
    parallel_for(threads, ranges.size(), [&](std::size_t i, int) {
        const Range& r = ranges[i];
        const std::size_t first = posed.first_vertex[r.object];
        pose_range(*drawn[r.object].mesh, poses[r.object], map, r.begin, r.end,
                   posed.vertices.data() + first, posed.attributes.data() + first);
        if (has_texture_attributes(drawn[r.object])) {
            pose_texture_range(drawn[r.object], poses[r.object].mirrored, r.begin, r.end,
                               posed.texture_attributes.data() + first);
        }
    });
    return posed;
}

}  // namespace sheer
