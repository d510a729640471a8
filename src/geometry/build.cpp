// Chunks of an object's triangles, each culled, clipped, set up and binned on its own, so that the
// result is the same for any number of threads.
#include "geometry/build.h"

#include <algorithm>
#include <utility>

#include "geometry/bins.h"
#include "geometry/clip.h"
#include "geometry/pose.h"
#include "geometry/screen_bounds.h"
#include "support/parallel.h"

namespace sheer {

namespace {

// Large enough to share the work of binning, small enough to share it among threads. Above this
// many chunks they grow instead: each holds an index over all tiles.
constexpr std::size_t kTrianglesAtOnce = 4096;
constexpr std::size_t kMostChunks = 512;

struct Piece {
    std::size_t object, begin, end;  // triangles of the object's mesh
};

struct Corner {
    const PosedVertex* posed;
    std::uint32_t vertex;  // Triangle::vertex
};

struct Context {
    const GeometryJob& job;
    const ScreenMap& map;
    const PosedScene& posed;
};

// Culls what faces away or lies between the samples; turns the rest to positive area.
void add_triangle(const Context& context, const Corner (&corners)[3], std::uint32_t primitive,
                  std::size_t object, TriangleChunk& chunk)
{
    const Scene& scene = context.job.scene;
    const PosedVertex &v0 = *corners[0].posed, &v1 = *corners[1].posed, &v2 = *corners[2].posed;
    const std::int64_t area =
        std::int64_t{v1.screen_x - v0.screen_x} * (v2.screen_y - v0.screen_y) -
        std::int64_t{v2.screen_x - v0.screen_x} * (v1.screen_y - v0.screen_y);
    if (area == 0) return;
    // Counter-clockwise with y up is clockwise with y down.
    const bool front = (area < 0) != context.posed.mirrored[object];
    if (!front) {
        const Mesh& mesh = scene.meshes[scene.objects[object].mesh];
        if (!scene.materials[mesh.material].double_sided) return;
    }
    const int order[3] = {0, area > 0 ? 1 : 2, area > 0 ? 2 : 1};
    Triangle t;
    for (int i = 0; i < 3; ++i) {
        const Corner& c = corners[order[i]];
        t.x[i] = c.posed->screen_x;
        t.y[i] = c.posed->screen_y;
        t.depth[i] = c.posed->depth;
        t.vertex[i] = c.vertex;
    }
    t.primitive = primitive;
    t.object = static_cast<std::uint32_t>(object) & 0x7fffffffu;
    t.back_facing = front ? 0 : 1;
    const PixelBounds b = pixel_bounds(t, context.job.samples);
    const TileGrid& grid = context.job.grid;
    if (b.x0 > b.x1 || b.y0 > b.y1 || b.x1 < 0 || b.y1 < 0 || b.x0 >= grid.width ||
        b.y0 >= grid.height) {
        return;
    }
    chunk.triangles.push_back(t);
}

Attributes mix(const Context& context, const std::uint32_t (&vertices)[3],
               const std::array<float, 3>& weight)
{
    Attributes mixed{{0, 0, 0}, {0, 0, 0, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
        const Attributes& a = context.posed.attributes[vertices[i]];
        for (std::size_t c = 0; c < 3; ++c) mixed.normal[c] += weight[i] * a.normal[c];
        for (std::size_t c = 0; c < 4; ++c) mixed.color[c] += weight[i] * a.color[c];
    }
    return mixed;
}

void add_clipped(const Context& context, const std::uint32_t (&vertices)[3],
                 std::uint32_t primitive, std::size_t object, TriangleChunk& chunk)
{
    const std::vector<PosedVertex>& posed = context.posed.vertices;
    const ClippedPolygon polygon =
        clip_triangle(posed[vertices[0]], posed[vertices[1]], posed[vertices[2]], context.map);
    if (polygon.count == 0) return;
    const auto first = static_cast<std::uint32_t>(chunk.clipped.size()) | kClippedVertex;
    for (int i = 0; i < polygon.count; ++i) {
        chunk.clipped.push_back(
            mix(context, vertices, polygon.vertices[static_cast<std::size_t>(i)].weight));
    }
    for (int i = 2; i < polygon.count; ++i) {
        const auto at = [&](int k) {
            return Corner{&polygon.vertices[static_cast<std::size_t>(k)].posed,
                          first + static_cast<std::uint32_t>(k)};
        };
        const Corner corners[3] = {at(0), at(i - 1), at(i)};
        add_triangle(context, corners, primitive, object, chunk);
    }
}

void add_piece(const Context& context, const Piece& piece, TriangleChunk& chunk)
{
    const Scene& scene = context.job.scene;
    const Mesh& mesh = scene.meshes[scene.objects[piece.object].mesh];
    const std::uint32_t first_vertex = context.posed.first_vertex[piece.object];
    const std::vector<PosedVertex>& posed = context.posed.vertices;
    chunk.triangles.reserve(piece.end - piece.begin);
    for (std::size_t i = piece.begin; i < piece.end; ++i) {
        const std::uint32_t vertices[3] = {first_vertex + mesh.indices[3 * i],
                                           first_vertex + mesh.indices[3 * i + 1],
                                           first_vertex + mesh.indices[3 * i + 2]};
        const PosedVertex &v0 = posed[vertices[0]], &v1 = posed[vertices[1]],
                          &v2 = posed[vertices[2]];
        if ((v0.outside & v1.outside & v2.outside) != 0) continue;
        const std::uint32_t primitive =
            context.posed.first_primitive[piece.object] + static_cast<std::uint32_t>(i);
        if ((v0.outside | v1.outside | v2.outside) != 0) {
            add_clipped(context, vertices, primitive, piece.object, chunk);
            continue;
        }
        const Corner corners[3] = {{&v0, vertices[0]}, {&v1, vertices[1]}, {&v2, vertices[2]}};
        add_triangle(context, corners, primitive, piece.object, chunk);
    }
}

// Runs of objects and parts of objects, in order of submission, of about the same size.
std::vector<std::vector<Piece>> cut_into_pieces(const Scene& scene, std::uint64_t triangles)
{
    const std::size_t most =
        std::max(kTrianglesAtOnce, static_cast<std::size_t>(triangles) / kMostChunks + 1);
    std::vector<std::vector<Piece>> chunks;
    std::size_t room = 0;
    for (std::size_t object = 0; object < scene.objects.size(); ++object) {
        const std::size_t count = scene.meshes[scene.objects[object].mesh].indices.size() / 3;
        for (std::size_t begin = 0; begin < count;) {
            if (room == 0) {
                chunks.emplace_back();
                room = most;
            }
            const std::size_t end = std::min(count, begin + room);
            chunks.back().push_back({object, begin, end});
            room -= end - begin;
            begin = end;
        }
    }
    return chunks;
}

}  // namespace

Geometry build_geometry(const GeometryJob& job)
{
    const ScreenMap map(job.projection, job.grid.width, job.grid.height);
    PosedScene posed = pose_scene(job.scene, job.projection, map, job.threads);
    Geometry geometry;
    geometry.orthographic = job.projection.orthographic;
    for (const Object& object : job.scene.objects) {
        geometry.submitted += job.scene.meshes[object.mesh].indices.size() / 3;
    }
    const auto chunks = cut_into_pieces(job.scene, geometry.submitted);
    geometry.chunks.resize(chunks.size());
    const Context context{job, map, posed};
    parallel_for(job.threads, chunks.size(), [&](std::size_t i, int) {
        for (const Piece& piece : chunks[i]) add_piece(context, piece, geometry.chunks[i]);
        bin_triangles(geometry.chunks[i], job.grid, job.samples);
    });
    geometry.attributes = std::move(posed.attributes);
    return geometry;
}

}  // namespace sheer
