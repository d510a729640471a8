// What the geometry stage hands on: triangles that are posed, clipped and snapped to the 1/256
// pixel grid. The rasteriser and the reference both start from here, so that they speak of the same
// surfaces to the last bit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sheer/scene.h>

#include "support/unfilled.h"

namespace sheer {

inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixels = 1 << kSubpixelBits;  // steps of the grid in one pixel

struct Attributes {
    Float3 normal;  // world space, not normalised; perspective-correct like the colour
    Float4 color;   // vertex colour, linear straight RGBA
};

// What a surface's points are named by, for what is to stay on it: where they are in the whole that
// the object is part of (Object::to_whole) or in the world, or their first texture coordinates.
enum class PlaceSpace { object, world, texture };
inline constexpr std::size_t kPlaceSpaces = 3;
using PlaceSpaces = std::array<bool, kPlaceSpaces>;  // those that are wanted, by PlaceSpace

// Of meshes with texture coordinates.
struct TextureAttributes {
    Float2 texcoords[2];
    // World space, unit length or zero before interpolation; w: the side of the bitangent
    // cross(normal, tangent) w, negated already in mirrored objects.
    Float4 tangent;
};

// One triangle on the screen. With (x, y) to the right and down, vertices 0, 1, 2 turn so that
//   twice_area = (x1 - x0) (y2 - y0) - (x2 - x0) (y1 - y0)  >  0
// whichever side is seen. It fills a cache line: tiles read triangles from all over the memory.
struct alignas(64) Triangle {
    std::int32_t x[3], y[3];  // 1/256 pixel from the picture's top left corner, |x|, |y| < 2^23
    // Affine on the screen and growing away from the eye: -1/w (w: distance along the axis of view)
    // under a perspective camera, that distance itself under an orthographic one.
    float depth[3];
    std::uint32_t vertex[3];    // see Geometry::attributes_of
    std::uint32_t primitive;    // stable identity of the source triangle; pieces of a clip share it
    std::uint32_t object : 31;  // index into Scene::objects
    std::uint32_t back_facing : 1;  // seen from behind: the normal is to be turned
};

// Least and greatest sample coordinates in a pixel, subpixels: a triangle between samples is
// dropped.
struct SampleExtent {
    int x_min = 0, x_max = 0, y_min = 0, y_max = 0;
};

// Triangles in their order of submission, cut into chunks that were made independently.
struct TriangleChunk {
    UnfilledVector<Triangle> triangles;
    std::vector<Attributes> own;  // of vertices that clipping made, and of flat triangles
    std::vector<TextureAttributes> own_texture_attributes;     // like `own`, or empty
    std::array<std::vector<Float3>, kPlaceSpaces> own_places;  // likewise
    // Triangles that touch tile t: tile_triangles[tile_begin[t] .. tile_begin[t + 1]), in order.
    std::vector<std::uint32_t> tile_begin;
    std::vector<std::uint32_t> tile_triangles;
};

// High bit of Triangle::vertex: an index into its chunk's `own`; else into
// Geometry::attributes.
inline constexpr std::uint32_t kOwnVertex = 0x80000000u;

// Where the scene is seen from: with it a point of the screen and its depth are a place in the
// world. View space is scale_x, scale_y times smaller than the picture's -1 to 1 (scene/camera.h).
struct Eye {
    bool orthographic = false;
    double position[3] = {}, right[3] = {}, up[3] = {}, back[3] = {};  // world space, unit axes
    double scale_x = 1, scale_y = 1;
    int width = 0, height = 0;  // of the picture
};

struct Geometry {
    UnfilledVector<Attributes> attributes;
    // Like `attributes`; empty where no mesh has texture coordinates.
    std::vector<TextureAttributes> texture_attributes;
    // Like `attributes`; empty in spaces that are not wanted.
    std::array<std::vector<Float3>, kPlaceSpaces> places;
    std::vector<TriangleChunk> chunks;
    bool orthographic = false;
    Eye eye;
    std::uint64_t submitted = 0;  // triangles of the scene's objects, before culling

    const Attributes& attributes_of(const TriangleChunk& chunk, std::uint32_t vertex) const
    {
        return (vertex & kOwnVertex) != 0 ? chunk.own[vertex & ~kOwnVertex] : attributes[vertex];
    }
    TextureAttributes texture_attributes_of(const TriangleChunk& chunk, std::uint32_t vertex) const
    {
        if (texture_attributes.empty()) return {};
        return (vertex & kOwnVertex) != 0 ? chunk.own_texture_attributes[vertex & ~kOwnVertex]
                                          : texture_attributes[vertex];
    }
    // In a space that is wanted.
    const Float3& place_of(PlaceSpace space, const TriangleChunk& chunk, std::uint32_t vertex) const
    {
        const auto s = static_cast<std::size_t>(space);
        return (vertex & kOwnVertex) != 0 ? chunk.own_places[s][vertex & ~kOwnVertex]
                                          : places[s][vertex];
    }
};

}  // namespace sheer
