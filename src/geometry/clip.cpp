// Sutherland and Hodgman. Reentrant Polygon Clipping. CACM 1974. In doubles, in view space.
//
// A cut is always computed from the inside vertex towards the outside one, so that it comes out the
// same for both triangles of an edge.
#include "geometry/clip.h"

namespace sheer {

namespace {

struct Vertex {
    double x, y, distance, w;
    double weight[3];
};

struct Polygon {
    std::array<Vertex, ClippedPolygon::kMost> vertices;
    int count = 0;
};

// >= 0 inside.
double distance_to(Outside plane, const Vertex& v, const ScreenMap& map)
{
    const double x = v.x * static_cast<double>(map.half_width);
    const double y = v.y * static_cast<double>(map.half_height);
    const double limit_x = v.w * static_cast<double>(map.guard_x());
    const double limit_y = v.w * static_cast<double>(map.guard_y());
    switch (plane) {
        case kNear: return v.distance - static_cast<double>(map.near_depth);
        case kFar: return static_cast<double>(map.far_depth) - v.distance;
        case kLeft: return limit_x + x;
        case kRight: return limit_x - x;
        case kTop: return limit_y - y;
        case kBottom: return limit_y + y;
        case kNowhere: break;
    }
    return 0;
}

Vertex between(const Vertex& inside, const Vertex& outside, double t)
{
    Vertex v{inside.x + t * (outside.x - inside.x),
             inside.y + t * (outside.y - inside.y),
             inside.distance + t * (outside.distance - inside.distance),
             inside.w + t * (outside.w - inside.w),
             {}};
    for (int i = 0; i < 3; ++i) {
        v.weight[i] = inside.weight[i] + t * (outside.weight[i] - inside.weight[i]);
    }
    return v;
}

Polygon clip(const Polygon& in, Outside plane, const ScreenMap& map)
{
    Polygon out;
    const auto add = [&](const Vertex& v) {
        out.vertices[static_cast<std::size_t>(out.count++)] = v;
    };
    for (int i = 0; i < in.count; ++i) {
        const Vertex& a = in.vertices[static_cast<std::size_t>(i)];
        const Vertex& b = in.vertices[static_cast<std::size_t>((i + 1) % in.count)];
        const double da = distance_to(plane, a, map), db = distance_to(plane, b, map);
        if (da >= 0) add(a);
        if (da >= 0 && db < 0) add(between(a, b, da / (da - db)));
        if (da < 0 && db >= 0) add(between(b, a, db / (db - da)));
    }
    return out;
}

Vertex start(const PosedVertex& v, int corner)
{
    Vertex r{static_cast<double>(v.x),
             static_cast<double>(v.y),
             static_cast<double>(v.distance),
             static_cast<double>(v.w),
             {0, 0, 0}};
    r.weight[corner] = 1;
    return r;
}

}  // namespace

ClippedPolygon clip_triangle(const PosedVertex& v0, const PosedVertex& v1, const PosedVertex& v2,
                             const ScreenMap& map)
{
    Polygon polygon;
    polygon.vertices[0] = start(v0, 0);
    polygon.vertices[1] = start(v1, 1);
    polygon.vertices[2] = start(v2, 2);
    polygon.count = 3;
    const std::uint32_t crossed = v0.outside | v1.outside | v2.outside;
    // The near plane first: the guard band's planes mean what they say only in front of the eye.
    for (const Outside plane : {kNear, kFar, kLeft, kRight, kTop, kBottom}) {
        if ((crossed & plane) != 0) polygon = clip(polygon, plane, map);
    }
    ClippedPolygon result;
    result.count = polygon.count < 3 ? 0 : polygon.count;
    for (int i = 0; i < result.count; ++i) {
        const Vertex& v = polygon.vertices[static_cast<std::size_t>(i)];
        PosedVertex posed{static_cast<float>(v.x),
                          static_cast<float>(v.y),
                          static_cast<float>(v.w),
                          static_cast<float>(v.distance),
                          0,
                          0,
                          0,
                          0};
        snap_vertex(posed, map);
        result.vertices[static_cast<std::size_t>(i)] = {
            posed,
            {static_cast<float>(v.weight[0]), static_cast<float>(v.weight[1]),
             static_cast<float>(v.weight[2])}};
    }
    return result;
}

}  // namespace sheer
