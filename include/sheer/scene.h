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

#include <sheer/image.h>

namespace sheer {

using Float2 = std::array<float, 2>;
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

// A picture for textures as its file has it: 8 bits a channel, straight alpha, rows from the top.
struct TextureImage {
    std::string name;
    int width = 0;  // texels, 1 to kMaxImageSize
    int height = 0;
    std::vector<std::array<std::uint8_t, 4>> texels;  // width * height, row by row
};

// What coordinates outside of [0, 1] mean.
enum class Wrap { repeat, mirrored_repeat, clamp_to_edge };

enum class TexelFilter { nearest, linear };
enum class MipFilter { none, nearest, linear };

// glTF 2.0, sampler.
struct Sampler {
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    TexelFilter magnify = TexelFilter::linear;
    TexelFilter minify = TexelFilter::linear;
    MipFilter mip = MipFilter::linear;
};

// A material's use of an image. Coordinates (u, v) are (0, 0) at the image's top left corner and
// (1, 1) at its bottom right one.
struct Texture {
    std::uint32_t image = 0;  // index into Scene::images
    Sampler sampler;
    std::uint32_t set = 0;  // of the mesh's texture coordinates: 0 or 1
    // Of the coordinates, before wrapping: u' = t[0] u + t[1] v + t[2], v' = t[3] u + t[4] v +
    // t[5].
    std::array<float, 6> transform = {1, 0, 0, 0, 1, 0};
};

enum class Shading {
    unlit,               // the colour is the radiance
    diffuse,             // Lambert
    metallic_roughness,  // glTF 2.0, appendix B
};

// Factors multiply what the textures hold. docs/numerics.md has the formulas.
struct Material {
    std::string name;
    Shading shading = Shading::diffuse;
    Float3 base_color = {1, 1, 1};  // linear, straight; multiplied by the vertex colour
    float opacity = 1;              // in [0, 1]; multiplied by the vertex colour's alpha
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;    // used by AlphaMode::mask alone
    bool double_sided = false;    // false: triangles seen from behind are not drawn
    float metallic = 0;           // in [0, 1]; Shading::metallic_roughness alone
    float roughness = 1;          // in [0, 1]; perceptual: its square is the slopes' deviation
    Float3 emission = {0, 0, 0};  // linear radiance that is added
    // In [0, 1]: the part of the light not reflected that goes straight through, coloured by the
    // base colour (KHR_materials_transmission); above 0 the surface is transparent in every mode.
    float transmission = 0;
    float normal_scale = 1;  // of the normal texture's x and y

    std::optional<Texture> base_color_texture;          // sRGB, alpha is opacity
    std::optional<Texture> metallic_roughness_texture;  // linear: roughness in g, metallic in b
    std::optional<Texture> normal_texture;              // linear, tangent space, y up
    std::optional<Texture> emission_texture;            // sRGB
    std::optional<Texture> transmission_texture;        // linear, in r
};

enum class Topology {
    triangles,  // counter-clockwise seen from the front
    lines,      // drawn as ribbons that face the camera
    points,     // drawn as squares that face the camera
};

struct Mesh {
    std::string name;
    std::vector<Float3> positions;
    std::vector<Float3> normals;  // one for each position, or empty: flat, from the triangle; for
                                  // lines and points facing the camera
    std::vector<Float4> colors;   // one for each position, linear straight RGBA, or empty: white
    std::vector<Float2> texcoords[2];  // two sets, each one for each position, or empty: (0, 0)
    // One for each position, or empty: made from the normal texture's set of coordinates. Unit
    // length; w is 1 or -1, the side of the bitangent cross(normal, tangent) w.
    std::vector<Float4> tangents;
    Topology topology = Topology::triangles;
    // Three for each triangle, two for each piece of a line, one for each point. Pieces that follow
    // one another and share a vertex are joined.
    std::vector<std::uint32_t> indices;
    // Of lines and points: metres across in the object's own space; 0: kDefaultLineWidth pixels.
    float width = 0;
    std::uint32_t material = 0;
};

inline constexpr float kDefaultLineWidth = 1.5f;  // pixels

// What a file puts objects below: a machine's part, a tree's branch.
struct Group {
    std::string name;
    std::int32_t parent = -1;  // in Scene::groups, before this one; -1: none
};

struct Object {
    std::string name;
    std::uint32_t mesh = 0;
    Mat4 transform = kIdentity;  // object to world; the last row is 0 0 0 1
    // Stable identity. Ties in depth are broken by it (the smaller is in front), then by the
    // triangle's number in the mesh; the order of Scene::objects is the order of submission only.
    // No two objects of a scene share one.
    std::uint32_t id = 0;
    // In [0, 1]; below 1 the object is drawn as AlphaMode::blend would be, its opacity multiplied
    // by this: for x-ray views of what is opaque.
    float opacity = 1;
    std::int32_t group = -1;  // in Scene::groups; -1: none
    // Object to the space of the whole that it is a part of, which moves as one: there hashed alpha
    // tests have their noise, which so moves with it. None: the scene is the whole, `transform`.
    std::optional<Mat4> to_whole = std::nullopt;
    // Instead of the mesh's, so that objects can share a mesh that differ in these alone;
    // `material` in Scene::materials.
    std::optional<std::uint32_t> material = std::nullopt;
    std::optional<std::string> mesh_name = std::nullopt;
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

enum class LightKind { directional, point, spot };

// KHR_lights_punctual.
struct Light {
    LightKind kind = LightKind::point;
    Float3 position = {0, 0, 0};    // world space; point and spot
    Float3 direction = {0, 0, -1};  // the way the light goes, world space, unit length
    // Directional: irradiance of a surface that faces it. Point, spot: that at one metre.
    Float3 intensity = {1, 1, 1};
    float range = 0;                // metres from where on there is no light; 0: endless
    float inner_cone = 0;           // spot: radians from the axis, full light within
    float outer_cone = 0.7853982f;  // and none beyond; inner < outer <= pi / 2
};

struct Scene {
    std::vector<TextureImage> images;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Object> objects;  // in the order of submission
    std::vector<Camera> cameras;
    Sun sun;
    Sky sky;
    std::vector<Light> lights;
    std::optional<Float4> background;  // linear, premultiplied; a view's own background wins
    std::vector<std::string> ignored;  // what the reader found and does not draw, one line each
    std::vector<Group> groups;         // looked at by set_opacity alone
};

// What an object of the scene is made of: its number in Scene::materials, and that material.
inline std::uint32_t material_number(const Scene& scene, const Object& object)
{
    return object.material.value_or(scene.meshes[object.mesh].material);
}
inline const Material& material_of(const Scene& scene, const Object& object)
{
    return scene.materials[material_number(scene, object)];
}

inline const std::string& mesh_name(const Scene& scene, const Object& object)
{
    return object.mesh_name ? *object.mesh_name : scene.meshes[object.mesh].name;
}

}  // namespace sheer
