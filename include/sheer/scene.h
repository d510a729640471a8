// A scene as plain data: meshes, the objects that place them, materials, cameras and lights.
//
// glTF's space: right-handed, y up, metres; a camera looks along its own -z. Colours are linear and
// straight (not multiplied by opacity) here, as their authors write them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sheer {

using Float3 = std::array<float, 3>;
using Float4 = std::array<float, 4>;
using Mat4 = std::array<float, 16>;  // column-major, as in glTF

inline constexpr Mat4 kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

// glTF 2.0, material.alphaMode.
enum class AlphaMode {
    opaque,  // opacity is ignored
    mask,    // opaque where opacity >= alpha_cutoff, absent elsewhere
    blend,   // transparent: these surfaces are what the methods are about
};

struct Material {
    std::string name;
    Float3 base_color = {1, 1, 1};  // linear, straight; multiplied by the vertex colour
    float opacity = 1;              // in [0, 1]; multiplied by the vertex colour's alpha
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;  // used by AlphaMode::mask alone
    bool double_sided = false;  // false: triangles seen from behind are not drawn
    bool unlit = false;         // true: the colour is the radiance
};

struct Mesh {
    std::string name;
    std::vector<Float3> positions;
    std::vector<Float3> normals;  // one for each position, or empty: flat, from the triangle
    std::vector<Float4> colors;   // one for each position, linear straight RGBA, or empty: white
    std::vector<std::uint32_t>
        indices;  // three for each triangle, counter-clockwise seen from the front
    std::uint32_t material = 0;
};

struct Object {
    std::string name;
    std::uint32_t mesh = 0;
    Mat4 transform = kIdentity;  // object to world; the last row is 0 0 0 1
    // Stable identity. Ties in depth are broken by it (the smaller is in front), then by the
    // triangle's number in the mesh; the order of Scene::objects is the order of submission only.
    // No two objects of a scene share one.
    std::uint32_t id = 0;
};

struct Camera {
    std::string name;
    Mat4 transform = kIdentity;  // camera to world, rigid
    bool orthographic = false;
    float yfov = 0.8f;   // perspective: full vertical angle in radians, in (0, pi)
    float aspect = 0;    // perspective: width / height the camera was made for; 0: the picture's.
    float xmag = 1;      // orthographic: half the width of the view, metres
    float ymag = 1;      // orthographic: half the height
    float znear = 0.1f;  // > 0 for perspective
    float zfar = 0;      // 0: no far plane
};

struct Sun {
    Float3 to_light = {0.36f, 0.80f, 0.48f};  // world space, unit length
    Float3 color = {0.78f, 0.76f, 0.72f};     // radiance of a white Lambertian surface facing it
};

struct Sky {
    // Radiance of a white Lambertian surface that faces up and down; between them by the normal's
    // y.
    Float3 up = {0.34f, 0.37f, 0.42f};
    Float3 down = {0.16f, 0.15f, 0.14f};
};

struct Scene {
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Object> objects;  // in the order of submission
    std::vector<Camera> cameras;
    Sun sun;
    Sky sky;
    std::optional<Float4> background;  // linear, premultiplied; a view's own background wins
    std::vector<std::string> ignored;  // what the reader found and does not draw, one line each
};

}  // namespace sheer
