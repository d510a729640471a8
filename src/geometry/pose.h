// The scene's vertices as the camera sees them.
#pragma once

#include <cstdint>
#include <vector>

#include <sheer/scene.h>

#include "geometry/drawn_objects.h"
#include "geometry/triangles.h"
#include "scene/camera.h"
#include "support/unfilled.h"

namespace sheer {

// From view space to the picture, in 32-bit floats.
struct ScreenMap {
    bool orthographic;
    float scale_x, scale_y;         // view space to [-1, 1] (after division by w)
    float half_width, half_height;  // of the picture, in subpixels
    float near_depth;               // least distance along the axis of view
    float far_depth;                // greatest, or infinity

    // The guard band's half size, from the picture's centre. Coordinates on the screen stay below
    // 2^23 subpixels: sums of two products of their differences then fit the rasteriser's integers.
    static constexpr float kGuardBand = 32000.0f * kSubpixels;
    float guard_x() const { return kGuardBand - half_width; }
    float guard_y() const { return kGuardBand - half_height; }

    ScreenMap(const Projection& projection, int width, int height);
};

// Planes that a vertex is beyond.
enum Outside : std::uint32_t {
    kNear = 1,
    kFar = 2,
    kLeft = 4,  // of the guard band, from here on
    kRight = 8,
    kTop = 16,
    kBottom = 32,
    kNowhere = 64,  // not finite, or so far out that products would not be: the triangle is dropped
};

struct PosedVertex {
    float x, y, w;   // view space, scaled: screen position is (x, y) / w (w = 1: orthographic)
    float distance;  // along the axis of view
    // These three are valid where outside == 0. A vertex at the same place always comes out with
    // the same bits, so shared vertices stay shared.
    float depth;                      // Triangle::depth
    std::int32_t screen_x, screen_y;  // subpixels
    std::uint32_t outside;
};

// Fills in screen_x, screen_y and depth from the rest, for a vertex inside all planes.
void snap_vertex(PosedVertex& v, const ScreenMap& map);

// Turns normals of an object to world space, up to length.
struct NormalMatrix {
    float m[3][3];

    Float3 operator()(const Float3& n) const
    {
        Float3 r;
        for (std::size_t i = 0; i < 3; ++i) {
            r[i] = m[i][0] * n[0] + m[i][1] * n[1] + m[i][2] * n[2];
        }
        return r;
    }
};

struct PosedScene {
    UnfilledVector<PosedVertex> vertices;
    UnfilledVector<Attributes> attributes;                 // of the same vertices
    std::vector<TextureAttributes> texture_attributes;     // likewise, or empty
    std::array<std::vector<Float3>, kPlaceSpaces> places;  // likewise
    std::vector<std::uint32_t> first_vertex;               // of each object
    std::vector<std::uint32_t> first_primitive;  // of each object: primitive ids follow Object::id
    std::vector<NormalMatrix> normal_to_world;   // of each object
    std::vector<bool> mirrored;                  // objects whose transform turns the winding round
};

// Throws Error(Fault::input) when the scene has more than 2^31 vertices or 2^32 triangles.
PosedScene pose_scene(const Scene& scene, const DrawnObjects& drawn, const Projection& projection,
                      const ScreenMap& map, int threads);

// Fills in places of all vertices in the spaces that are wanted.
void pose_places(const Scene& scene, const DrawnObjects& drawn, const PlaceSpaces& wanted,
                 PosedScene& posed);

}  // namespace sheer
