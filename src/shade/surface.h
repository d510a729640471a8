// What shading needs to know of materials, textures and lights, prepared once a frame.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include <sheer/render.h>
#include <sheer/scene.h>

#include "geometry/triangles.h"
#include "shade/mip_chain.h"
#include "shade/shadow_map.h"

namespace sheer {

struct PreparedTexture {
    const MipChain* mips;
    Sampler sampler;
    std::uint32_t set;
    std::array<float, 6> transform;
    bool straight = false;  // colours are not multiplied by alpha
};

// What a material has beyond a colour under the sun and the sky.
struct MaterialDetail {
    Shading shading;
    float metallic, roughness, transmission, normal_scale;
    Float3 emission;  // times 2^exposure
    std::optional<PreparedTexture> base_color, metallic_roughness, normal, emission_map,
        transmission_map;
};

// One for each object of the scene.
struct Surface {
    Float3 color;  // straight; times 2^exposure where there is no `detail`
    float opacity;
    float alpha_cutoff;
    AlphaMode alpha_mode;
    Shading shading;
    bool has_vertex_colors;
    std::uint32_t id;  // Object::id
    // Goes to the methods; else it is drawn first, opaque.
    bool transparent = false;
    bool may_vanish = false;  // some of its fragments may have no opacity
    float object_opacity = 1;
    std::uint32_t material = 0;              // index into FrameSurfaces::details
    const MaterialDetail* detail = nullptr;  // null: `color` and `opacity` are all
    FacingShape facing = {};                 // of lines and points
    Conservative conservative = Conservative::off;
    bool at_samples = false;  // shaded at each for itself
};

// Transparent, and not so much that nothing is left. What passes a mask counts as opaque.
inline bool is_seen_through(const Surface& s)
{
    return s.transparent && s.object_opacity > 0 &&
           (s.alpha_mode == AlphaMode::mask || s.opacity > 0);
}

// A light, its colours times 2^exposure.
struct PreparedLight {
    LightKind kind;
    double place[3];   // relative to the eye, world axes; point and spot
    Float3 to_light;   // directional; of a spot: against its axis
    Float3 intensity;  // irradiance, at one metre for point and spot
    float inverse_range;
    float outer_cosine, inverse_cone;  // spot: its edge, and 1 / (cosine within - cosine at it)
};

// Radiance of a white Lambertian surface of normal n:
// sky_mean + sky_slope n_y + sun max(0, n . to_light)
struct Lighting {
    Float3 to_light, sun, sky_mean, sky_slope;
    float gain = 1;                         // 2^exposure
    std::vector<PreparedLight> lights;      // the sun is not one of them
    const LightShadows* shadows = nullptr;  // null: nothing casts a shadow
};

// A scene's materials and light for one frame; points into itself.
struct FrameSurfaces {
    std::vector<Surface> surfaces;  // one for each object
    Lighting light;
    std::deque<MipChain> textures;
    std::vector<std::optional<MaterialDetail>> details;  // one for each material
    std::vector<float> distances;  // of each object's centre, for Submission::objects_sorted
    bool any_opaque = false;
    bool any_colored = false;  // fragments have a transmittance of their own for each channel

    FrameSurfaces() = default;
    FrameSurfaces(FrameSurfaces&&) = default;
    FrameSurfaces& operator=(FrameSurfaces&&) = default;
};

// By lights or by the sky.
enum class Shadowed { no, yes };

// How textures are made ready; as the view has it.
struct TextureMips {
    AlphaMips alpha = AlphaMips::premultiplied;
    int levels = 0;
};

// What is not drawn by fragments of covered samples; as the view has it.
struct FragmentKinds {
    Conservative conservative = Conservative::off;
    bool at_samples = false;
};

struct SurfaceJob {
    const Scene& scene;
    float exposure;
    const Eye& eye;
    int threads;
    Shadowed shadowed = Shadowed::no;  // or places count, not only normals
    TextureMips mips = {};
    FragmentKinds kinds = {};
};
FrameSurfaces make_surfaces(const SurfaceJob& job);

// Of textures, at most: while make_surfaces runs on as many threads.
std::uint64_t texture_bytes(const Scene& scene, int threads, const TextureMips& mips);

// The same surfaces as light meets them: of each no more than what passes through it, and nothing
// of unlit ones. Points into `seen`.
FrameSurfaces make_casters(const FrameSurfaces& seen);

}  // namespace sheer
