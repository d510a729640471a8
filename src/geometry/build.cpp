// Chunks of an object's triangles, each culled, clipped, set up and binned on its own, so that the
// result is the same for any number of threads.
#include "geometry/build.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/bins.h"
#include "geometry/clip.h"
#include "geometry/drawn_objects.h"
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
    const DrawnObjects& drawn;
    const ScreenMap& map;
    const PosedScene& posed;
};

std::int64_t twice_area(const PosedVertex& v0, const PosedVertex& v1, const PosedVertex& v2)
{
    return std::int64_t{v1.screen_x - v0.screen_x} * (v2.screen_y - v0.screen_y) -
           std::int64_t{v2.screen_x - v0.screen_x} * (v1.screen_y - v0.screen_y);
}

// A chunk while it is made.
struct NewChunk {
    TriangleChunk& chunk;
    TriangleBins bins;
};

// Culls what faces away or lies between the samples; turns the rest to positive area.
void add_triangle(const Context& context, const Corner (&corners)[3], std::uint32_t primitive,
                  std::size_t object, NewChunk& made)
{
    const PosedVertex &v0 = *corners[0].posed, &v1 = *corners[1].posed, &v2 = *corners[2].posed;
    const std::int64_t area = twice_area(v0, v1, v2);
    if (area == 0) return;
    // Counter-clockwise with y up is clockwise with y down.
    const bool front = (area < 0) != context.posed.mirrored[object];
    if (!front && !context.drawn[object].double_sided) return;
    const int order[3] = {0, area > 0 ? 1 : 2, area > 0 ? 2 : 1};
    // In its place: a copy as a whole would wait for each of its parts to be written.
    UnfilledVector<Triangle>& triangles = made.chunk.triangles;
    Triangle& t = triangles.emplace_back();
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
    const bool seen = b.x0 <= b.x1 && b.y0 <= b.y1 && b.x1 >= 0 && b.y1 >= 0 && b.x0 < grid.width &&
                      b.y0 < grid.height;
    if (seen) {
        made.bins.add(t, b, static_cast<std::uint32_t>(triangles.size() - 1));
    } else {
        triangles.pop_back();
    }
}

// A triangle of the scene: its posed vertices and where their attributes are.
struct SourceTriangle {
    Corner corners[3];
    std::uint32_t posed_vertex[3];  // Corner::vertex before a flat triangle gets its own
    std::uint32_t primitive;
    std::size_t object;
};

const Attributes& attributes_of(const Context& context, const TriangleChunk& chunk,
                                std::uint32_t vertex)
{
    return (vertex & kOwnVertex) != 0 ? chunk.own[vertex & ~kOwnVertex]
                                      : context.posed.attributes[vertex];
}

Attributes mix(const Context& context, const SourceTriangle& t, const TriangleChunk& chunk,
               const std::array<float, 3>& weight)
{
    Attributes mixed{{0, 0, 0}, {0, 0, 0, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
        const Attributes& a = attributes_of(context, chunk, t.corners[i].vertex);
        for (std::size_t c = 0; c < 3; ++c) mixed.normal[c] += weight[i] * a.normal[c];
        for (std::size_t c = 0; c < 4; ++c) mixed.color[c] += weight[i] * a.color[c];
    }
    return mixed;
}

TextureAttributes mix_texture_attributes(const Context& context, const SourceTriangle& t,
                                         const std::array<float, 3>& weight)
{
    TextureAttributes mixed{};
    for (std::size_t i = 0; i < 3; ++i) {
        const TextureAttributes& a = context.posed.texture_attributes[t.posed_vertex[i]];
        for (std::size_t set = 0; set < 2; ++set) {
            for (std::size_t c = 0; c < 2; ++c) {
                mixed.texcoords[set][c] += weight[i] * a.texcoords[set][c];
            }
        }
        for (std::size_t c = 0; c < 3; ++c) mixed.tangent[c] += weight[i] * a.tangent[c];
    }
    // The side of a triangle is that of its first vertex.
    mixed.tangent[3] = context.posed.texture_attributes[t.posed_vertex[0]].tangent[3];
    return mixed;
}

// In each space that is wanted.
void add_own_places(const Context& context, const SourceTriangle& t,
                    const std::array<float, 3>& weight, TriangleChunk& chunk)
{
    for (std::size_t space = 0; space < kPlaceSpaces; ++space) {
        const std::vector<Float3>& places = context.posed.places[space];
        if (places.empty()) continue;
        Float3 mixed{0, 0, 0};
        for (std::size_t i = 0; i < 3; ++i) {
            const Float3& p = places[t.posed_vertex[i]];
            for (std::size_t c = 0; c < 3; ++c) mixed[c] += weight[i] * p[c];
        }
        chunk.own_places[space].push_back(mixed);
    }
}

void add_clipped(const Context& context, const SourceTriangle& t, NewChunk& made)
{
    TriangleChunk& chunk = made.chunk;
    const ClippedPolygon polygon =
        clip_triangle(*t.corners[0].posed, *t.corners[1].posed, *t.corners[2].posed, context.map);
    if (polygon.count == 0) return;
    const auto first = static_cast<std::uint32_t>(chunk.own.size()) | kOwnVertex;
    for (int i = 0; i < polygon.count; ++i) {
        const auto& weight = polygon.vertices[static_cast<std::size_t>(i)].weight;
        chunk.own.push_back(mix(context, t, chunk, weight));
        if (!context.posed.texture_attributes.empty()) {
            chunk.own_texture_attributes.push_back(mix_texture_attributes(context, t, weight));
        }
        add_own_places(context, t, weight, chunk);
    }
    const auto at = [&](int k) {
        return Corner{&polygon.vertices[static_cast<std::size_t>(k)].posed,
                      first + static_cast<std::uint32_t>(k)};
    };
    std::int64_t whole = 0;
    for (int i = 2; i < polygon.count; ++i) {
        whole += twice_area(*at(0).posed, *at(i - 1).posed, *at(i).posed);
    }
    for (int i = 2; i < polygon.count; ++i) {
        const Corner corners[3] = {at(0), at(i - 1), at(i)};
        // Snapping may fold a sliver's corner over; the piece would face the other way.
        const std::int64_t part = twice_area(*at(0).posed, *at(i - 1).posed, *at(i).posed);
        if ((part < 0) == (whole < 0)) {
            add_triangle(context, corners, t.primitive, t.object, made);
        }
    }
}

// Of length 1 whatever the triangle's size; zero where it has none.
Float3 flat_normal(const Float3& p0, const Float3& p1, const Float3& p2)
{
    double a[3], b[3];
    for (std::size_t i = 0; i < 3; ++i) {
        a[i] = static_cast<double>(p1[i]) - static_cast<double>(p0[i]);
        b[i] = static_cast<double>(p2[i]) - static_cast<double>(p0[i]);
    }
    const double n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(length > 0)) return {0, 0, 0};
    return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
            static_cast<float>(n[2] / length)};
}

// glTF 2.0, 3.7.2.1: without normals, flat ones.
void make_flat(const Context& context, const Mesh& mesh, std::size_t triangle, SourceTriangle& t,
               TriangleChunk& chunk)
{
    const std::uint32_t* indices = &mesh.indices[3 * triangle];
    const Float3 normal = context.posed.normal_to_world[t.object](flat_normal(
        mesh.positions[indices[0]], mesh.positions[indices[1]], mesh.positions[indices[2]]));
    for (Corner& corner : t.corners) {
        Attributes own = context.posed.attributes[corner.vertex];
        own.normal = normal;
        corner.vertex = static_cast<std::uint32_t>(chunk.own.size()) | kOwnVertex;
        chunk.own.push_back(own);
    }
    for (std::size_t space = 0; space < kPlaceSpaces; ++space) {
        const std::vector<Float3>& places = context.posed.places[space];
        if (places.empty()) continue;
        for (const std::uint32_t vertex : t.posed_vertex) {
            chunk.own_places[space].push_back(places[vertex]);
        }
    }
    if (context.posed.texture_attributes.empty()) return;
    for (const std::uint32_t vertex : t.posed_vertex) {
        chunk.own_texture_attributes.push_back(context.posed.texture_attributes[vertex]);
    }
}

void add_piece(const Context& context, const Piece& piece, NewChunk& made)
{
    const Scene& scene = context.job.scene;
    const Mesh& mesh = *context.drawn[piece.object].mesh;
    const Material& material = material_of(scene, scene.objects[piece.object]);
    const bool flat = mesh.normals.empty() && material.shading != Shading::unlit;
    const std::uint32_t first_vertex = context.posed.first_vertex[piece.object];
    const std::uint32_t first_primitive = context.posed.first_primitive[piece.object];
    for (std::size_t i = piece.begin; i < piece.end; ++i) {
        SourceTriangle t;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = first_vertex + mesh.indices[3 * i + k];
            t.corners[k] = {&context.posed.vertices[vertex], vertex};
            t.posed_vertex[k] = vertex;
        }
        const std::uint32_t outside[3] = {t.corners[0].posed->outside, t.corners[1].posed->outside,
                                          t.corners[2].posed->outside};
        const std::uint32_t crossed = outside[0] | outside[1] | outside[2];
        if ((outside[0] & outside[1] & outside[2]) != 0 || (crossed & kNowhere) != 0) continue;
        t.primitive = first_primitive + static_cast<std::uint32_t>(i);
        t.object = piece.object;
        if (flat) make_flat(context, mesh, i, t, made.chunk);
        if (crossed != 0) {
            add_clipped(context, t, made);
        } else {
            add_triangle(context, t.corners, t.primitive, t.object, made);
        }
    }
}

// Runs of objects and parts of objects, in order of submission, of about the same size.
std::vector<std::vector<Piece>> cut_into_pieces(const DrawnObjects& drawn, std::uint64_t triangles)
{
    const std::size_t most =
        std::max(kTrianglesAtOnce, static_cast<std::size_t>(triangles) / kMostChunks + 1);
    std::vector<std::vector<Piece>> chunks;
    std::size_t room = 0;
    for (std::size_t object = 0; object < drawn.size(); ++object) {
        const std::size_t count = drawn[object].mesh->indices.size() / 3;
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

Eye make_eye(const GeometryJob& job)
{
    const Projection& p = job.projection;
    Eye eye{p.orthographic, {}, {}, {}, {}, p.scale_x, p.scale_y, job.grid.width, job.grid.height};
    for (std::size_t i = 0; i < 3; ++i) {
        eye.position[i] = p.eye[i];
        eye.right[i] = p.world_to_view[4 * i];
        eye.up[i] = p.world_to_view[4 * i + 1];
        eye.back[i] = p.world_to_view[4 * i + 2];
    }
    return eye;
}

}  // namespace

Geometry build_geometry(const GeometryJob& job)
{
    const ScreenMap map(job.projection, job.grid.width, job.grid.height);
    const DrawnObjects drawn(job.scene, job.projection,
                             job.line_rows > 0 ? job.line_rows : job.grid.height);
    PosedScene posed = pose_scene(job.scene, drawn, job.projection, map, job.threads);
    pose_places(job.scene, drawn, job.places, posed);
    Geometry geometry;
    geometry.orthographic = job.projection.orthographic;
    geometry.eye = make_eye(job);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        geometry.submitted += drawn[i].mesh->indices.size() / 3;
    }
    const auto chunks = cut_into_pieces(drawn, geometry.submitted);
    geometry.chunks.resize(chunks.size());
    const Context context{job, drawn, map, posed};
    parallel_for(job.threads, chunks.size(), [&](std::size_t i, int) {
        std::size_t triangles = 0;
        for (const Piece& piece : chunks[i]) triangles += piece.end - piece.begin;
        NewChunk made{geometry.chunks[i], TriangleBins(job.grid, triangles)};
        made.chunk.triangles.reserve(triangles);
        for (const Piece& piece : chunks[i]) add_piece(context, piece, made);
        made.bins.write(made.chunk);
    });
    geometry.attributes = std::move(posed.attributes);
    geometry.texture_attributes = std::move(posed.texture_attributes);
    geometry.places = std::move(posed.places);
    return geometry;
}

}  // namespace sheer
